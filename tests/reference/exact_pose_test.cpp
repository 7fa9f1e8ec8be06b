#include "reference/exact_pose.h"

#include <limits>

#include "tests/catch.h"

namespace touchstone::reference {
namespace {

RationalVec3 rationals(const std::string& x, const std::string& y, const std::string& z) {
  return {Rational(x), Rational(y), Rational(z)};
}

Quaternion times(double s, const Quaternion& q) { return {s * q.w, s * q.x, s * q.y, s * q.z}; }

TEST_CASE("pose: a pose takes a point where its rotation and translation say, as a rational") {
  // q = 2 + i: cos = (4 − 1)/5, sin = 4/5 about x.
  CHECK(in_world({Vec3(10, 20, 30), {2, 1, 0, 0}}, Vec3(7, 5, 0)) == rationals("17", "23", "34"));
  // q = 1 + i + j + k: a third of a turn, x → y → z → x.
  CHECK(in_world({Vec3(0, 0, 0), {1, 1, 1, 1}}, Vec3(1, 2, 3)) == rationals("3", "1", "2"));
  // q = 1 + 2k: cos = −3/5, sin = 4/5 about z.
  CHECK(in_world({Vec3(0, 0, 0.5), {1, 0, 0, 2}}, Vec3(1, 0, 0)) == rationals("-3/5", "4/5", "1/2"));
  // q = 3 + i + j + k, |q|² = 12: R = 1/12 [8 −4 8; 8 8 −4; −4 8 8].
  CHECK(in_world({Vec3(0, 0, 0), {3, 1, 1, 1}}, Vec3(1, 0, 0)) == rationals("2/3", "2/3", "-1/3"));
}

TEST_CASE("pose: q and s·q are one rotation, however huge or tiny s") {
  const Quaternion q = {3, -1, 2, 5};
  const Vec3 p(0.1, -7, 1e-9);
  const RationalVec3 expected = in_world({Vec3(1, 2, 3), q}, p);
  for (const double s : {-1.0, 3.0, 0x1p500, 0x1p-500, -0x1p-1070}) {
    CAPTURE(s);
    CHECK(in_world({Vec3(1, 2, 3), times(s, q)}, p) == expected);
  }
}

TEST_CASE("pose: nothing is rounded, from the least double to the greatest") {
  const double least = std::numeric_limits<double>::denorm_min();
  const double most = std::numeric_limits<double>::max();
  const RationalVec3 p = in_world({Vec3(most, 0, 0), {1, 0, 0, 1}}, Vec3(0, least, 0));
  CHECK(p.x == Rational(most) - Rational(least));
  CHECK(p.y.sign() == 0);
}

TEST_CASE("pose: rotations keep lengths exactly") {
  const Vec3 v(0.1, 0.2, -0.3);
  const RationalVec3 p = in_world({Vec3::Zero(), {0.1, 0.7, -0.3, 1e-5}}, v);
  const auto squared = [](const Rational& x, const Rational& y, const Rational& z) { return x * x + y * y + z * z; };
  CHECK(squared(p.x, p.y, p.z) == squared(v.x(), v.y(), v.z()));
}

}  // namespace
}  // namespace touchstone::reference
