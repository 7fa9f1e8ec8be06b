// An independent second route: the hull of all vertex differences and its nearest facet plane, all exact.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <vector>

#include "reference/penetration/routes.h"

namespace touchstone::reference {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Kernel::FT field(const Integer& v) { return Kernel::FT(mpq_class(v)); }

Integer integer(const Kernel::FT& v) { return mpq_class(CGAL::exact(v)).get_num(); }

Mesh minkowski_hull(const PosedPair& pair) {
  std::vector<Kernel::Point_3> differences;
  for (int a = 0; a < pair.A.size(); ++a) {
    for (int b = 0; b < pair.B.size(); ++b) {
      const IntegerVec w = pair.difference(a, b);
      differences.emplace_back(field(w.x), field(w.y), field(w.z));
    }
  }
  Mesh hull;
  CGAL::convex_hull_3(differences.begin(), differences.end(), hull);
  return hull;
}

}  // namespace

CoreDepth depth_by_minkowski_hull(PosedPair& pair) {
  const Mesh hull = minkowski_hull(pair);
  Shallowest shallowest;
  for (const auto face : hull.faces()) {
    std::vector<IntegerVec> corners;
    for (const auto vertex : hull.vertices_around_face(hull.halfedge(face))) {
      const Kernel::Point_3& p = hull.point(vertex);
      corners.push_back({integer(p.x()), integer(p.y()), integer(p.z())});
    }
    const IntegerVec n = cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (!is_zero(n)) shallowest.offer(n, dot(n, corners[0]));
  }
  return shallowest.take();
}

}  // namespace touchstone::reference
