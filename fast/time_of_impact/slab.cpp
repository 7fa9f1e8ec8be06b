#include "fast/time_of_impact/slab.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "fast/lin_canny/bracket.h"

namespace touchstone::fast::meeting {

using lin_canny::u;

double first_root(double z, double s, double c) {
  const double root = std::sqrt(s * s - 2 * c * z);
  if (s > 0) return c < 0 ? (s + root) / -c : std::numeric_limits<double>::infinity();
  return z > 0 ? 2 * z / (root - s) : 0;
}

/// lin_canny::rounding covers heights along any n; |n| is 1 within 2u, and the radii's difference rounds.
Slab::Slab(const Side& A, const Side& B, const Vec3& n) : n_(n), radii_(A.radius + B.radius) {
  A_.see(A, n, 0, 0);
  B_.see(B, n, n.dot(B.core.t - A.core.t), n.dot(B.v - A.v));
  error_ = lin_canny::rounding(A.core, B.core) + 4 * u * radii_;
  speed_error_ = (A.slope_error + B.slope_error) * (1 + 8 * u) + 4 * u * std::abs(n.dot(B.v - A.v));
  const double swirl = (A.swirl + B.swirl) * (1 + 8 * u);
  const double fall = n.dot(B.acceleration - A.acceleration);
  const double fall_error = 128 * u * (A.acceleration.lpNorm<1>() + B.acceleration.lpNorm<1>());
  c_ = std::min(0.0, fall - swirl - fall_error);
  gap_ = between(0).z;
}

/// n·(w × r) = (n × w)·r, r = R x + arm.
void Slab::Heights::see(const Side& side, const Vec3& n, double middle, double speed_of_middle) {
  const Vec3 m = n.cross(side.w);
  const Vec3 up = side.core.turned_in(n), faster = side.core.turned_in(m);
  const double speed_of_origin = speed_of_middle + m.dot(side.arm);
  const std::vector<Vec3>& vertices = side.core.hull->vertices();
  height.resize(vertices.size());
  speed.resize(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    height[i] = middle + up.dot(vertices[i]);
    speed[i] = speed_of_origin + faster.dot(vertices[i]);
  }
}

/// How high comes first, which one second: no processor could predict the comparisons of a loop that asks for both.
std::size_t Slab::Heights::foremost(double h, double sign) const {
  const auto at = [&](std::size_t i) { return sign * (height[i] + speed[i] * h); };
  double most = at(0);
  for (std::size_t i = 1; i < height.size(); ++i) most = std::max(most, at(i));
  std::size_t i = 0;
  while (at(i) != most && i + 1 < height.size()) ++i;
  return i;
}

/// A's highest and B's lowest at h.
Slab::Parabola Slab::between(double h) const {
  const std::size_t a = A_.foremost(h, 1), b = B_.foremost(h, -1);
  const double gap = B_.height[b] - A_.height[a] - radii_;
  return {gap - 4 * u * std::abs(gap) - error_, B_.speed[b] - A_.speed[a] - speed_error_};
}

double Slab::least_speed(double above) const {
  const double top = A_.height[A_.foremost(0, 1)], bottom = B_.height[B_.foremost(0, -1)];
  double fastest = -std::numeric_limits<double>::infinity(), slowest = -fastest;
  for (std::size_t i = 0; i < A_.height.size(); ++i) {
    if (A_.height[i] >= top - above) fastest = std::max(fastest, A_.speed[i]);
  }
  for (std::size_t i = 0; i < B_.height.size(); ++i) {
    if (B_.height[i] <= bottom + above) slowest = std::min(slowest, B_.speed[i]);
  }
  return slowest - fastest - speed_error_;
}

/// From the root of the pair that is nearest now, down to that of the pair that is nearest then, until none is below 0:
/// each pair is taken up once at most.
double Slab::clear_until(double h_max) const {
  const double lift = std::max(0.0, -gap_);
  const auto root = [&](const Parabola& p) { return first_root(std::max(0.0, p.z + lift), p.s, c_) * (1 - 0x1p-30); };
  double h = std::min(h_max, root(between(0)));
  for (int tries = 0; tries < 100 && h > 0; ++tries) {
    const Parabola nearest = between(h);
    if (nearest.z + lift + nearest.s * h + c_ * h / 2 * h >= 0) return h;
    h = std::min(h, root(nearest)) * (1 - 0x1p-30);
  }
  return 0;
}

}  // namespace touchstone::fast::meeting
