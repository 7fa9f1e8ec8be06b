#include "properties/cases/time_of_impact_case.h"

#include <algorithm>
#include <cmath>

#include "model/input_error.h"
#include "model/limits.h"
#include "oracle/judge/words.h"
#include "oracle/tolerance/motion.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/motion_in_doubles.h"

namespace touchstone::properties {
namespace {

using Status = TimeOfImpact::Status;
namespace words = oracle::words;

const char* name_of(Status status) {
  return status == Status::hit ? "hit" : status == Status::miss ? "miss" : "undecided";
}

double speed(const Scene& pair, double end) {
  double sum = 0;
  for (std::size_t i = 0; i < 2; ++i)
    sum += oracle::tolerance::ballistic(pair, i, end, oracle::Precision::exact).fastest;
  return sum;
}

}  // namespace

double start_of(const Scene& pair) {
  const std::vector<double>& starts = pair.motion->start_times;
  return starts.empty() ? 0 : std::max(starts[0], starts[1]);
}

double end_of(const Scene& scene) { return scene.motion->sample_times.back(); }

// A thousandth of the body: with less error, the shape that remains visible is still the body's.
bool is_decisive(const Body& body, double slack) { return slack * 1024 < size(body.shape); }

bool is_decisive(const Scene& pair, double slack) {
  return is_decisive(pair.bodies[0], slack) && is_decisive(pair.bodies[1], slack);
}

MotionCase::MotionCase(const Scene& pair, oracle::Precision in, const oracle::ContactTolerance& declared)
    : scene(pair),
      precision(in),
      truth(oracle::truth::time_of_impact(pair)),
      start(start_of(pair)),
      end(end_of(pair)),
      granted(oracle::tolerance::granted(pair, declared)),
      slack(granted + oracle::tolerance::moving_distance(pair, truth.status == Status::hit ? truth.time.hi : end, in)),
      moment(slack / speed(pair, end)) {}

bool MotionCase::sure() const { return is_decisive(scene, slack); }

double MotionCase::gap(double time) const {
  const Scene there = oracle::pair_at(scene, time);
  const reference::DistanceTruth& distance = oracle::truth::distance(there);
  return distance.verdict == Verdict::overlapping ? -oracle::judge::margin(there).lo : distance.distance.lo;
}

// Thin bodies that are fast overlap for a short time only: the samples approach the contact by halving their distance
// to it.
double MotionCase::deepest(double until) const {
  if (truth.status != Status::hit || truth.time.hi >= until) return 0;
  double least = std::min(0.0, gap(until));
  for (double after = (until - truth.time.hi) / 2; least >= -slack && after > moment; after /= 2) {
    least = std::min(least, gap(truth.time.hi + after));
  }
  return least;
}

std::optional<double> MotionCase::earliest() const {
  const reference::TimeOfImpactTruth near = oracle::truth::time_of_distance(scene, slack);
  if (near.status == Status::miss) return std::nullopt;
  return near.time.lo;
}

std::optional<double> MotionCase::latest() const {
  if (truth.status != Status::hit) return std::nullopt;
  for (double after = moment; truth.time.hi + after < end; after *= 2) {
    if (gap(truth.time.hi + after) < -slack) return truth.time.hi + after;
  }
  return gap(end) < -slack ? std::optional(end) : std::nullopt;
}

bool is_refused(const Scene& pair) {
  try {
    oracle::truth::time_of_impact(pair);
  } catch (const InputError&) {
    return true;
  }
  const std::vector<double>& starts = pair.motion->start_times;
  if (starts.empty() || starts[0] == starts[1]) return false;  // else the reference has refused it
  return oracle::truth::distance(oracle::pair_at(pair, start_of(pair))).verdict == Verdict::overlapping;
}

std::optional<MotionCase> motion_case(const Scene& pair, oracle::Precision precision,
                                      const oracle::ContactTolerance& declared) {
  if (is_refused(pair)) return std::nullopt;
  return MotionCase(pair, precision, declared);
}

oracle::judge::Allowance in_ulps_of_place(const MotionCase& asked, double bound) {
  oracle::Card card;
  card.precision = asked.precision;
  oracle::judge::Allowance allowance = oracle::judge::in_ulps(asked.scene, card, bound);
  allowance.value = oracle::tolerance::longest_way(asked.scene, end_of(asked.scene));
  return allowance;
}

std::string text(const TimeOfImpact& said) {
  std::string all = name_of(said.status);
  if (said.time) all += " at " + words::text(*said.time) + " s";
  if (said.enclosure) all += ", in " + words::text(*said.enclosure);
  return all;
}

std::string text(const reference::TimeOfImpactTruth& truth) {
  return std::string(name_of(truth.status)) +
         (truth.status == Status::miss ? "" : " in " + words::text(truth.time) + " s");
}

}  // namespace touchstone::properties
