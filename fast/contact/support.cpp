#include "fast/contact/support.h"

#include <algorithm>

#include "fast/mark.h"
#include "model/infinity.h"

namespace touchstone::fast::contact {

double lowest(const lin_canny::PosedHull& hull, const Vec3& n) {
  mark(Mark::vertex_scan, static_cast<std::uint64_t>(hull.hull->vertex_count()));
  double low = infinity;
  for (int v = 0; v < hull.hull->vertex_count(); ++v) low = std::min(low, n.dot(hull.vertex(v)));
  return low;
}

SupportingFace supporting_face(const lin_canny::PosedHull& hull, const Vec3& out) {
  const Vec3 d = hull.turned_in(out);
  SupportingFace best;
  for (int f = 0; f < hull.hull->face_count(); ++f) {
    const double cosine = hull.hull->face(f).normal.dot(d);
    if (f == 0 || cosine > best.cosine) best = {f, cosine};
  }
  return best;
}

Vec3 face_normal(const lin_canny::PosedHull& hull, int face) { return hull.turned_out(hull.hull->face(face).normal); }

std::vector<Vec3> face_corners(const lin_canny::PosedHull& hull, int face) {
  std::vector<Vec3> corners;
  for (const auto& corner : hull.hull->corners(hull.hull->face(face))) corners.push_back(hull.vertex(corner.vertex));
  return corners;
}

}  // namespace touchstone::fast::contact
