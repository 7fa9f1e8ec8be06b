// Event-driven, impulse-based simulation of rigid bodies, as in the lecture notes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fast/simulation/statistics.h"
#include "model/answers.h"
#include "model/input_error.h"
#include "model/scene.h"

namespace touchstone::fast {

/// What a run may cost and what it keeps. A run that reaches a limit stops (Simulated::stopped).
struct SimulationOptions {
  double frame = 1.0 / 30;      ///< s; the time over which boxes enclose trajectories. No trajectory depends on it
                                ///< where all times of impact have closed forms
  bool exact_momentum = false;  ///< keeps linear momentum in multiples of a power of two: its total keeps every bit
  bool keep_events = true;      ///< otherwise events are only counted
  std::int64_t most_events = 2'000'000;
  double contact_steps = 32;  ///< steps while a body in contact falls by its size, turns by a radian or moves by its
                              ///< size. Their error is of second order: twice as many steps leave a quarter of it
  std::int64_t most_contact_steps = 100'000;
  std::int64_t most_work_per_body = 4'000'000'000;  ///< work of a run for each of its bodies (simulation/work.h): about
                                                    ///< as many nanoseconds of CPU time, but counted and not measured
  bool micro_collisions = false;                    ///< contact by micro-bounces instead of such steps, as in the notes
  std::int64_t most_micro_bounces = 300'000;        ///< micro-bounces of a run
};

/// The scene is valid, but squares or products of its numbers exceed the range of doubles.
class BeyondDoubles : public InputError {
 public:
  using InputError::InputError;
};

/// Why a simulation ended early.
struct Stopped {
  double time = 0;   ///< s
  int a = 0, b = 0;  ///< the pair that was being processed; b = -1: a alone
  std::string why;
};

/// A trajectory until the end of the motion, or until the run stopped, with what was counted on the way.
struct Simulated {
  Trajectory trajectory;
  simulation::Statistics statistics;
  std::vector<Vec3> momentum_before,
      momentum;  ///< kg m/s, indexed by body, with exact_momentum: the sums of the two are the same double
  std::optional<Stopped> stopped;
};

/// Requires a valid scene with a motion, whose polytopes have their faces. Throws InputError if the motion is missing,
/// a shape is not a solid, or two bodies overlap at the start (the message names the pair and the depth); throws
/// BeyondDoubles if a number of the scene is too great or too small (fast/simulation/range.h).
///
/// docs/design/simulation.md defines motion, times of impact and events. Laws: the same scene gives the same bits on
/// every machine; a body that never comes near others changes no bit of their trajectories.
Simulated simulate(const Scene& scene, const SimulationOptions& options = {});

}  // namespace touchstone::fast
