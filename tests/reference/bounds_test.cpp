#include "reference/bounds.h"

#include <algorithm>
#include <array>

#include "tests/catch.h"
#include "tests/reference/cuboid.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::reference {
namespace {

using tests::cuboid;
using tests::Dice;
using Row = std::array<long long, 3>;

void require_equal(const ExactBox& a, const ExactBox& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    REQUIRE(a.lo[i] == b.lo[i]);
    REQUIRE(a.hi[i] == b.hi[i]);
  }
}

/// |q|² R(q) in integers, by columns q e q*, so that it shares no formula with the code under test.
std::array<Row, 3> scaled_rotation(const Quaternion& q) {
  using Q = std::array<long long, 4>;
  const auto times = [](const Q& a, const Q& b) -> Q {
    return {
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
  };
  const Q p = {static_cast<long long>(q.w), static_cast<long long>(q.x), static_cast<long long>(q.y),
               static_cast<long long>(q.z)};
  const Q conjugate = {p[0], -p[1], -p[2], -p[3]};
  std::array<Row, 3> rows{};
  for (std::size_t column = 0; column < 3; ++column) {
    Q unit{};
    unit[column + 1] = 1;
    const Q image = times(times(p, unit), conjugate);
    for (std::size_t row = 0; row < 3; ++row) rows[row][column] = image[row + 1];
  }
  return rows;
}

TEST_CASE("bounds: an upright box, exactly, far away too") {
  const ExactBox b = box(tests::body(Box{Vec3(1, 2, 3)}, Vec3(0x1p60, 0.1, -0x1p60)));
  CHECK(b.lo[0] == Rational(0x1p60) - Rational(1));  // no double has this value
  CHECK(b.hi[0] == Rational(0x1p60) + Rational(1));
  CHECK(b.hi[1] == Rational(0.1) + Rational(2));
  CHECK(b.lo[2] == Rational(-0x1p60) - Rational(3));
}

TEST_CASE("bounds: vertices under integer quaternions, in integers") {
  Dice dice(41);
  for (int i = 0; i < 500; ++i) {
    const Quaternion q = tests::integer_quaternion(dice);
    const Shape shape = tests::lattice_hull(dice, 10, 5);
    const Polytope p =
        std::holds_alternative<Box>(shape) ? cuboid(std::get<Box>(shape).half_extents) : std::get<Polytope>(shape);
    const Vec3 t = dice.lattice(9);
    const auto rows = scaled_rotation(q);
    const double norm = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    ExactBox expected;
    for (std::size_t k = 0; k < 3; ++k) {
      std::vector<long long> reach;
      for (const Vec3& v : p.vertices) {
        reach.push_back(rows[k][0] * static_cast<long long>(v.x()) + rows[k][1] * static_cast<long long>(v.y()) +
                        rows[k][2] * static_cast<long long>(v.z()));
      }
      const auto [least, greatest] = std::minmax_element(reach.begin(), reach.end());
      const Rational at(t[static_cast<Eigen::Index>(k)]);
      expected.lo[k] = Rational(static_cast<double>(*least)) / Rational(norm) + at;
      expected.hi[k] = Rational(static_cast<double>(*greatest)) / Rational(norm) + at;
    }
    require_equal(box(tests::body(p, t, q)), expected);
    require_equal(box(tests::body(shape, t, q)), expected);
  }
}

TEST_CASE("bounds: a sphere does not turn") {
  const ExactBox b = box(tests::body(Sphere{0.1}, Vec3(1, 2, 3), {1, 2, 3, 4}));
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(b.hi[i] - Rational(static_cast<double>(i + 1)) == Rational(0.1));
    CHECK(Rational(static_cast<double>(i + 1)) - b.lo[i] == Rational(0.1));
  }
}

TEST_CASE("bounds: the length of a quaternion and its sign do not matter") {
  const Box shape{Vec3(1, 2, 3)};
  const ExactBox b = box(tests::body(shape, Vec3(1, 0, 0), {1, 2, -3, 1}));
  for (const double f : {-1.0, 7.0, 0x1p500, 0x1p-500, 0x1p-1072, 0x1p1021}) {
    require_equal(b, box(tests::body(shape, Vec3(1, 0, 0), {f, 2 * f, -3 * f, f})));
  }
}

TEST_CASE("bounds: a power of two scales a box") {
  Dice dice(42);
  const Polytope p = tests::round_hull(dice, 20);
  const ExactBox b = box(tests::body(p, Vec3::Zero(), {1, 2, 3, 4}));
  for (const double f : {0x1p500, 0x1p-500}) {
    const ExactBox c = box(tests::body(tests::stretched(p, Vec3(f, f, f)), Vec3::Zero(), {1, 2, 3, 4}));
    for (std::size_t i = 0; i < 3; ++i) CHECK((c.lo[i] == b.lo[i] * Rational(f) && c.hi[i] == b.hi[i] * Rational(f)));
  }
}

TEST_CASE("bounds: a compound is the union of its parts, each in its pose") {
  Compound compound;
  compound.parts = {{Pose{Vec3(4, 0, 0), {1, 0, 0, 1}}, Box{Vec3(1, 2, 3)}},  // a quarter turn about z: 2, 1, 3
                    {Pose{Vec3(-1, 0, 0), {}}, Sphere{0.5}}};
  const ExactBox b = box(tests::body(compound, Vec3(0, 0, 10), {1, 0, 0, 1}));  // x → y
  CHECK((b.lo[0] == Rational(-1) && b.hi[0] == Rational(1)));
  CHECK((b.lo[1] == Rational(-1.5) && b.hi[1] == Rational(6)));
  CHECK((b.lo[2] == Rational(7) && b.hi[2] == Rational(13)));
}

TEST_CASE("bounds: one box a body, in order") {
  Scene scene = tests::pair(tests::body(Sphere{1}), tests::body(Sphere{2}));
  const std::vector<ExactBox> boxes = bounds(scene);
  REQUIRE(boxes.size() == 2);
  CHECK(boxes[1].hi[0] == Rational(2));
  CHECK(bounds(Scene{}).empty());
}

}  // namespace
}  // namespace touchstone::reference
