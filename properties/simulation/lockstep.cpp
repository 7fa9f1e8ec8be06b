// The clause of docs/spec/simulation.md that compares each impact with the reference, restarted from the states that
// the last events reported.
#include <cmath>

#include "model/infinity.h"
#include "model/limits.h"
#include "oracle/judge/words.h"
#include "properties/cases/simultaneous_impacts.h"
#include "properties/cases/time_of_impact_case.h"
#include "properties/cases/trajectory_case.h"
#include "properties/queries.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Subject;
using Status = TimeOfImpact::Status;
namespace judge = oracle::judge;
namespace truth = oracle::truth;

/// s: the earliest time at which the pair comes within `near` (m). A pair that starts this near has usually just had an
/// impact. If it is farther apart half-way to the next one, the search starts there.
double comes_within(const MotionCase& pair, double near, double impact) {
  const double half_way = pair.start + (impact - pair.start) / 2;
  const bool again = pair.gap(pair.start) <= near && pair.gap(half_way) > near;
  const auto first = truth::time_of_distance(pair.scene, near, again ? half_way : pair.start);
  return first.status == Status::miss ? infinity : first.time.lo;
}

/// Judges how far the event lies outside the enclosure (s), against the part that rounding explains.
Finding in_enclosure(const MotionCase& pair, double eps, const Event& event) {
  const double from = comes_within(pair, eps, event.time);
  const double to = pair.truth.status == Status::hit ? pair.truth.time.hi : infinity;
  if (from <= event.time && event.time <= to) return judge::holds();
  const bool early = event.time < from;
  const double allowed =
      early ? from - comes_within(pair, eps + pair.slack, event.time) : pair.latest().value_or(pair.end) - to;
  return judge::at_most(
      early ? from - event.time : event.time - to, {std::isnan(allowed) ? 0 : allowed, 1, "s", 0, event.time},
      early ? Defect::too_early : Defect::too_late, [&] { return text(event); },
      [&] {
        return "an impact in " + oracle::words::text(Interval{from, to}) + " s";
      });
}

Finding lockstep(const Scene& scene, Subject& subject) {
  long impacts = 0;
  Finding worst = of_impacts(
      scene, subject,
      [&](const TrajectoryCase& asked, const Event& event, const std::vector<Segment>& segments, bool together) {
        if (together) return judge::outside(together_with_others);
        const Scene ballistic_scene = segment_scene(scene, segments, asked.end);
        const std::optional<MotionCase> pair = motion_case(ballistic_scene, asked.precision);
        if (!pair) return judge::outside("a pair overlaps where its segments begin");
        if (!pair->sure()) return judge::outside(too_far_to_decide);
        ++impacts;
        return in_enclosure(*pair, envelope(scene), event);
      });
  worst.impacts = impacts;
  return worst;
}

}  // namespace

std::vector<Property> simulation_lockstep_properties() {
  return {{"simulation.lockstep",
           "simulation",
           {"TS-SIMULATION-22"},
           "each impact comes when the reference, restarted from the subject's own states, says that it may",
           lockstep}};
}

}  // namespace touchstone::properties
