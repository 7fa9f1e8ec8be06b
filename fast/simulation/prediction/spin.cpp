#include "fast/simulation/prediction/spin.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "fast/lin_canny/rotation.h"
#include "fast/motion/quaternion.h"
#include "fast/motion/sine.h"
#include "fast/rounding.h"
#include "fast/simulation/prediction/length.h"

namespace touchstone::fast::simulation {
namespace {

constexpr std::size_t powers = 18;
constexpr double most_turning_steps = 0x1p16;

Quaternion sum_of(const Quaternion& a, const Quaternion& b) { return {a.w + b.w, a.x + b.x, a.y + b.y, a.z + b.z}; }

Quaternion scaled(double s, const Quaternion& q) { return {s * q.w, s * q.x, s * q.y, s * q.z}; }

/// q after a step of length h from the angular velocity w. The power series of q' = ½ (w + alpha t) q has
/// (k + 1) q_{k+1} = (½ h w) q_k + (½ h² alpha) q_{k−1}; it is summed from its smallest terms.
Quaternion after_step(const Quaternion& q, const Vec3& w, const Vec3& alpha, double h) {
  const Vec3 y = h / 2 * w, z = h / 2 * (h * alpha);
  const Quaternion by_w{0, y.x(), y.y(), y.z()}, by_alpha{0, z.x(), z.y(), z.z()};
  std::array<Quaternion, powers + 1> terms;
  terms[0] = q;
  terms[1] = motion::product(by_w, q);
  for (std::size_t k = 2; k <= powers; ++k) {
    terms[k] = scaled(1 / static_cast<double>(k),
                      sum_of(motion::product(by_w, terms[k - 1]), motion::product(by_alpha, terms[k - 2])));
  }
  Quaternion sum = terms[powers];
  for (std::size_t k = powers; k-- > 0;) sum = sum_of(sum, terms[k]);
  return sum;
}

}  // namespace

Quaternion turned(const Quaternion& start, const Vec3& angle) {
  const Quaternion q = lin_canny::at_moderate_scale(start);
  const double size = length(angle);
  if (!(size > 0 && size < 0x1p50)) return q;
  const auto [sine, c] = motion::sine_cosine(size / 2);
  const Vec3 s = sine / size * angle;
  const double w = c * q.w - (s.x() * q.x + s.y() * q.y + s.z() * q.z);
  const double x = c * q.x + s.x() * q.w + (s.y() * q.z - s.z() * q.y);
  const double y = c * q.y + s.y() * q.w + (s.z() * q.x - s.x() * q.z);
  const double z = c * q.z + s.z() * q.w + (s.x() * q.y - s.y() * q.x);
  const double shrink = 1 / std::sqrt((w * w + x * x) + (y * y + z * z));
  return {w * shrink, x * shrink, y * shrink, z * shrink};
}

bool axis_turns(const Vec3& w, const Vec3& alpha) {
  return !alpha.isZero(0) && length(w.cross(alpha)) > 8 * u * length(w) * length(alpha);
}

double turning_steps(const Vec3& w, const Vec3& alpha, double tau) {
  const double fastest = std::max(length(w), length(w + tau * alpha));
  return 1 + std::floor(std::max(fastest, 4 * std::sqrt(length(alpha))) * tau);
}

Quaternion turned(const Quaternion& start, const Vec3& w, const Vec3& alpha, double tau) {
  if (!axis_turns(w, alpha)) return turned(start, tau * (w + tau / 2 * alpha));
  const double steps = turning_steps(w, alpha, tau), h = tau / steps;
  Quaternion q = lin_canny::at_moderate_scale(start);
  if (!(h > 0 && steps <= most_turning_steps)) return q;
  q = motion::unit(q);
  for (double step = 0; step < steps; ++step) q = after_step(q, w + step * h * alpha, alpha, h);
  return motion::unit(q);
}

}  // namespace touchstone::fast::simulation
