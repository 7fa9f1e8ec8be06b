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
  see(A, {}, A_);
  see(B, {n.dot(B.core.t - A.core.t), n.dot(B.v - A.v)}, B_);
  error_ = lin_canny::rounding(A.core, B.core) + 4 * u * radii_;
  speed_error_ = (A.slope_error + B.slope_error) * (1 + 8 * u) + 4 * u * std::abs(n.dot(B.v - A.v));
  const double swirl = (A.swirl + B.swirl) * (1 + 8 * u);
  const double fall = n.dot(B.acceleration - A.acceleration);
  const double fall_error = 128 * u * (A.acceleration.lpNorm<1>() + B.acceleration.lpNorm<1>());
  c_ = std::min(0.0, fall - swirl - fall_error);
  gap_ = between(0).height;
}

/// n·(w × r) = (n × w)·r, r = R x + arm.
void Slab::see(const Side& side, const Point& middle, std::vector<Point>& points) const {
  const Vec3 m = n_.cross(side.w);
  const Vec3 up = side.core.turned_in(n_), faster = side.core.turned_in(m);
  const double speed = middle.speed + m.dot(side.arm);
  const std::vector<Vec3>& vertices = side.core.hull->vertices();
  points.resize(vertices.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = {middle.height + up.dot(vertices[i]), speed + faster.dot(vertices[i])};
  }
}

Slab::Point Slab::between(double h) const {
  Point a = A_[0], b = B_[0];
  for (const Point& p : A_) {
    if (p.height + p.speed * h > a.height + a.speed * h) a = p;
  }
  for (const Point& p : B_) {
    if (p.height + p.speed * h < b.height + b.speed * h) b = p;
  }
  const double gap = b.height - a.height - radii_;
  return {gap - 4 * u * std::abs(gap) - error_, b.speed - a.speed - speed_error_};
}

double Slab::least_speed(double above) const {
  double top = A_[0].height, bottom = B_[0].height;
  for (const Point& p : A_) top = std::max(top, p.height);
  for (const Point& p : B_) bottom = std::min(bottom, p.height);
  double fastest = -std::numeric_limits<double>::infinity(), slowest = -fastest;
  for (const Point& p : A_) {
    if (p.height >= top - above) fastest = std::max(fastest, p.speed);
  }
  for (const Point& p : B_) {
    if (p.height <= bottom + above) slowest = std::min(slowest, p.speed);
  }
  return slowest - fastest - speed_error_;
}

/// From h down to the root of the pair that is nearest at h, until none is below 0: each pair is taken up once at most.
double Slab::clear_until(double h_max) const {
  const double lift = std::max(0.0, -gap_);
  double h = h_max;
  for (int tries = 0; tries < 100 && h > 0; ++tries) {
    const Point nearest = between(h);
    const double z = nearest.height + lift;
    if (z + nearest.speed * h + c_ * h / 2 * h >= 0) return h;
    h = z < 0 ? 0 : std::min(h, first_root(z, nearest.speed, c_)) * (1 - 0x1p-30);
  }
  return 0;
}

}  // namespace touchstone::fast::meeting
