// The two-dimensional variant of sweep and prune: rectangles in a plane overlap less often than intervals on an axis.
#pragma once

#include <vector>

#include "fast/broad_phase/strategy.h"

namespace touchstone::fast {

/// Boxes are projected onto the two axes along which the bodies are spread widest. A line sweeps along the first; the
/// bodies it intersects are in an interval tree over the second; what overlaps in both is tested along the third.
///
/// The interval tree is a complete binary tree whose leaves are all bodies, sorted by the begin of their interval; a
/// node stores the greatest end among the intersected bodies below it. A body overlaps [lo, hi] if it begins at or
/// before hi and ends at or after lo.
///
/// Cost of a frame: O(n log n + (1 + K) log n), with K pairs that overlap in the plane; nothing is kept between frames.
class Sweep2d final : public BroadPhase {
 private:
  struct Event {
    double at = 0;
    BodyId body = 0;
    bool is_end = false;
  };

  void refresh() override;
  void choose_axes();
  void plant_tree();
  void order_events();
  void put(BodyId id, double end);  ///< −∞ removes it
  void report_overlaps(BodyId id);
  void descend(std::size_t node, std::size_t first, std::size_t width, std::size_t last, BodyId id);

  int sweep_axis_ = 0;
  int tree_axis_ = 1;
  std::vector<BodyId> ids_;  ///< the present bodies; after plant_tree() sorted by their begin along the tree's axis
  std::vector<std::uint32_t> leaf_;   ///< by id
  std::vector<double> greatest_end_;  ///< heap order: node k has children 2k and 2k + 1
  std::size_t leaves_ = 1;
  std::vector<Event> events_;
};

}  // namespace touchstone::fast
