// A scene as bytes, for fuzzers that only know bytes: any bytes are a scene.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "model/scene.h"

namespace touchstone::properties::fuzzing {

/// Bytes as a recipe: the first four choose a drawn scene, each further eight choose a mutation of it. So a fuzzer's
/// bytes are never refused: missing ones are 0, those after the last mutation do not count, and a mutation that would
/// make no valid scene is not done. A longer recipe begins as the shorter one, so a fuzzer that appends or replaces
/// bytes does another mutation.
inline constexpr std::size_t bytes_of_start = 4;
inline constexpr std::size_t bytes_of_mutation = 8;
inline constexpr std::size_t most_mutations = 16;
inline constexpr std::size_t most_bytes = bytes_of_start + most_mutations * bytes_of_mutation;

/// The scene of a recipe: valid, with its faces and the parts that the query needs. Requires a query with families.
Scene scene_of(const std::string& query, std::span<const std::uint8_t> recipe);

/// Changes a recipe in place: one mutation more, less, another or twice, or another start. At most `most` bytes. For
/// LLVMFuzzerCustomMutator.
void mutate_recipe(std::vector<std::uint8_t>& recipe, std::size_t most, std::uint64_t seed);

/// The beginning of one recipe, and the mutations of another. For LLVMFuzzerCustomCrossOver.
std::vector<std::uint8_t> crossed(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b, std::size_t most,
                                  std::uint64_t seed);

}  // namespace touchstone::properties::fuzzing
