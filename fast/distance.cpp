#include "fast/distance.h"

#include <algorithm>

#include "fast/lin_canny/nearest_parts.h"
#include "model/input_error.h"

namespace touchstone::fast {
namespace {

using namespace lin_canny;

Feature named(const Solid& solid, int index, const FeatureId& feature, const std::vector<int>& exact_vertices) {
  const Hull& hull = solid.parts()[static_cast<std::size_t>(index)].core;
  Feature name;
  name.part = index;
  if (!exact_vertices.empty()) {
    name.vertices = exact_vertices;
  } else if (feature.kind == Kind::vertex) {
    name.vertices = {feature.index};
  } else if (feature.kind == Kind::edge) {
    name.vertices = {hull.edge(feature.index).tail, hull.edge(feature.index).head};
  } else {
    const Hull::Face& face = hull.face(feature.index);
    for (int i = 0; i < face.corner_count; ++i) name.vertices.push_back(hull.corner(face.first_corner + i));
  }
  for (int& v : name.vertices) v = hull.source(v);
  std::ranges::sort(name.vertices);
  return name;
}

}  // namespace

Distance distance(const Scene& scene) {
  if (scene.bodies.size() < 2) throw InputError("bodies", "expected two");
  const Solid A(scene.bodies[0].shape);
  const Solid B(scene.bodies[1].shape);
  std::vector<FeaturePair> memory(A.parts().size() * B.parts().size());
  const NearestParts found =
      nearest_parts(A, CachedPose(scene.bodies[0].X_WB), B, CachedPose(scene.bodies[1].X_WB), memory);
  const Proximity& nearest = found.proximity;
  Distance answer;
  answer.verdict = nearest.verdict;
  answer.distance = nearest.distance;
  answer.enclosure = nearest.enclosure;
  answer.p_WCa = nearest.p_WCa;
  answer.p_WCb = nearest.p_WCb;
  if (nearest.verdict == Verdict::overlapping) return answer;
  answer.feature_A = named(A, found.part_A, nearest.features.a, nearest.exact_vertices_A);
  answer.feature_B = named(B, found.part_B, nearest.features.b, nearest.exact_vertices_B);
  return answer;
}

}  // namespace touchstone::fast
