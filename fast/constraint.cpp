#include "fast/constraint.h"

#include <cmath>

#include "fast/constraint/stepper.h"
#include "model/input_error.h"

namespace touchstone::fast {
namespace {

constexpr double steps_of_a_flight = 4096;
constexpr double most_steps = 0x1p24;

}  // namespace

Trajectory constrained(const Scene& scene, const ConstraintOptions& options) {
  if (!scene.flight) throw InputError("flight", "missing");
  const Flight& flight = *scene.flight;
  for (const double since : flight.since) {
    if (since != 0) throw InputError("flight.since", "a body that starts later than another; not stepped");
  }
  const double end = flight.times.back(), longest = options.step.value_or(end / steps_of_a_flight);
  if (!(longest > 0) || !(end / longest < most_steps)) throw InputError("step", "expected one that ends the flight");
  constraint::Stepper stepper(scene, longest, options.sweeps);
  Trajectory said;
  double time = 0;
  for (const double look : flight.times) {
    const double span = look - time;
    // A look that is a whole number of steps away within rounding takes that many.
    const int steps = std::max(1, static_cast<int>(std::ceil(span / longest * (1 - 0x1p-40))));
    for (int i = 0; i < steps; ++i) {
      const double from = time + span * i / steps;
      stepper.step(from, span / steps, i + 1 == steps ? look : time + span * (i + 1) / steps);
    }
    time = look;
    said.states.push_back(stepper.states());
  }
  said.events = std::move(stepper.events());
  return said;
}

}  // namespace touchstone::fast
