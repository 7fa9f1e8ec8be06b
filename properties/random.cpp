#include "properties/random.h"

#include <bit>

namespace touchstone::properties {
namespace {

std::uint64_t splitmix(std::uint64_t& state) {
  std::uint64_t z = state += 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

/// FNV-1a, 64 bits.
std::uint64_t hash(std::string_view text) {
  std::uint64_t h = 0xcbf29ce484222325;
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return h;
}

/// Mixes each word fully before it adds the next, so (1, 2) and (2, 1) give unrelated seeds.
std::uint64_t mixed(std::uint64_t seed, std::uint64_t name, std::uint64_t index) {
  for (const std::uint64_t word : {name, index}) {
    seed = splitmix(seed) ^ word;
  }
  return seed;
}

}  // namespace

Random::Random(std::uint64_t seed) {
  for (std::uint64_t& word : state_) word = splitmix(seed);
}

Random::Random(std::uint64_t seed, std::string_view name, std::uint64_t index)
    : Random(mixed(seed, hash(name), index)) {}

std::uint64_t Random::bits() {
  const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9;
  const std::uint64_t shifted = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= shifted;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

int Random::below(int end) {
  const auto limit = static_cast<std::uint64_t>(end);
  const std::uint64_t mask = std::bit_ceil(limit) - 1;
  std::uint64_t drawn = limit;
  while (drawn >= limit) drawn = (bits() >> 11) & mask;
  return static_cast<int>(drawn);
}

double Random::unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

}  // namespace touchstone::properties
