// Films frame by frame: where the bodies are once the frame's placements are done.
#pragma once

#include <optional>
#include <vector>

#include "model/scene.h"

namespace touchstone {

/// By body; none: it is not there.
using Places = std::vector<std::optional<Pose>>;

inline bool is_film(const Scene& scene) { return !scene.frames.empty(); }

/// One entry a frame. Requires that each placement names a body.
std::vector<Places> places(const Scene& film);

}  // namespace touchstone
