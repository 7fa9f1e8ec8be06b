// The directions that are left out are not needed: among the others one is as wide, if the bodies overlap, and one
// separates them, if any does.
#include "fast/lin_canny/parting_normals.h"

#include <algorithm>

#include "fast/lin_canny/proximity.h"
#include "tests/catch.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::fast::lin_canny {
namespace {

double lowest(const PosedHull& hull, const Vec3& n) {
  double low = infinity;
  for (int v = 0; v < hull.hull->vertex_count(); ++v) low = std::min(low, n.dot(hull.vertex(v)));
  return low;
}

struct Widest {
  double width = -infinity;
  int planes = 0;

  void ask(const PosedHull& A, const PosedHull& B, const Vec3& n) {
    width = std::max(width, lowest(A, n) + lowest(B, -n));
    ++planes;
  }
};

/// Of the planes along all faces and along all pairs of edges.
Widest of_all(const PosedHull& A, const PosedHull& B) {
  Widest widest;
  for (int f = 0; f < A.hull->face_count(); ++f) widest.ask(A, B, -A.turned_out(A.hull->face(f).normal));
  for (int f = 0; f < B.hull->face_count(); ++f) widest.ask(A, B, B.turned_out(B.hull->face(f).normal));
  for (int i = 0; i < A.hull->edge_count(); ++i) {
    for (int j = 0; j < B.hull->edge_count(); ++j) {
      const Vec3 n = A.edge_vector(i).cross(B.edge_vector(j));
      if (n.norm() == 0) continue;
      widest.ask(A, B, n.normalized());
      widest.ask(A, B, -n.normalized());
    }
  }
  return widest;
}

TEST_CASE("parting normals: of planes along two edges those that cut a body are left out, and none is missed") {
  tests::Dice dice(1);
  int overlapping = 0, apart = 0, asked = 0, all = 0;
  for (int i = 0; i < 200; ++i) {
    const Solid a(tests::round_hull(dice, 6 + i % 12)), b(tests::round_hull(dice, 6 + i % 7));
    const Pose X_WB{1.5 * dice.in_cube(), {1, dice.unit(), dice.unit(), dice.unit()}};
    const PosedHull A = posed_hull(a.parts()[0], CachedPose(Pose{}), Vec3::Zero());
    const PosedHull B = posed_hull(b.parts()[0], CachedPose(X_WB), Vec3::Zero());
    const Widest truth = of_all(A, B);
    Widest said;
    any_parting_normal(A, B, [&](const Vec3& n, const FeaturePair&) {
      said.ask(A, B, n);
      return false;
    });
    if (truth.width < -1e-12) {
      CHECK(said.width == Approx(truth.width).margin(1e-13));
      ++overlapping;
    } else if (truth.width > 1e-12) {
      CHECK(said.width > 0);
      ++apart;
    }
    asked += said.planes;
    all += truth.planes;
  }
  CHECK(overlapping > 50);
  CHECK(apart > 20);
  CHECK(8 * asked < all);
}

}  // namespace
}  // namespace touchstone::fast::lin_canny
