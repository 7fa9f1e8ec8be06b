// The bodies' poses after each frame of a sequence.
#pragma once

#include <optional>
#include <vector>

#include "model/scene.h"

namespace touchstone {

/// By body; no pose: the body is not present.
using Places = std::vector<std::optional<Pose>>;

/// Does the scene have frames?
inline bool is_sequence(const Scene& scene) { return !scene.frames.empty(); }

/// All poses of bodies in W: their own, and those of the sequence.
std::vector<Pose*> poses(Scene& scene);

/// One entry per frame. Requires that each placement names a body of the scene.
std::vector<Places> places(const Scene& sequence);

/// The bodies that are present after frame f, at their poses there. Requires that the sequence has this frame.
Scene snapshot(const Scene& sequence, std::size_t f);

}  // namespace touchstone
