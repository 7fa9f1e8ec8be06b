// Scenes that are worth being test vectors: short ones of every class that a family has.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/vectors/test_vector.h"
#include "properties/scenes/domain.h"

namespace touchstone::app {

/// At most `most` scenes of a family. First those whose classes none before had, then the shortest; none that the
/// reference has no answer for, or not in half a second of CPU time, or whose text is longer than 6,000 characters.
std::vector<TestVector> drawn_vectors(const std::string& query, const properties::Family& family, std::uint64_t seed,
                                      int most);

}  // namespace touchstone::app
