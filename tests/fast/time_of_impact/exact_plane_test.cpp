// Planes along features, of bodies that touch, miss or overlap by an ulp.
#include "fast/time_of_impact/exact_plane.h"

#include "fast/lin_canny/solid.h"
#include "tests/catch.h"

namespace touchstone::fast::time_of_impact {
namespace {

using lin_canny::FeaturePair;
using lin_canny::Hull;
using lin_canny::Kind;
using lin_canny::Solid;

/// The normals, from B to A, of the planes along some faces or edges.
const Vec3 down = -Vec3::UnitZ(), aslant = Vec3(-1, 0, -1).normalized();

/// A is the cube with the corners (±1, ±1, ±1), and B the same cube at p.
bool separates(const Vec3& p, const FeaturePair& along, const Vec3& from_B, const Quaternion& q = {}) {
  const Solid cube(Box{Vec3(1, 1, 1)});
  const lin_canny::Convex& part = cube.parts()[0];
  return separates_exactly(part, {Vec3::Zero(), q}, part, {p, q}, along, from_B);
}

int face_along(const Vec3& n) {
  const Solid cube(Box{Vec3(1, 1, 1)});
  for (int f = 0; f < 6; ++f) {
    if (cube.parts()[0].core.face(f).normal.dot(n) > 0.9) return f;
  }
  FAIL("no such face");
  return 0;
}

TEST_CASE("exact plane: along a face of either, faces that touch are separated, and not by an ulp less") {
  const FeaturePair of_A{{Kind::face, face_along(Vec3::UnitZ())}, {}}, of_B{{}, {Kind::face, face_along(down)}};
  for (const FeaturePair& along : {of_A, of_B}) {
    CHECK(separates({0.5, 0, 2}, along, down));
    CHECK(separates({0.5, 0, 3}, along, down));
    CHECK_FALSE(separates({0.5, 0, 2 - 0x1p-52}, along, down));
    CHECK_FALSE(separates({0.5, 0, 2}, along, -down));  // B is above A
  }
}

TEST_CASE("exact plane: a common rotation that is not of length 1 changes nothing") {
  const Quaternion q{2, 0, 0, 1};  // about z
  const FeaturePair along{{Kind::face, face_along(Vec3::UnitZ())}, {}};
  CHECK(separates({0.5, 0, 2}, along, down, q));
  CHECK_FALSE(separates({0.5, 0, 2 - 0x1p-52}, along, down, q));
}

TEST_CASE("exact plane: along an edge of each, also where they are parallel") {
  const Solid cube(Box{Vec3(1, 1, 1)});
  const Hull& hull = cube.parts()[0].core;
  const auto edge_along = [&](const Vec3& e) {
    for (int i = 0; i < hull.edge_count(); ++i) {
      const Vec3 way = hull.vertex(hull.edge(i).head) - hull.vertex(hull.edge(i).tail);
      if (way.normalized().cross(e).norm() < 0.1) return i;
    }
    FAIL("no such edge");
    return 0;
  };
  const FeaturePair crossed{{Kind::edge, edge_along(Vec3::UnitX())}, {Kind::edge, edge_along(Vec3::UnitY())}};
  CHECK(separates({0.5, 0, 2}, crossed, down));
  CHECK_FALSE(separates({0.5, 0, 2 - 0x1p-52}, crossed, down));
  const FeaturePair parallel{{Kind::edge, edge_along(Vec3::UnitY())}, {Kind::edge, edge_along(Vec3::UnitY())}};
  CHECK_FALSE(separates({9, 0, 9}, parallel, aslant));  // they define no plane
}

}  // namespace
}  // namespace touchstone::fast::time_of_impact
