// Random numbers that are the same on every machine and compiler; those of the standard's distributions are not.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace touchstone::properties {

/// xoshiro256** 1.0, its state filled by SplitMix64 (Blackman & Vigna 2021, "Scrambled linear pseudorandom number
/// generators", ACM TOMS 47; Steele, Lea & Flood 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed);

  /// An independent stream for each (seed, name, index).
  Random(std::uint64_t seed, std::string_view name, std::uint64_t index);

  std::uint64_t bits();

  /// Uniform in 0 … end − 1, without bias. Requires end ≥ 1.
  int below(int end);

  /// The same for indices.
  std::size_t index(std::size_t end) { return static_cast<std::size_t>(below(static_cast<int>(end))); }

  /// Uniform in lo … hi, both included. Requires lo ≤ hi.
  int between(int lo, int hi) { return lo + below(hi - lo + 1); }

  double whole(int lo, int hi) { return between(lo, hi); }

  /// True with probability 1/n.
  bool one_in(int n) { return below(n) == 0; }

  int sign() { return one_in(2) ? 1 : -1; }

  /// Uniform on the multiples of 2^-53 in [0, 1).
  double unit();

  template <class T>
  T pick(std::initializer_list<T> from) {
    return from.begin()[below(static_cast<int>(from.size()))];
  }
  template <class T>
  const T& pick(const std::vector<T>& from) {
    return from[index(from.size())];
  }

 private:
  std::array<std::uint64_t, 4> state_;
};

}  // namespace touchstone::properties
