#include "fast/simulation.h"

#include <algorithm>

#include "fast/simulation/contact_event.h"
#include "fast/simulation/island/island_event.h"
#include "fast/simulation/trajectory.h"

namespace touchstone::fast {
namespace {

using simulation::Island;
using simulation::PairEvent;
using simulation::Run;

struct NextEvent {
  enum class Kind { step_begins, step_ends, force, contact };
  Kind kind;
  double time = 0;    ///< s
  BodyId island = 0;  ///< the key of the island whose step begins or ends
};

/// The earliest event: an applied force, the end of an island's step or a predicted contact. Islands begin their next
/// step after all events of the current time. None at the end of the frame, and if the run has stopped.
std::optional<NextEvent> earliest_event(const Run& run) {
  if (run.stopped()) return {};
  const Island *stepping = run.islands.first_to_finish(), *waiting = run.islands.next_waiting();
  const PairEvent* pair = run.schedule.next();
  const double step_end = stepping ? stepping->until() : simulation::never;
  const double contact = pair ? pair->time : simulation::never;
  const AppliedForce* applied = run.world.next_force();
  const double force = applied != nullptr ? applied->time : simulation::never,
               next = std::min({force, contact, step_end});
  if (waiting && next > run.world.now()) {
    return NextEvent{NextEvent::Kind::step_begins, run.world.now(), waiting->graph().key()};
  }
  if (next > run.schedule.frame_end()) return {};
  if (step_end <= next) return NextEvent{NextEvent::Kind::step_ends, step_end, stepping->graph().key()};
  if (force <= contact) return NextEvent{NextEvent::Kind::force, force};
  return NextEvent{NextEvent::Kind::contact, contact};
}

void resolve(Run& run, const NextEvent& event) {
  switch (event.kind) {
    case NextEvent::Kind::step_begins:
      return begin_step(run, event.island);
    case NextEvent::Kind::step_ends:
      return finish_step(run, event.island);
    case NextEvent::Kind::force:
      return apply_force(run);
    case NextEvent::Kind::contact:
      return resolve_contact(run, run.schedule.pop());
  }
}

}  // namespace

Simulated simulate(const Scene& scene, const SimulationOptions& options) {
  Run run(scene, options);
  while (!run.is_over()) {
    begin_frame(run);  // boxes that enclose the trajectories, their intersections, and a heap of predicted contacts
    while (const std::optional<NextEvent> next = earliest_event(run)) {
      run.advance_to(next->time);  // ballistic motion
      resolve(run, *next);         // an impulse; then new boxes and predictions for the two bodies
    }
    run.end_frame();
  }
  return run.result();
}

}  // namespace touchstone::fast
