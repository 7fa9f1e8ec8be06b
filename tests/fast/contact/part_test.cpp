// A part of a body that has several: its pose in W.
#include "fast/contact/part.h"

#include "tests/catch.h"

namespace touchstone::fast::contact {
namespace {

TEST_CASE("part: the second part of a turned body is where the body's pose and its own put it") {
  const lin_canny::Solid solid(
      Compound{{{{Vec3(0, 0, 0), {}}, Box{Vec3::Ones()}}, {{Vec3(5, 0, 0), {}}, Sphere{0.5}}}});
  const lin_canny::CachedPose at(Pose{Vec3(10, 20, 30), {1, 0, 0, 1}});  // x becomes y
  const Part cube = part_of(solid.parts()[0], at, {Vec3(10, 20, 30), at.R_WB});
  const Part ball = part_of(solid.parts()[1], at, {Vec3(10, 20, 30), at.R_WB});
  CHECK(!cube.is_ball());
  CHECK(ball.is_ball());
  CHECK(ball.convex->radius == 0.5);
  CHECK((ball.core.vertex(0) - Vec3(10, 25, 30)).norm() < 1e-14);
  CHECK((ball.body.out(Vec3(5, 0, 0)) - Vec3(10, 25, 30)).norm() < 1e-14);
}

}  // namespace
}  // namespace touchstone::fast::contact
