#include "reference/ballistic_motion.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "model/infinity.h"
#include "model/input_error.h"
#include "tests/catch.h"
#include "tests/reference/fine_motion.h"
#include "tests/reference/moving_scenes.h"

namespace touchstone::tests {
namespace {

using reference::ballistic_state;
using reference::BallisticTruth;

double width(const Interval& i) { return i.hi - i.lo; }

Mat3 rotation(const BallisticTruth& truth) {
  Mat3 R;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) R(i, j) = truth.R_WB[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].middle();
  }
  return R;
}

Vec3 vec(const std::array<Interval, 3>& v) { return {v[0].middle(), v[1].middle(), v[2].middle()}; }

double widest(const BallisticTruth& truth) {
  double most = 0;
  for (const auto& row : truth.R_WB) {
    for (const Interval& i : row) most = std::max(most, width(i));
  }
  for (const auto& v : {truth.p_WB, truth.v_WBcm, truth.w_WB}) {
    for (const Interval& i : v) most = std::max(most, width(i));
  }
  return most;
}

Scene spinning(const Mat3& I, const Vec3& w, const Quaternion& q = {1, 0.5, -0.25, 2}) {
  Scene scene;
  Body top = body(Box{Vec3(1, 1, 1)}, Vec3(1, 2, 3), q);
  top.mass = MassProperties{.mass = 2, .p_BBcm = Vec3(0.25, 0, -0.5), .I_BBcm_B = I};
  top.velocity = {Vec3(1, -2, 4), w};
  scene.bodies = {top};
  scene.gravity = Vec3(0, 0, -8);
  return moving_scene(scene, 16);
}

Mat3 turned(const Mat3& I, const Vec3& axis, double angle) {
  const Mat3 R = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  const Mat3 J = R * I * R.transpose();
  return (J + J.transpose()) / 2;
}

TEST_CASE("A screw is what Rodrigues says, in 76 digits") {
  Dice dice(1);
  for (int i = 0; i < 20; ++i) {
    Scene scene = ballistic_pair(dice, 6);
    const FineMotion fine(scene, 0);
    const double time = 2 * dice.unit();
    const BallisticTruth truth = ballistic_state(scene, 0, time);
    const auto& vertices = std::get<Polytope>(scene.bodies[0].shape).vertices;
    const auto placed = fine.vertices(time);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      const Vec3 here = vec(truth.p_WB) + rotation(truth) * vertices[v];
      for (std::size_t k = 0; k < 3; ++k) {
        CHECK(std::abs(here[static_cast<Eigen::Index>(k)] -
                       static_cast<double>(placed[v][static_cast<Eigen::Index>(k)])) < 1e-14);
      }
    }
    CHECK(widest(truth) < 1e-14);
  }
}

/// L = R I Rᵀ ω and ω·L stay, whatever the motion is.
void keeps_momentum_and_energy(const Scene& scene, double time, double within) {
  const Mat3& I = std::get<MassProperties>(scene.bodies[0].mass).I_BBcm_B;
  const BallisticTruth before = ballistic_state(scene, 0, 0), after = ballistic_state(scene, 0, time);
  const auto momentum = [&](const BallisticTruth& truth) {
    return Vec3(rotation(truth) * I * rotation(truth).transpose() * vec(truth.w_WB));
  };
  const Vec3 L = momentum(before);
  CHECK((momentum(after) - L).norm() < within * L.norm());
  CHECK(vec(after.w_WB).dot(momentum(after)) == Approx(vec(before.w_WB).dot(L)).epsilon(within));
}

TEST_CASE("Tops keep angular momentum and energy") {
  const std::vector<Mat3> tops = {Vec3(1, 1, 1.75).asDiagonal(), Vec3(1, 2, 2).asDiagonal(),
                                  Vec3(1, 2, 2.5).asDiagonal(), turned(Vec3(1, 2, 2.5).asDiagonal(), Vec3(1, 2, 3), 1)};
  for (const Mat3& I : tops) {
    for (const double time : {0.125, 2.0}) {
      const Scene scene = spinning(I, Vec3(1, 2, -1.5));
      keeps_momentum_and_energy(scene, time, 1e-14);
      CHECK(widest(ballistic_state(scene, 0, time)) < 1e-14);
    }
  }
}

TEST_CASE("Two moments that are nearly equal: the series comes to what the closed form says") {
  const Vec3 w(1, 2, -1.5);
  const BallisticTruth closed = ballistic_state(spinning(Vec3(1, 1, 1.75).asDiagonal(), w), 0, 2);
  const BallisticTruth series = ballistic_state(spinning(Vec3(1, 1 + 0x1p-50, 1.75).asDiagonal(), w), 0, 2);
  CHECK((rotation(closed) - rotation(series)).norm() < 1e-13);
  CHECK((vec(closed.w_WB) - vec(series.w_WB)).norm() < 1e-13);
  CHECK((vec(closed.p_WB) - vec(series.p_WB)).norm() < 1e-13);
}

/// Classical Runge and Kutta, 1/4096 s a step.
TEST_CASE("A top about its middle axis turns over as Euler's equations say") {
  const Mat3 I = Vec3(1, 2, 2.75).asDiagonal();
  const Scene scene = spinning(I, Vec3(0.0625, 4, 0), {1, 0, 0, 0});
  Vec3 w = scene.bodies[0].velocity.w_WB;
  const auto rate = [&](const Vec3& v) { return Vec3(I.inverse() * (I * v).cross(v)); };
  constexpr double h = 0x1p-12;
  for (int i = 0; i < 3 * 4096; ++i) {
    const Vec3 a = rate(w), b = rate(w + h / 2 * a), c = rate(w + h / 2 * b), d = rate(w + h * c);
    w += h / 6 * (a + 2 * b + 2 * c + d);
  }
  const BallisticTruth truth = ballistic_state(scene, 0, 3);
  const Vec3 w_B = rotation(truth).transpose() * vec(truth.w_WB);
  CHECK(w_B.y() < 0);
  CHECK((w_B - w).norm() < 1e-10);
}

TEST_CASE("A principal axis is kept, whatever the moments, a sphere's is any") {
  const BallisticTruth truth =
      ballistic_state(spinning(Vec3(1, 2, 2.75).asDiagonal(), Vec3(0, 4, 0), {1, 0, 0, 0}), 0, 1);
  CHECK(vec(truth.w_WB) == Vec3(0, 4, 0));
  CHECK(rotation(truth)(0, 0) == Approx(std::cos(4.0)).epsilon(1e-15));
}

TEST_CASE("The centre of mass falls, a fixed body turns about its origin") {
  const BallisticTruth truth = ballistic_state(spinning(Vec3(1, 2, 2.75).asDiagonal(), Vec3(1, 2, 3)), 0, 2);
  const Scene scene = spinning(Vec3(1, 2, 2.75).asDiagonal(), Vec3(1, 2, 3));
  const Vec3 c(0.25, 0, -0.5);
  const BallisticTruth at_first = ballistic_state(scene, 0, 0);
  const Vec3 start = vec(at_first.p_WB) + rotation(at_first) * c;
  CHECK((vec(truth.p_WB) + rotation(truth) * c - (start + Vec3(2, -4, 8 - 16))).norm() < 1e-14);
  CHECK(vec(truth.v_WBcm) == Vec3(1, -2, -12));

  Scene table = scene;
  table.bodies[0].mass = Fixed{};
  CHECK(vec(ballistic_state(table, 0, 2).p_WB) == Vec3(3, -2, 11));
  CHECK(vec(ballistic_state(table, 0, 2).w_WB) == Vec3(1, 2, 3));
}

/// Taylor's series of Euler's equations, degree 24, in steps of an eighth of a radian; long double.
struct Series {
  using Real = long double;
  using State = std::array<Real, 7>;  ///< q, ω, in principal axes

  static State step(const State& y, const std::array<Real, 3>& c, Real h) {
    constexpr std::size_t degree = 24;
    std::array<State, degree + 1> a{y};
    for (std::size_t k = 0; k < degree; ++k) {
      State next{};
      for (std::size_t j = 0; j <= k; ++j) {
        const State& q = a[j];
        const State& w = a[k - j];
        next[0] -= q[1] * w[4] + q[2] * w[5] + q[3] * w[6];
        next[1] += q[0] * w[4] + q[2] * w[6] - q[3] * w[5];
        next[2] += q[0] * w[5] + q[3] * w[4] - q[1] * w[6];
        next[3] += q[0] * w[6] + q[1] * w[5] - q[2] * w[4];
        next[4] += q[5] * w[6];
        next[5] += q[6] * w[4];
        next[6] += q[4] * w[5];
      }
      const Real n = static_cast<Real>(k + 1);
      for (std::size_t i = 0; i < 4; ++i) a[k + 1][i] = next[i] / (2 * n);
      for (std::size_t i = 0; i < 3; ++i) a[k + 1][4 + i] = c[i] * next[4 + i] / n;
    }
    State sum{};
    for (std::size_t k = degree + 1; k-- > 0;) {
      for (std::size_t i = 0; i < 7; ++i) sum[i] = sum[i] * h + a[k][i];
    }
    return sum;
  }
};

void agrees_with_series(const Vec3& I, const Vec3& w, double time) {
  using Real = Series::Real;
  const Real I_1 = I[0], I_2 = I[1], I_3 = I[2];
  const std::array<Real, 3> c = {(I_2 - I_3) / I_1, (I_3 - I_1) / I_2, (I_1 - I_2) / I_3};
  const int steps = 8 * static_cast<int>(w.norm() * time) + 8;
  Series::State y{1, 0, 0, 0, w[0], w[1], w[2]};
  for (int i = 0; i < steps; ++i) y = Series::step(y, c, static_cast<Real>(time) / steps);
  const BallisticTruth truth = ballistic_state(spinning(I.asDiagonal(), w, {1, 0, 0, 0}), 0, time);
  const Vec3 w_B = rotation(truth).transpose() * vec(truth.w_WB);
  CAPTURE(I.transpose(), w.transpose(), time);
  for (std::size_t i = 0; i < 4; ++i) CHECK(std::abs(truth.q_WB[i].middle() - static_cast<double>(y[i])) < 1e-13);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(std::abs(w_B[static_cast<Eigen::Index>(i)] - static_cast<double>(y[4 + i])) < 1e-13 * w.norm());
  }
  CHECK(widest(truth) < 1e-13);
}

TEST_CASE("A tumbling body is where Euler's series says: about either axis, near the middle one, along the way to it") {
  const Vec3 rising(2, 3, 4), falling(4, 3, 2), long_one(1, 4, 4.5);
  for (const Vec3& I : {rising, falling, long_one}) {
    for (const Vec3& w : {Vec3(1, 2, -1.5), Vec3(-3, 0.25, 0.5), Vec3(0.5, -0.5, 3), Vec3(0, 1, -2), Vec3(-2, -1, 0),
                          Vec3(0x1p-10, 3, 0), Vec3(0, -3, 0x1p-10), Vec3(1, 0, -2), Vec3(2, 0, 1)}) {
      for (const double time : {0.5, 8.0}) agrees_with_series(I, w, time);
    }
  }
  // L² = 2T I_2: it comes to its middle axis in the end. Two moments of 3/2 of each other, |ω_1| = |ω_3|.
  for (const Vec3& w : {Vec3(1, 1, 1), Vec3(-1, 2, 1), Vec3(1, -0.5, -1)}) {
    for (const double time : {0.25, 4.0}) agrees_with_series(Vec3(2, 5, 6), w, time);
  }
}

TEST_CASE("Hardly off a principal axis a body turns about it, until the middle one may have been left") {
  const Vec3 I(2, 3, 4);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double off : {0x1p-60, 0x1p-90, 0x1p-110, 0x1p-124, 0x1p-125, 0x1p-126, 0x1p-200}) {
      Vec3 w = Vec3::Constant(off);
      w[axis] = -3;
      for (const double time : {0.5, 8.0}) agrees_with_series(I, w, time);
    }
  }
  // 2^-200 is at most e^(3 t) times that after t seconds: the rate is 2/3 of |L|/I_1 = 9/2.
  const Scene middle = spinning(I.asDiagonal(), Vec3(0x1p-200, 3, 0x1p-200), {1, 0, 0, 0});
  CHECK(widest(ballistic_state(middle, 0, 12)) < 1e-12);
  CHECK(widest(ballistic_state(middle, 0, 4096)) == infinity);
  // The same in other units of time.
  const Scene slow = spinning(I.asDiagonal(), Vec3(0x1p-280, 0x3p-80, 0x1p-280), {1, 0, 0, 0});
  const BallisticTruth truth = ballistic_state(slow, 0, 0x1p83);
  for (std::size_t i = 0; i < 3; ++i) CHECK(width(truth.w_WB[i]) <= 0x1p-130);  // two ulps of 3·2^-80
  CHECK(width(truth.q_WB[2]) < 1e-15);
  CHECK(width(ballistic_state(slow, 0, 0x1p92).w_WB[1]) == infinity);
}

TEST_CASE("A tumbling body is never lost: 10,000 radians and more are as exact as one") {
  const Mat3 I = turned(Vec3(1, 2, 2.75).asDiagonal(), Vec3(1, 2, 3), 1);
  for (const Vec3& w : {Vec3(1000, 8, 2), Vec3(100, -500, 800)}) {
    const Scene scene = spinning(I, w);
    keeps_momentum_and_energy(scene, 12, 1e-13);
    CHECK(widest(ballistic_state(scene, 0, 12)) < 1e-12);
  }
}

TEST_CASE("A body has no place before its start") {
  Scene scene = spinning(Mat3::Identity(), Vec3::Zero());
  scene.motion->start_times = {1};
  CHECK_THROWS_AS(ballistic_state(scene, 0, 0.5), InputError);
  CHECK(vec(ballistic_state(scene, 0, 1).p_WB) == Vec3(1, 2, 3));
}

}  // namespace
}  // namespace touchstone::tests
