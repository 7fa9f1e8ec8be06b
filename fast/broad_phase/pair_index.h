// The position of a pair in a list of pairs: a hash table of positions, so that a pair is removed in O(1).
#pragma once

#include <cstdint>
#include <vector>

#include "fast/broad_phase/strategy.h"

namespace touchstone::fast {

/// The index of a list that is changed only through it. Open addressing, linear probing, at most half full.
class PairIndex {
 public:
  bool holds(const std::vector<BodyPair>& pairs, BodyPair pair) const;
  void add(std::vector<BodyPair>& pairs, BodyPair pair);  ///< requires that it is not in the list
  /// Requires that it is in the list; the last pair takes its place.
  void remove(std::vector<BodyPair>& pairs, BodyPair pair);

 private:
  static constexpr std::uint32_t empty = 0xffffffff;

  std::size_t home(BodyPair pair) const;
  std::size_t find(const std::vector<BodyPair>& pairs,
                   BodyPair pair) const;  ///< its slot, or the empty slot it would take
  void close_gap(const std::vector<BodyPair>& pairs, std::size_t gap);
  void grow(const std::vector<BodyPair>& pairs);

  std::vector<std::uint32_t> position_;  ///< by slot; the size is a power of two
};

}  // namespace touchstone::fast
