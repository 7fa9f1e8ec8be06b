// A trajectory as the flights it is made of: what an event reports is what is flown from, so each flight can be judged
// by itself, from its own start.
#pragma once

#include <cstddef>
#include <vector>

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::properties {

/// One body's way from one event to its next.
struct Leg {
  std::size_t body = 0;
  double from = 0, until = 0;  ///< s
  State start;
  bool flies = true;  ///< not while a contact rules its way, nor through impacts that are told as one completed series
  std::size_t ends_with = static_cast<std::size_t>(-1);  ///< the event's index; the last leg of a body: none
};

/// Every body's legs, one after another, by body; the last ends with the trajectory.
using Course = std::vector<std::vector<Leg>>;

/// Do two bodies overlap where the later of them sets out, not both fixed? Then it is no motion of solids: subjects may
/// refuse it, and nothing is claimed of an answer. Of the last scene asked it is remembered.
bool overlap_at_start(const Scene& scene);

/// s: until when states and events are whole.
double whole_until(const Scene& scene, const Trajectory& trajectory);

/// Requires a scene with a flight, and events of bodies that are there, each body's in order.
Course course(const Scene& scene, const Trajectory& trajectory);

/// The legs that end with an event: of its body a, and of b if it has one. Cost: the logarithm of the events.
std::vector<Leg> legs_into(const Course& course, const Trajectory& trajectory, std::size_t event);

/// These bodies alone, each from the start of its leg, until `until`. Pushes that have begun by then come along.
Scene in_flight(const Scene& scene, const std::vector<Leg>& legs, double until);

}  // namespace touchstone::properties
