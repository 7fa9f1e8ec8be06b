#include "fast/constraint.h"

#include <cmath>

#include "fast/constraint/stepper.h"
#include "model/input_error.h"

namespace touchstone::fast {
namespace {

// A choice: the error is of first order in the step, and so is the cost in the number of steps.
constexpr double steps_per_motion = 4096;

// A choice that ends a run with a step that is much too short: half a minute for two balls on a table.
constexpr double most_steps = 0x1p24;

}  // namespace

Trajectory constrained(const Scene& scene, const ConstraintOptions& options) {
  if (!scene.motion) throw InputError("motion", "missing");
  const Motion& motion = *scene.motion;
  for (const double since : motion.start_times) {
    if (since != 0) throw InputError("motion.start_times", "a body that starts later than another; not stepped");
  }
  const double end = motion.sample_times.back(), longest = options.step.value_or(end / steps_per_motion);
  if (!(longest > 0) || !(end / longest < most_steps))
    throw InputError("step", "expected at least the duration of the motion / 2^24");
  constraint::Stepper stepper(scene, longest, options.sweeps);
  Trajectory trajectory;
  double time = 0;
  for (const double sample_time : motion.sample_times) {
    const double span = sample_time - time;
    // An interval that is a whole number of steps up to rounding takes exactly that many.
    const int steps = std::max(1, static_cast<int>(std::ceil(span / longest * (1 - 0x1p-40))));
    stepper.advance(time, sample_time, steps);
    time = sample_time;
    trajectory.states.push_back(stepper.states());
  }
  trajectory.events = std::move(stepper.events());
  return trajectory;
}

}  // namespace touchstone::fast
