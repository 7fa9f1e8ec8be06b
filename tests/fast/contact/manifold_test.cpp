// Contact points of boxes and balls that lie on each other.
#include "fast/contact/manifold.h"

#include <algorithm>
#include <cmath>

#include "fast/motion/rigid_body_model.h"
#include "tests/catch.h"
#include "tests/fast/simulation/scenes.h"

namespace touchstone::fast::contact {
namespace {

const Vec3 up(0, 0, 1);
constexpr double within = 0x1p-10;

/// One convex body at its pose.
struct Solo {
  explicit Solo(Body given) : body(std::move(given)), model(body) {}
  Part part() const {
    const lin_canny::CachedPose pose(body.X_WB);
    return part_of(model.solid.parts()[0], pose, {body.X_WB.p_WB, lin_canny::rotation(body.X_WB.q_WB)});
  }

  Body body;
  motion::RigidBodyModel model;
};

/// Where A touches B, sorted; each point must have no gap.
std::vector<Vec3> points(const Body& a, const Body& b) {
  const Solo A(a), B(b);
  const Part part_a = A.part(), part_b = B.part();
  std::vector<Vec3> points;
  for (const ContactPoint& point : contact_points(part_a, part_b, up, within)) {
    const Nearness near = nearness(point.a, part_a.body, point.b, part_b.body, up);
    CHECK(std::abs(near.gap) < 1e-14);
    points.push_back(near.p_WC);
  }
  std::ranges::sort(points, [](const Vec3& p, const Vec3& q) {
    return std::abs(p.x() - q.x()) > 1e-9 ? p.x() < q.x() : p.y() < q.y();
  });
  return points;
}

void check_points(const std::vector<Vec3>& found, const std::vector<Vec3>& expected, double tolerance = 1e-12) {
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) CHECK((found[i] - expected[i]).norm() < tolerance);
}

TEST_CASE("manifold: a box on a face touches at its four corners") {
  check_points(points(brick({1, 2, 1}, {0, 0, 1}, {}), table()), {{-1, -2, 0}, {-1, 2, 0}, {1, -2, 0}, {1, 2, 0}});
  // The larger one above: the corners are those of the smaller face, or at most a sixteenth of `within` beside them.
  check_points(points(brick({5, 5, 1}, {0, 0, 1}, {}), brick({1, 2, 1}, {0, 0, -1}, {})),
               {{-1, -2, 0}, {-1, 2, 0}, {1, -2, 0}, {1, 2, 0}}, 2 * within / 16);
}

TEST_CASE("manifold: two faces that overlap in part touch at the corners of what they share") {
  const double beside = within / 16;  // a point may be that far outside of a face
  const std::vector<Vec3> found = points(brick({1, 1, 1}, {1.5, 0.5, 1}, {}), brick({1, 1, 1}, {0, 0, -1}, {}));
  REQUIRE(found.size() == 4);
  for (const Vec3& p : found) {
    CHECK(std::min(std::abs(p.x() - 0.5), std::abs(p.x() - 1)) <= 2 * beside);
    CHECK(std::min(std::abs(p.y() + 0.5), std::abs(p.y() - 1)) <= 2 * beside);
  }
  CHECK(points(brick({1, 1, 1}, {2.5, 0, 1}, {}), brick({1, 1, 1}, {0, 0, -1}, {})).empty());
}

TEST_CASE("manifold: an edge on a face has two points, a corner and a ball have one") {
  const double diagonal = std::sqrt(2.0);
  Body on_edge = brick({1, 2, 1}, {0, 0, diagonal}, {});
  on_edge.X_WB.q_WB = {std::cos(std::atan(1) / 2), 0, std::sin(std::atan(1) / 2), 0};  // 45° about y
  check_points(points(on_edge, table()), {{0, -2, 0}, {0, 2, 0}});
  check_points(points(ball(1, {3, 0, 1}, Vec3::Zero(), {}), table()), {{3, 0, 0}});
}

TEST_CASE("manifold: two edges that cross touch at the crossing") {
  const double half = std::sqrt(2.0), c = std::cos(std::atan(1) / 2), s = std::sin(std::atan(1) / 2);
  Body above = brick({1, 2, 1}, {0.25, 0, half}, {}), below = brick({2, 1, 1}, {0, 0.5, -half}, {});
  above.X_WB.q_WB = {c, 0, s, 0};  // its lowest edge is along y, at x = 0.25
  below.X_WB.q_WB = {c, s, 0, 0};  // its highest edge is along x, at y = 0.5
  check_points(points(above, below), {{0.25, 0.5, 0}});
}

TEST_CASE("manifold: a point between two given ones keeps their connection as its normal") {
  const Solo A(brick({1, 1, 1}, {0, 0, 1}, {})), B(table());
  const Part a = A.part(), b = B.part();
  const ContactPoint point = contact_point_between(a, {0.5, 0, 0.25}, b, {0.5, 0, 0}, up);
  const Nearness near = nearness(point.a, a.body, point.b, b.body, up);
  CHECK(near.gap == Approx(0.25));
  CHECK(near.nhat_BA_W == up);
  CHECK(near.p_WC == Vec3(0.5, 0, 0.25));
}

}  // namespace
}  // namespace touchstone::fast::contact
