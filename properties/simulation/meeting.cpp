// The clause of docs/spec/simulation.md that compares a subject's time of impact with the first impact of its
// simulation.
#include <cmath>

#include "model/limits.h"
#include "oracle/judge/words.h"
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

/// Both answers lie in one window: from the time at which the pair may, with rounding, come within the envelope, to the
/// latest time at which it may, with rounding, first touch. So they differ by at most that window plus their own
/// rounding.
Finding agree(const MotionCase& pair, const TimeOfImpact& said, const Trajectory& run) {
  const auto near = oracle::truth::time_of_distance(pair.scene, envelope(pair.scene) + pair.slack);
  const Event* first = run.events->empty() ? nullptr : &run.events->front();
  if (said.status == Status::miss) {
    if (first == nullptr) return judge::holds();
    if (near.status != Status::miss)
      return judge::outside("the bodies come within the contact tolerance: an impact is allowed");
    return judge::wrong(Defect::inconsistent, text(*first), text(said));
  }
  const std::optional<double> latest = pair.latest();
  if (near.status != Status::hit || !latest) return judge::outside("the bodies graze: rounding decides");
  if (!said.time) return judge::silent("the time of impact");
  if (first == nullptr) {
    if (complete_until(pair.scene, run) < *latest) return judge::silent("its events until the time of impact");
    return judge::wrong(Defect::missed, "no impact", text(said));
  }
  if (first->kind != Event::Kind::impact) return judge::outside("a resting contact, not an impact");
  const double window = *latest - near.time.lo + 4 * oracle::unit_roundoff(pair.precision) * pair.end;
  return judge::at_most(
      std::abs(first->time - *said.time), {window, window, "windows"}, Defect::inconsistent,
      [&] { return text(*first); }, [&] { return text(said); });
}

Finding one_meeting(const Scene& scene, Subject& subject) {
  return of_answered_motion(scene, subject, [&](const MotionCase& pair, const TimeOfImpact& said) {
    const auto fixed = [](const Body& body) { return std::holds_alternative<Fixed>(body.mass); };
    if (fixed(scene.bodies[0]) && fixed(scene.bodies[1])) return judge::outside("two fixed bodies have no impact");
    if (!scene.motion->forces.empty()) return judge::outside("applied forces");
    if (said.status == Status::undecided) return judge::silent("whether the bodies touch");
    return judge::given(subject.simulation(scene), [&](const Trajectory& run) {
      if (!fault_in_form(scene, run).empty()) return judge::outside("not a trajectory; see simulation.ordered");
      return run.events ? agree(pair, said, run) : judge::silent("its events");
    });
  });
}

}  // namespace

std::vector<Property> simulation_meeting_properties() {
  return {{"simulation.one_meeting",
           "simulation",
           {"TS-SIMULATION-23"},
           "the first impact of two bodies comes at the time of impact that the same subject states",
           one_meeting}};
}

}  // namespace touchstone::properties
