// Films frame by frame: where the bodies are once the frame's placements are done.
#pragma once

#include <optional>
#include <vector>

#include "model/scene.h"

namespace touchstone {

/// By body; none: it is not there.
using Places = std::vector<std::optional<Pose>>;

inline bool is_film(const Scene& scene) { return !scene.frames.empty(); }

/// Every pose of bodies in W: their own, and those of the film.
std::vector<Pose*> poses(Scene& scene);

/// One entry a frame. Requires that each placement names a body.
std::vector<Places> places(const Scene& film);

/// The bodies that are there after frame f, where they are. Requires that the film has this frame.
Scene still(const Scene& film, std::size_t f);

}  // namespace touchstone
