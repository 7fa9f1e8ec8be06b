// One run of a simulation: the parts that every event may change.
#pragma once

#include "fast/simulation/exact_momentum.h"
#include "fast/simulation/prediction/collision_schedule.h"
#include "fast/simulation/recorder.h"

namespace touchstone::fast::simulation {

struct Run {
  /// The scene must outlive the run. Throws as fast::simulate does.
  Run(const Scene& scene, const SimulationOptions& options);
  Run(const Run&) = delete;  // its parts refer to each other
  Run& operator=(const Run&) = delete;

  bool stopped() const { return guard.stopped().has_value(); }
  bool is_over() const { return stopped() || !(world.now() < world.end()); }
  /// Samples up to a time, and makes it the current one. Time never goes back.
  void advance_to(double time);
  /// Advances to the end of the frame, unless the run has stopped, and samples through that time.
  void end_frame();
  /// Stops the run if the states at the current time are not known: it is complete until the double before that, or
  /// until an event that is reported already.
  void stop_before_now(BodyId a, BodyId b, const char* why);
  /// What has been recorded. The run is then used up.
  Simulated result();

  /// Whether the body is in an island or rests.
  bool is_in_contact(BodyId id) const { return islands.of(id) || rests.of(id); }

  const SimulationOptions options;
  World world;
  const bool has_closed_forms;  ///< every pair of bodies has one of its time of impact, or never collides
  Islands islands;
  RestingBodies rests;
  Recorder recorder;
  StallGuard guard;
  CollisionSchedule schedule;
  std::optional<ExactMomentum> exact_momentum;
};

}  // namespace touchstone::fast::simulation
