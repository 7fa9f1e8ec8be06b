#include "fast/distance.h"

#include <algorithm>
#include <utility>

#include "fast/lin_canny/nearest_parts.h"
#include "model/input_error.h"

namespace touchstone::fast {
namespace {

using namespace lin_canny;

using Preparation = Solid::Preparation;

/// Vertices alone keep the indices of the shape.
Feature named(int part, std::vector<int> vertices) {
  std::ranges::sort(vertices);
  return {part, std::move(vertices)};
}

}  // namespace

Distance distance(const Scene& scene) {
  if (scene.bodies.size() < 2) throw InputError("bodies", "expected two");
  const Solid A(scene.bodies[0].shape, Preparation::vertices);
  const Solid B(scene.bodies[1].shape, Preparation::vertices);
  NearestParts found = nearest_parts(A, CachedPose(scene.bodies[0].X_WB), B, CachedPose(scene.bodies[1].X_WB));
  Proximity& nearest = found.proximity;
  Distance answer = as_distance(nearest);
  if (nearest.verdict == Verdict::overlapping) return answer;
  answer.feature_A = named(found.part_A, std::move(nearest.closest_vertices_A));
  answer.feature_B = named(found.part_B, std::move(nearest.closest_vertices_B));
  return answer;
}

}  // namespace touchstone::fast
