// What happens next: impulse-based simulation as in the lecture notes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fast/simulation/books.h"
#include "model/answers.h"
#include "model/input_error.h"
#include "model/scene.h"

namespace touchstone::fast {

struct SimulationOptions {
  double frame = 1.0 / 30;      ///< s; how far ahead boxes look. No path depends on it where closed forms do
  bool exact_momentum = false;  ///< linear momentum on a grid of a power of two: its total never changes a bit
  bool keep_events = true;      ///< else they are counted only
  std::int64_t most_events = 2'000'000;
  double contact_steps = 32;  ///< while a body in contact falls by its size, turns by a radian or goes its size. Their
                              ///< error is of second order: twice as many leave a quarter of it
  std::int64_t most_contact_steps = 100'000;
  bool micro_collisions = false;     ///< hops in place of such steps, as in the notes
  std::int64_t most_hops = 300'000;  ///< of these
};

/// A scene is valid, but the squares and products of its numbers leave the range of doubles.
class BeyondDoubles : public InputError {
 public:
  using InputError::InputError;
};

/// Why a simulation ended before its time.
struct Stopped {
  double time = 0;
  int a = 0, b = 0;  ///< the pair whose turn it was
  std::string why;
};

struct Simulated {
  Trajectory trajectory;
  world::Books books;
  std::vector<Vec3> momentum_before,
      momentum;  ///< kg m/s, by body, if it is kept exact: the two sums are the same double
  std::optional<Stopped> stopped;
};

/// Requires a valid scene with a flight whose polytopes have their faces. Throws InputError where there is no flight, a
/// shape is no solid, or two bodies overlap at the start (naming the pair and the depth); BeyondDoubles where a number
/// of the scene is too great or too small (fast/simulation/range.h).
///
/// Motion, meetings and events: docs/design/simulation.md. Laws: the same scene gives the same bits everywhere; a body
/// that never comes near others changes no bit of their paths.
Simulated simulate(const Scene& scene, const SimulationOptions& options = {});

Trajectory simulation(const Scene& scene);

}  // namespace touchstone::fast
