// Incremental sweep and prune (Cohen, Lin, Manocha, Ponamgi 1995, "I-COLLIDE"): three sorted lists of end points.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fast/broad_phase/pair_index.h"
#include "fast/broad_phase/strategy.h"

namespace touchstone::fast {

/// The lists are kept between frames and sorted by insertion, which swaps each inverted pair of end points exactly
/// once. The set of pairs changes only in swaps:
///   a begin passes below an end   the two intervals now overlap: a pair, if the (final) boxes overlap on all axes;
///   an end passes below a begin   the two intervals are now apart: no pair.
/// On ties a begin precedes an end, so closed boxes that touch are a pair, whatever the order of events.
///
/// A removed body's end points move to a place of their own behind all others, where they are cut off. So removal is
/// made of swaps too, and likewise insertion, which starts behind all others.
///
/// Cost of a frame: 6n + swaps. The claimed "expected O(n)" holds while swaps ≲ n. At fixed density and speed, swaps
/// grow as n^5/3; bodies that come to rest in one layer swap n²/2 times (docs/design/broad_phase.md).
class SweepAndPrune final : public BroadPhase {
 public:
  /// Number of swaps in the last update that had to sort: the number of inversions of the three lists.
  std::uint64_t swaps() const { return swaps_; }

 private:
  struct EndPoint {
    double value = 0;
    BodyId body = 0;
    bool is_end = false;
  };

  void refresh() override;
  void list_new();
  void sort(int axis);
  void swapped(const EndPoint& now_below, const EndPoint& now_above);
  void cut_off_absent();

  std::array<std::vector<EndPoint>, 3> lists_;
  std::vector<std::uint8_t> listed_;  ///< by id
  PairIndex index_;
  std::uint64_t swaps_ = 0;
};

}  // namespace touchstone::fast
