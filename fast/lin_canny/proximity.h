// The proximity of two convex parts: verdict, enclosure, witnesses and features, each proved.
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
  FeaturePair features;  ///< where the walk ended
  /// If not empty: the vertices of the cores that are the closest features, in place of `features`.
  std::vector<int> closest_vertices_A;
  std::vector<int> closest_vertices_B;
};

/// What it says of the two bodies, without features.
Distance as_distance(const Proximity& found);

/// `memory`: where the walk starts and, afterwards, where it ended; initially {}, or any features of the two. From {}
/// it starts at features that face each other.
///
/// First the walk and its bracket, in doubles. If they leave the verdict open, or the enclosure is wider than rounding
/// explains (the walk ended too early), or lengths do not fit doubles, exact arithmetic decides. It costs some hundred
/// times more, but no verdict is a guess.
Proximity proximity(const Convex& A, const CachedPose& body_A, const Convex& B, const CachedPose& body_B,
                    FeaturePair& memory);

/// The same from the vertices alone, for pairs that are asked about once: the cores may be without edges and faces.
///
/// Gilbert, Johnson & Keerthi's descent over B − A finds the vertices whose hulls are closest; its end needs no proof.
/// The enclosure is that of bracket.h, with all vertices tested along the direction; and likewise exact arithmetic
/// decides what it leaves open. The closest features are all the vertices that are highest along the direction, within
/// rounding, and those that were found.
Proximity proximity(const Convex& A, const CachedPose& body_A, const Convex& B, const CachedPose& body_B);

}  // namespace touchstone::fast::lin_canny
