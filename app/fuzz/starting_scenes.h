// The scenes with which fuzzing begins.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/scene.h"

namespace touchstone::app {

/// For the query, in a fixed order: `draws` scenes of each of its families, drawn with the seed; the cases of the
/// corpus; of simulation also the known motions of at most three bodies. With no draws: the first scene of the first
/// family alone. All are completed.
std::vector<Scene> starting_scenes(const std::string& query, std::uint64_t seed, int draws);

}  // namespace touchstone::app
