// An octree of boxes: each box is stored in the smallest cube that contains it.
#pragma once

#include <vector>

#include "fast/broad_phase/strategy.h"

namespace touchstone::fast {

/// A cube with more than 8 bodies is split at its middle into eight; bodies that overlap a splitting plane stay in the
/// cube. A body is tested against those of its own cube and, going down, those of the cubes below whose contents' box
/// it overlaps.
///
/// Cost of a frame: O(n log n) while few bodies overlap splitting planes; O(n²) if all do (a layer through the middle).
/// Rebuilt each frame.
class Octree final : public BroadPhase {
 private:
  /// Nodes are in preorder: the descendants of nodes_[i] are i + 1 … past − 1.
  struct Node {
    Aabb contents;          ///< bounds the cube's own bodies and those of all cubes below
    std::size_t first = 0;  ///< its own bodies are ids_[first … last − 1]
    std::size_t last = 0;
    std::size_t past = 0;
  };

  void refresh() override;
  void split(std::size_t first, std::size_t last, const Vec3& centre, double half, int depth);
  void report_overlaps(std::size_t node);

  std::vector<BodyId> ids_;
  std::vector<Node> nodes_;
};

}  // namespace touchstone::fast
