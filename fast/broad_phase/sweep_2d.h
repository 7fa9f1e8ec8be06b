// The two-dimensional variant of sweep and prune: rectangles in a plane overlap less often than intervals on an axis.
#pragma once

#include <vector>

#include "fast/broad_phase/strategy.h"

namespace touchstone::fast {

/// Boxes are projected on the two axes along which the bodies are spread widest. A line sweeps along the first; those
/// that it cuts are held in an interval tree over the second; what overlaps in both is tested along the third.
///
/// The interval tree is a complete binary tree whose leaves are all bodies by the begin of their interval; a node knows
/// the greatest end among the cut bodies below it. Who overlaps [lo, hi] begins at or before hi and ends at or after
/// lo.
///
/// Cost of a frame: O(n log n + (1 + K) log n), K the pairs that overlap in the plane; nothing is kept between frames.
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
  void put(BodyId id, double end);  ///< −∞ takes it out
  void meet(BodyId id);
  void descend(std::size_t node, std::size_t first, std::size_t width, std::size_t last, BodyId id);

  int sweep_axis_ = 0;
  int tree_axis_ = 1;
  std::vector<BodyId> ids_;           ///< present; by begin along the tree's axis after plant_tree()
  std::vector<std::uint32_t> leaf_;   ///< by id
  std::vector<double> greatest_end_;  ///< heap order: node k has children 2k and 2k + 1
  std::size_t leaves_ = 1;
  std::vector<Event> events_;
};

}  // namespace touchstone::fast
