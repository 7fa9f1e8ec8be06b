#include "fast/distance.h"

#include <algorithm>
#include <limits>

#include "fast/lin_canny/proximity.h"
#include "model/input_error.h"

namespace touchstone::fast {
namespace {

using namespace lin_canny;

Feature named(const Convex& part, int index, const FeatureId& feature, const std::vector<int>& exact_vertices) {
  const Hull& hull = part.core;
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

Distance put(const Proximity& found, const Convex& A, int part_A, const Convex& B, int part_B) {
  Distance said;
  said.verdict = found.verdict;
  said.distance = found.distance;
  said.enclosure = found.enclosure;
  said.p_WCa = found.p_WCa;
  said.p_WCb = found.p_WCb;
  if (found.verdict == Verdict::overlapping) return said;
  said.feature_A = named(A, part_A, found.features.a, found.exact_vertices_A);
  said.feature_B = named(B, part_B, found.features.b, found.exact_vertices_B);
  return said;
}

/// Overlap is nearer than touching, touching nearer than any distance.
bool is_nearer(const Distance& x, const Distance& y) {
  return *x.verdict != *y.verdict ? *x.verdict > *y.verdict : *x.distance < *y.distance;
}

bool is_surely_farther(const Convex& A, const Station& a, const Convex& B, const Station& b, double than) {
  const Vec3 apart = b.X_WB.p_WB - a.X_WB.p_WB;
  return apart.stableNorm() * (1 - 8 * u) - (A.reach + B.reach) * (1 + 8 * u) > than;
}

}  // namespace

Distance distance(const Scene& scene) {
  if (scene.bodies.size() < 2) throw InputError("bodies", "expected two");
  const Body& A = scene.bodies[0];
  const Body& B = scene.bodies[1];
  const Solid solid_A(A.shape);
  const Solid solid_B(B.shape);
  const Station station_A(A.X_WB);
  const Station station_B(B.X_WB);
  std::optional<Distance> nearest;
  Interval enclosure{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < solid_A.parts().size(); ++i) {
    for (std::size_t j = 0; j < solid_B.parts().size(); ++j) {
      const Convex& part_A = solid_A.parts()[i];
      const Convex& part_B = solid_B.parts()[j];
      if (is_surely_farther(part_A, station_A, part_B, station_B, enclosure.hi)) continue;
      FeaturePair memory;
      const Proximity found = proximity(part_A, station_A, part_B, station_B, memory);
      const Distance said = put(found, part_A, static_cast<int>(i), part_B, static_cast<int>(j));
      enclosure = {std::min(enclosure.lo, said.enclosure->lo), std::min(enclosure.hi, said.enclosure->hi)};
      if (!nearest || is_nearer(said, *nearest)) nearest = said;
    }
  }
  nearest->enclosure = enclosure;
  return *nearest;
}

}  // namespace touchstone::fast
