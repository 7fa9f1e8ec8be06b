#include "fast/simulation/prediction/spin.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fast/rounding.h"
#include "reference/rational.h"
#include "tests/catch.h"

namespace touchstone::fast::simulation {
namespace {

double norm(const Quaternion& q) { return std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z); }

using reference::Rational;
using Wide = std::array<Rational, 4>;  ///< a quaternion

Wide product(const Wide& a, const Wide& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

/// A ball's spin over some time: w + alpha t.
struct Spin {
  Vec3 w, alpha;
  double tau;
};

/// The solution of q' = ½ (w + alpha t) q from q(0) = 1: its power series in one piece, exact in its terms. At angles
/// up to 30 rad the term of order k is at most the coefficient of exp(15 s + 7 s²): below 2^-120 from k = 150 on.
Wide series(const Spin& spin) {
  const Rational tau = spin.tau;
  const auto pure = [](const Vec3& v, const Rational& s) -> Wide { return {0.0, s * v.x(), s * v.y(), s * v.z()}; };
  const Wide by_w = pure(spin.w, tau / 2), by_alpha = pure(spin.alpha, tau * tau / 2);
  Wide before{}, term{1.0, 0.0, 0.0, 0.0}, sum = term;
  for (int k = 1; k <= 150; ++k) {
    Wide next = product(by_w, term);
    const Wide bend = product(by_alpha, before);
    for (std::size_t i = 0; i < 4; ++i) sum[i] += next[i] = (next[i] + bend[i]) / static_cast<double>(k);
    before = term;
    term = next;
  }
  return sum;
}

/// rad: the angle between two rotations, to second order: |q_a ∓ q_b| = 2 sin(angle/4).
double angle_between(const Wide& a, const Wide& b) {
  const auto square = [](const Rational& x) { return x * x; };
  const auto apart = [&](double sign) {
    Rational sum;
    for (std::size_t i = 0; i < 4; ++i) sum += square(a[i] - sign * b[i]);
    return 2 * std::sqrt(sum.nearest());
  };
  return std::min(apart(1), apart(-1));
}

Wide wide(const Quaternion& q) { return {q.w, q.x, q.y, q.z}; }

const std::vector<Spin> turning = {
    {{0, 0, 4}, {0, 5, 0}, 1},           // friction slows a ball at 2 m/s²; it spins about the vertical
    {{0, 0, 4}, {0, 5, 0}, 0x1p-6},      // a short time
    {{0, 0, 4}, {0, 0x1p-30, 0}, 4},     // hardly turns
    {{-3, 1, 0}, {3, 0, -1}, 2},         // against its spin, in part
    {{0, -10, 0x1p-20}, {0, 10, 0}, 2},  // reverses, and comes near to no rotation
    {{0.5, 0, 0}, {0, 400, 0}, 0.25},    // starts slowly
    {{20, -3, 7}, {1, 2, 0.25}, 1.25},
};

TEST_CASE("spin: quarter and half turns about the axes, after the rotation that was there") {
  const double quarter = std::acos(-1) / 2, half = std::sqrt(0.5);
  const Quaternion z = turned({}, {0, 0, quarter});
  CHECK(z.w == Approx(half));
  CHECK(z.z == Approx(half));
  CHECK(std::abs(z.x) + std::abs(z.y) < 1e-15);
  // First a quarter turn about z, then half a turn about x: (i)(1 + k)/√2 = (i − j)/√2.
  const Quaternion both = turned(z, {2 * quarter, 0, 0});
  CHECK(std::abs(both.w) + std::abs(both.z) < 1e-15);
  CHECK(both.x == Approx(half));
  CHECK(both.y == Approx(-half));
}

TEST_CASE("spin: the result is a unit quaternion, whatever the scale of the first") {
  for (const double scale : {1.0, 1e-200, 1e200}) {
    const Quaternion q = turned({scale, 2 * scale, -scale, 0}, {0.3, -0.2, 5});
    CHECK(std::abs(norm(q) - 1) < 1e-15);
  }
}

TEST_CASE("spin: no turn, or one beyond the resolution of doubles, leaves the orientation") {
  CHECK(turned({0.6, 0, 0.8, 0}, Vec3::Zero()) == Quaternion{0.6, 0, 0.8, 0});
  CHECK(turned({0.6, 0, 0.8, 0}, {0x1p51, 0, 0}) == Quaternion{0.6, 0, 0.8, 0});
}

TEST_CASE("spin: while the axis turns, the orientation solves q' = ½ ω q, not the rotation by ∫ ω dt") {
  const Quaternion start{0.5, 0.5, -0.5, 0.5};
  for (const Spin& s : turning) {
    INFO("w = " << s.w.transpose() << ", alpha = " << s.alpha.transpose() << ", for " << s.tau << " s");
    const Quaternion q = turned(start, s.w, s.alpha, s.tau);
    CHECK(std::abs(norm(q) - 1) <= 8 * u);
    CHECK(angle_between(wide(q), product(series(s), wide(start))) <= 33 * u * turning_steps(s.w, s.alpha, s.tau));
  }
  const Spin& slowed = turning.front();
  CHECK(angle_between(wide(turned({}, slowed.tau * (slowed.w + slowed.tau / 2 * slowed.alpha))), series(slowed)) > 0.8);
}

// Rotations by ∫ ω dt over pieces of length h: each is wrong by at most |w × alpha| h³/12, since exp(θ) has the angular
// velocity θ' + (θ × θ')/2 + ..., of which the terms after the first are at most |θ × θ'|/2 together, and θ × θ' =
// (w × alpha) t²/2.
TEST_CASE("spin: the orientation is the limit of many small rotations") {
  constexpr int pieces = 1 << 14;
  for (const Spin& s : turning) {
    INFO("w = " << s.w.transpose() << ", alpha = " << s.alpha.transpose() << ", for " << s.tau << " s");
    using Real3 = Eigen::Matrix<long double, 3, 1>;
    Eigen::Quaternion<long double> q(1, 0, 0, 0);
    const long double h = static_cast<long double>(s.tau) / pieces;
    for (int i = 0; i < pieces; ++i) {
      const Real3 angle = h * (s.w.cast<long double>() + h * (i + 0.5L) * s.alpha.cast<long double>());
      q = Eigen::Quaternion<long double>(Eigen::AngleAxis<long double>(angle.norm(), angle.normalized())) * q;
    }
    const Quaternion rounded{static_cast<double>(q.w()), static_cast<double>(q.x()), static_cast<double>(q.y()),
                             static_cast<double>(q.z())};
    const double cubed = s.tau * s.tau * s.tau / pieces / pieces, off = s.w.cross(s.alpha).norm() * cubed / 12;
    const double allowed = off + 34 * u * turning_steps(s.w, s.alpha, s.tau);
    CHECK(angle_between(wide(turned({}, s.w, s.alpha, s.tau)), wide(rounded)) <= allowed);
  }
}

TEST_CASE("spin: about an axis that stays, the orientation has the bits of one rotation") {
  const auto one = [](const Spin& s) { return turned({0.6, 0, 0.8, 0}, s.tau * (s.w + s.tau / 2 * s.alpha)); };
  const Vec3 axis(0.1, 0.7, -0.3);
  for (const Spin& s : {Spin{{1, 2, 3}, Vec3::Zero(), 2}, Spin{Vec3::Zero(), {1, 2, 3}, 2}, Spin{axis, -3 * axis, 2},
                        Spin{axis / 3, axis * 0.7, 50}}) {
    CHECK_FALSE(axis_turns(s.w, s.alpha));
    CHECK(turned({0.6, 0, 0.8, 0}, s.w, s.alpha, s.tau) == one(s));
  }
  CHECK(axis_turns(axis, {0.1, 0.7, -0.3 + 0x1p-48}));
}

TEST_CASE("spin: more steps than a run takes leave the orientation") {
  CHECK(turned({0.6, 0, 0.8, 0}, {0x1p20, 0, 0}, {0, 1, 0}, 1) == Quaternion{0.6, 0, 0.8, 0});
}

}  // namespace
}  // namespace touchstone::fast::simulation
