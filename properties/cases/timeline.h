// A trajectory as the segments it consists of. The next motion starts from what an event reports, so each segment can
// be judged by itself, from its own start.
#pragma once

#include <cstddef>
#include <vector>

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::properties {

/// The motion of one body from one event to its next.
struct Segment {
  std::size_t body = 0;
  double from = 0, until = 0;  ///< s
  State start;
  bool ballistic = true;  ///< false under a contact, and during impacts that are reported as one completed series
  std::size_t ends_with = static_cast<std::size_t>(-1);  ///< the event's index; none for a body's last segment

  bool is_last() const { return ends_with == static_cast<std::size_t>(-1); }
};

/// The segments of each body in order, by body. The last one ends with the trajectory.
using Timeline = std::vector<std::vector<Segment>>;

/// Do two bodies, not both fixed, overlap when the later of them starts? Then it is no motion of solids: subjects may
/// refuse it, and nothing is claimed about an answer. Caches the answer for the last scene.
bool overlap_at_start(const Scene& scene);

/// s: states and events are complete until then.
double complete_until(const Scene& scene, const Trajectory& trajectory);

/// What is reported before `time`. Counts over the whole run are left out, and that a run gives up later.
Trajectory reported_before(const Scene& scene, Trajectory said, double time);

/// Requires a scene with a motion, and events of existing bodies, in order for each body.
Timeline timeline(const Scene& scene, const Trajectory& trajectory);

/// The segments that end with an event: that of its body a, and that of b if it has one. Cost: the logarithm of the
/// number of events.
std::vector<Segment> segments_into(const Timeline& timeline, const Trajectory& trajectory, std::size_t event);

/// A scene of these bodies only, each from the start of its segment, until `until`, with the applied forces that have
/// begun by then.
Scene segment_scene(const Scene& scene, const std::vector<Segment>& segments, double until);

}  // namespace touchstone::properties
