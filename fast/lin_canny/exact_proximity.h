// The exact route to a pair's proximity.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "fast/exact/difference.h"
#include "fast/lin_canny/proximity.h"

namespace touchstone::fast::lin_canny {

/// The vertices of a part's core, posed with its body. Keeps a reference to the part.
class ExactCore {
 public:
  ExactCore(const Convex& part, const Pose& X_WB) : part_(part), poses_{X_WB, part.X_BP} {}

  exact::PosedPoints points() const { return {std::span(poses_).first(part_.is_posed ? 2 : 1), part_.core.vertices()}; }

 private:
  const Convex& part_;
  std::array<Pose, 2> poses_;
};

/// `guess` names features whose vertices may be closest; a bad guess only costs time.
Proximity exact_proximity(const Convex& A, const CachedPose& body_A, const Convex& B, const CachedPose& body_B,
                          const FeaturePair& guess);

/// `guess`: at least one pair of vertices of the cores.
Proximity exact_proximity(const Convex& A, const CachedPose& body_A, const Convex& B, const CachedPose& body_B,
                          const std::vector<exact::VertexPair>& guess);

}  // namespace touchstone::fast::lin_canny
