#include "fast/simulation/trajectory.h"

#include <algorithm>

#include "fast/simulation/island/island_event.h"
#include "fast/simulation/rest/rest_event.h"

namespace touchstone::fast::simulation {

void keep_orientation(Run& run, BodyId id) {
  if (run.world.keep_orientation(id, run.schedule.frame_end())) return;
  run.guard.stop(run.world.now(), id, {}, "turns too fast to be followed for a frame");
}

void begin_frame(Run& run) {
  run.schedule.begin_frame();
  for (BodyId id = 0; id < run.world.bodies().size(); ++id) keep_orientation(run, id);
  run.schedule.predict_frame();
}

void set_trajectory(Run& run, BodyId id, const State& state) {
  if (run.world.body(id).fixed()) return;
  if (Island* island = run.islands.of(id)) return island->set_velocity(id, state.velocity);
  run.world.body(id).restart(run.world.now(), state, run.world.acceleration(id));
  keep_orientation(run, id);
  run.schedule.trajectory_changed(id);
}

void apply_force(Run& run) {
  World& world = run.world;
  const AppliedForce& force = *world.next_force();
  const auto id = static_cast<BodyId>(force.body);
  cut_step(run, id);
  sum_up_bounces(run, id);  // their impulse is what the forces until now do not explain
  world.apply_next_force();
  BodyMotion& body = world.body(id);
  const double from = std::max(world.now(), body.path().since);
  Island* const island = run.islands.of(id);
  const State state = island ? island->graph().state(id) : body.state(from);
  if (run.rests.of(id)) release_rest(run, id, state);
  if (force.time > world.start_time(id)) {
    run.recorder.record(
        {Event::Kind::force, world.now(), force.body, -1, Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), state, {}});
  }
  if (island) {
    island->graph().body(island->graph().index(id)).step_body.acceleration = world.acceleration(id);
    return;
  }
  body.restart(from, state, world.acceleration(id));
  keep_orientation(run, id);
  run.schedule.trajectory_changed(id);
  run.schedule.predict_all(id);
}

}  // namespace touchstone::fast::simulation
