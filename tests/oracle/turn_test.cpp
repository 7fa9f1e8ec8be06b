// The rotation under an angular velocity that changes evenly, against rotations known on paper and against finer steps.
#include "oracle/truth/turn.h"

#include <Eigen/Geometry>
#include <cmath>

#include "tests/catch.h"

namespace touchstone::oracle {
namespace {

Matrix about(const Point& axis, Real angle) {
  return Eigen::AngleAxis<Real>(angle, axis.normalized()).toRotationMatrix();
}

Real apart(const Matrix& a, const Matrix& b) { return (a - b).norm(); }

TEST_CASE("turn: about an axis that stays, by the mean angular velocity") {
  const Point axis(1, -2, 2);
  CHECK(apart(turn(axis, 3 * axis, 2), about(axis, 12)) < 1e-15);
  CHECK(apart(turn(axis, -axis, 2), Matrix::Identity()) < 1e-15);
  CHECK(apart(turn(Point::Zero(), Point::Zero(), 2), Matrix::Identity()) == 0);
}

// Rotations by ∫ ω dt over pieces of length h: each is wrong by at most |ω × ω'| h³/12, since exp(θ) has the angular
// velocity θ' + (θ × θ')/2 + ..., of which the terms after the first are at most |θ × θ'|/2 together.
TEST_CASE("turn: while the axis turns, the limit of many small rotations") {
  const Point from(0, 0, 4), until(1, 5, 3);
  constexpr int pieces = 1 << 16;
  const Real seconds = 1.5, h = seconds / pieces;
  Eigen::Quaternion<Real> q = Eigen::Quaternion<Real>::Identity();
  for (int i = 0; i < pieces; ++i) {
    const Point angle = h * (from + (i + 0.5L) / pieces * (until - from));
    q = Eigen::Quaternion<Real>(Eigen::AngleAxis<Real>(angle.norm(), angle.normalized())) * q;
  }
  const Real off = from.cross(until).norm() * seconds * seconds / pieces / pieces / 12;
  CHECK(apart(turn(from, until, seconds), q.toRotationMatrix()) <
        std::sqrt(2) * (off + turn_error(from, until, seconds)));
  CHECK(off < 1e-8);
  const Point sum = seconds / 2 * (from + until);
  CHECK(apart(turn(from, until, seconds), about(sum, sum.norm())) > 0.5);
}

TEST_CASE("turn: two halves make the whole, as far as is claimed") {
  const Point from(20, 0, -3), until(-20, 1, 4), middle = (from + until) / 2;
  const Matrix halves = turn(middle, until, 0.5) * turn(from, middle, 0.5);
  CHECK(apart(turn(from, until, 1), halves) < 3 * turn_error(from, until, 1));
  CHECK(turn_error(from, until, 1) < 1e-7);
}

TEST_CASE("turn: many turns are too long") {
  CHECK(is_short_turn({0, 0, 100}, {0, 5, 100}, 2));
  CHECK_FALSE(is_short_turn({0, 0, 100}, {0, 5, 100}, 4));
}

}  // namespace
}  // namespace touchstone::oracle
