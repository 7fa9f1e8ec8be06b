#include "properties/flight_case.h"

#include <algorithm>
#include <cmath>

#include "model/input_error.h"
#include "model/limits.h"
#include "oracle/flown.h"
#include "oracle/tolerance.h"
#include "oracle/tolerance_motion.h"
#include "oracle/words.h"

namespace touchstone::properties {
namespace {

using Meeting = TimeOfImpact::Meeting;
namespace words = oracle::words;

const char* name_of(Meeting meeting) {
  return meeting == Meeting::hit ? "hit" : meeting == Meeting::miss ? "miss" : "undecided";
}

double speed(const Scene& pair, double end) {
  double sum = 0;
  for (std::size_t i = 0; i < 2; ++i) sum += oracle::tolerance::flight(pair, i, end, oracle::Precision::exact).fastest;
  return sum;
}

}  // namespace

double start_of(const Scene& pair) {
  const std::vector<double>& since = pair.flight->since;
  return since.empty() ? 0 : std::max(since[0], since[1]);
}

double end_of(const Scene& scene) { return scene.flight->times.back(); }

// A thousandth of the body: what is left to see of it is still its shape.
bool tells(const Body& body, double slack) { return slack * 1024 < size(body.shape); }

bool tells(const Scene& pair, double slack) { return tells(pair.bodies[0], slack) && tells(pair.bodies[1], slack); }

FlightCase::FlightCase(const Scene& pair, oracle::Precision in)
    : scene(pair),
      precision(in),
      truth(oracle::truth::time_of_impact(pair)),
      start(start_of(pair)),
      end(end_of(pair)),
      slack(oracle::tolerance::meeting(pair, truth.meeting == Meeting::hit ? truth.time.hi : end, in)),
      moment(slack / speed(pair, end)) {}

bool FlightCase::sure() const { return tells(scene, slack); }

double FlightCase::gap(double time) const {
  const Scene there = oracle::pair_at(scene, time);
  const reference::DistanceTruth& distance = oracle::truth::distance(there);
  return distance.verdict == Verdict::overlapping ? -oracle::judge::margin(there).lo : distance.distance.lo;
}

// Thin bodies that are fast are in each other for a short time: the times' distances from the meeting double.
double FlightCase::deepest(double until) const {
  if (truth.meeting != Meeting::hit || truth.time.hi >= until) return 0;
  double least = std::min(0.0, gap(until));
  for (double after = (until - truth.time.hi) / 2; least >= -slack && after > moment; after /= 2) {
    least = std::min(least, gap(truth.time.hi + after));
  }
  return least;
}

std::optional<double> FlightCase::earliest() const {
  const reference::TimeOfImpactTruth near = oracle::truth::time_of_distance(scene, slack);
  if (near.meeting == Meeting::miss) return std::nullopt;
  return near.time.lo;
}

std::optional<double> FlightCase::latest() const {
  if (truth.meeting != Meeting::hit) return std::nullopt;
  for (double after = moment; truth.time.hi + after < end; after *= 2) {
    if (gap(truth.time.hi + after) < -slack) return truth.time.hi + after;
  }
  return gap(end) < -slack ? std::optional(end) : std::nullopt;
}

std::optional<FlightCase> flight_case(const Scene& pair, oracle::Precision precision) {
  try {
    return FlightCase(pair, precision);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

oracle::judge::Allowance in_ulps_of_place(const FlightCase& asked, double bound) {
  oracle::Card card;
  card.precision = asked.precision;
  return oracle::judge::in_ulps(asked.scene, card, bound);
}

std::string text(const TimeOfImpact& said) {
  std::string all = name_of(said.meeting);
  if (said.time) all += " at " + words::text(*said.time) + " s";
  if (said.enclosure) all += ", in " + words::text(*said.enclosure);
  return all;
}

std::string text(const reference::TimeOfImpactTruth& truth) {
  return std::string(name_of(truth.meeting)) +
         (truth.meeting == Meeting::miss ? "" : " in " + words::text(truth.time) + " s");
}

}  // namespace touchstone::properties
