// How far apart two convex parts are: verdict, enclosure, witnesses and features, each with its proof.
#pragma once

#include <optional>
#include <vector>

#include "fast/lin_canny/bracket.h"
#include "fast/lin_canny/solid.h"
#include "model/answers.h"

namespace touchstone::fast::lin_canny {

struct Proximity {
  Verdict verdict = Verdict::separated;
  double distance = 0;
  Interval enclosure;
  Vec3 p_WCa = Vec3::Zero();
  Vec3 p_WCb = Vec3::Zero();
  FeaturePair features;               ///< where the walk ended
  std::vector<int> exact_vertices_A;  ///< if not empty, the exact route named these vertices of the cores instead
  std::vector<int> exact_vertices_B;
};

/// `memory` is where the walk starts and, afterwards, where it ended: any features of the two, to begin with.
///
/// In doubles: the walk and its bracket. Where that leaves the verdict open, or the enclosure wider than rounding
/// explains (a walk that ended too early), or lengths do not fit, exact arithmetic settles it: it costs some hundred
/// times more, and no verdict is a guess.
Proximity proximity(const Convex& A, const Station& body_A, const Convex& B, const Station& body_B,
                    FeaturePair& memory);

}  // namespace touchstone::fast::lin_canny
