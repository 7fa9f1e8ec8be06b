// Extreme vertices and faces of boxes whose extents are known.
#include "fast/contact/support.h"

#include <Eigen/Geometry>

#include "tests/catch.h"
#include "tests/fast/contact/posed.h"

namespace touchstone::fast::contact {
namespace {

TEST_CASE("support: the lowest vertex of a turned box") {
  // A quarter turn about z: the half extents in W are 2, 1, 3.
  const Posed box(Box{Vec3(1, 2, 3)}, Vec3(10, 20, 30), {1, 0, 0, 1});
  CHECK(lowest(box.part().core, {1, 0, 0}) == Approx(8));
  CHECK(lowest(box.part().core, {0, 1, 0}) == Approx(19));
  CHECK(lowest(box.part().core, {0, 0, -1}) == Approx(-33));
  CHECK(lowest(box.part().core, Vec3(0.6, 0.8, 0)) == Approx(0.6 * 8 + 0.8 * 19));
}

TEST_CASE("support: a ball's core is its centre") {
  const Posed ball(Sphere{0.5}, Vec3(1, 2, 3));
  CHECK(lowest(ball.part().core, {0, 0, 1}) == 3);
  CHECK(supporting_face(ball.part().core, {0, 0, 1}).face == -1);
}

TEST_CASE("support: the face nearest to a direction, its normal and its corners, counter-clockwise from outside") {
  const Posed box(Box{Vec3(1, 2, 3)}, Vec3(10, 20, 30), {1, 0, 0, 1});
  const SupportingFace found = supporting_face(box.part().core, Vec3(0.6, 0, 0.8));
  CHECK(found.cosine == Approx(0.8));
  CHECK((face_normal(box.part().core, found.face) - Vec3(0, 0, 1)).norm() < 1e-15);
  const std::vector<Vec3> corners = face_corners(box.part().core, found.face);
  REQUIRE(corners.size() == 4);
  Vec3 twice_area = Vec3::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(corners[i].z() == Approx(33));
    CHECK(std::abs(corners[i].x() - 10) == Approx(2));
    CHECK(std::abs(corners[i].y() - 20) == Approx(1));
    twice_area += (corners[i] - corners[0]).cross(corners[(i + 1) % 4] - corners[0]);
  }
  CHECK((twice_area - Vec3(0, 0, 16)).norm() < 1e-12);  // 4 by 2, seen from above
}

}  // namespace
}  // namespace touchstone::fast::contact
