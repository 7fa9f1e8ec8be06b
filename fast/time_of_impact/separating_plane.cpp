#include "fast/time_of_impact/separating_plane.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>

#include "fast/lin_canny/bracket.h"
#include "fast/motion/steady_turn.h"

namespace touchstone::fast::time_of_impact {

double first_root(double z, double s, double c) {
  const double square = s * s - 2 * c * z;
  if (square < 0) return infinity;
  const double root = std::sqrt(square);
  if (s > 0) return c < 0 ? (s + root) / -c : infinity;
  if (!(z > 0)) return 0;
  return root - s > 0 ? 2 * z / (root - s) : infinity;
}

namespace {

/// Of x ≥ 1, by Newton's method, to a few digits up to 2^30.
double cube_root(double x) {
  double y = std::sqrt(std::sqrt(x));
  for (int i = 0; i < 4; ++i) y = (2 * y + x / (y * y)) / 3;
  return y;
}

}  // namespace

/// Relative to A's core and centre of mass: only differences matter. lin_canny::rounding covers heights along any n;
/// |n| is 1 within 2u, and the difference of the radii rounds. The length of m is at most 1 + |turn|² h²/2: this gives
/// the radii's part of the bend.
SeparatingPlane::SeparatingPlane(const MovingCore& A, const MovingCore& B, const Vec3& n, const Vec3& turn,
                                 const Vec3& p_OC)
    : n_(n) {
  const Vec3 v = B.v - A.v, a = B.acceleration - A.acceleration;
  A_.see(A, n, turn, 0, A.core.t - p_OC, Vec3::Zero(), Vec3::Zero());
  B_.see(B, -n, -turn, -n.dot(B.core.t - A.core.t), B.core.t - p_OC, v, a);
  const double radii = A.radius + B.radius;
  const double gap = -B_.highest() - A_.highest() - radii;
  const double turning = motion::length(turn);
  error_ = lin_canny::rounding(A.core, B.core) + 4 * u * (radii + std::abs(gap));
  gap_ = gap - error_;
  const double slope_error = (A.slope_error + B.slope_error) * (1 + 8 * u) + 8 * u * v.lpNorm<1>();
  const double from_C = (A.core.t - p_OC).lpNorm<1>() + (B.core.t - p_OC).lpNorm<1>();
  speed_error_ = slope_error + turning * (2 * error_ + 8 * u * from_C);
  bend_error_ = A.bend_error + B.bend_error + 4 * turning * slope_error + radii * turning * turning * (1 + 8 * u);
  greatest_bend_ = A.acceleration_bound + B.acceleration_bound + std::abs(n.dot(a)) + bend_error_;
  greatest_rate_ = std::max({motion::length(A.w), motion::length(B.w), turning});
}

/// With r = R x + arm: n·(w × r) = (n × w)·r, n·(w × (w × r)) = ((n·w) w − w² n)·r.
void SeparatingPlane::Heights::see(const MovingCore& side, const Vec3& up, const Vec3& turn, double place,
                                   const Vec3& from_C, const Vec3& v, const Vec3& a) {
  const Vec3 sweep = up.cross(side.w);
  const Vec3 to_bend =
      up.dot(side.w) * side.w - side.w.squaredNorm() * up + up.cross(side.alpha) + 2 * turn.cross(side.w);
  const Vec3 height_B = side.core.turned_in(up), speed_B = side.core.turned_in(sweep + turn);
  const Vec3 bend_B = side.core.turned_in(to_bend);
  const double speed_O = up.dot(v) + sweep.dot(side.arm) + turn.dot(from_C);
  const double bend_O = up.dot(a) + 2 * turn.dot(v) + to_bend.dot(side.arm);
  const std::span<const Vec3> vertices = side.core.hull->vertices();
  of.clear();
  of.reserve(vertices.size());
  for (const Vec3& x : vertices) {
    of.push_back({place + height_B.dot(x), speed_O + speed_B.dot(x), bend_O + bend_B.dot(x)});
  }
  jerk_bound = side.jerk_bound + 3 * motion::length(turn) * (side.acceleration_bound + motion::length(a));
}

double SeparatingPlane::Heights::highest() const {
  double most = of[0].height;
  for (const Height& v : of) most = std::max(most, v.height);
  return most;
}

double SeparatingPlane::Heights::fastest(double at_least_as_high_as) const {
  double most = -infinity;
  for (const Height& v : of) {
    if (v.height >= at_least_as_high_as) most = std::max(most, v.speed);
  }
  return most;
}

/// Most vertices are so low that nothing can raise them to the plane in time. A fraction 2^-40 of the way is kept for
/// the rounding of this test and of the root.
double SeparatingPlane::Heights::below(double z, double s, double bend_error, double H) const {
  double until = H;
  for (const Height& v : of) {
    const double way = (z - v.height) * (1 - 0x1p-40), gain = s - v.speed;
    const double bent = -(v.bend + bend_error + jerk_bound * until / 3);
    if (way + std::min(0.0, gain) * until + std::min(0.0, bent) * until / 2 * until >= 0) continue;
    until = std::min(until, first_root(std::max(0.0, way), gain, bent) * (1 - 0x1p-30));
  }
  return until;
}

double SeparatingPlane::least_speed(double above) const {
  const double a = A_.fastest(A_.highest() - above), b = B_.fastest(B_.highest() - above);
  return -b - a - speed_error_;
}

/// The plane starts in the middle of the gap and moves at the mean of the foremost vertices' speeds. Rounding of the
/// speeds is charged to A.
double SeparatingPlane::clear_until(double h_max) const {
  const double near = 8 * error_;
  const double top_A = A_.highest(), top_B = B_.highest();
  const double speed_A = A_.fastest(top_A - near) + speed_error_, speed_B = B_.fastest(top_B - near);
  const double half = std::max(0.0, gap_) / 2;
  const double plane_speed = (speed_A - speed_B) / 2;
  const auto clear = [&](double H) {
    const double until_A = A_.below(top_A + half, plane_speed - speed_error_, bend_error_, H);
    return B_.below(top_B + half, -plane_speed, bend_error_, until_A);
  };
  // The three terms are a good bound up to about half a radian of rotation. If h reaches that horizon H, or is far
  // below it, they are evaluated again with a longer or shorter one.
  double H = greatest_rate_ > 0 ? std::min(h_max, 0.5 / greatest_rate_) : h_max;
  double h = clear(H);
  for (int doublings = 0; doublings < 2 && h == H && H < h_max; ++doublings) {
    H = std::min(h_max, 2 * H);
    h = std::max(h, clear(H));
  }
  if (!(h < H / 4)) return h;
  const double twice = clear(2 * h);
  if (twice < 2 * h) return std::max(h, twice);
  // The third term alone ends the step: at c/√H for some c, so the horizon that is just reached is (h² H)^(1/3).
  return std::max(twice, clear(h * cube_root(H / h)));
}

}  // namespace touchstone::fast::time_of_impact
