#include "fast/motion/tumble_period.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fast/rounding.h"
#include "model/infinity.h"

namespace touchstone::fast::motion {
namespace {

/// In units of 1/Ω. A choice that bounds the number of steps to store: at most 2^11 of 8 units while rounding permits.
constexpr double longest = 0x1p14;

/// Up to this relative error the factor 1.5 below covers the terms of second order.
constexpr double well_known = 0x1p-6;

/// Converges quadratically: each iteration squares the difference.
double arithmetic_geometric_mean(double x, double y) {
  for (int i = 0; i < 12 && std::abs(x - y) > 0x1p-50 * x; ++i) {
    const double mean = (x + y) / 2;
    y = std::sqrt(x * y);
    x = mean;
  }
  return x;
}

/// Its c has the other sign than the other two. Of a flat body (I₃ = I₁ + I₂) it is not the greatest: |c₁| = |c₂| = 1.
Eigen::Index middle_axis(const Vec3& c) {
  Eigen::Index middle = 0;
  c.cwiseAbs().maxCoeff(&middle);
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (c[(i + 1) % 3] * c[(i + 2) % 3] > 0) middle = i;
  }
  return middle;
}

}  // namespace

Period period(const Vec3& c, double c_error, const Vec3& w, double w_error) {
  const Eigen::Index middle = middle_axis(c);
  const Eigen::Index third = (middle + 1) % 3, first = (middle + 2) % 3;
  const double a = std::abs(c[first]), b = std::abs(c[middle]), d = std::abs(c[third]);
  const double up = a * w[third] * w[third], down = d * w[first] * w[first];
  const double x2 = a * d * w[middle] * w[middle] + b * std::max(up, down);
  const double y2 = b * std::abs(up - down);

  const double share = 8 * c_error + 4 * w_error + 8 * u;
  const double x2_error = share * w.squaredNorm();
  const double y2_error = share * w.norm() * Vec3(w[first], 0, w[third]).norm();
  const double length = 2 * std::numbers::pi / arithmetic_geometric_mean(std::sqrt(x2), std::sqrt(y2));
  const double x_share = x2_error / x2, y_share = y2_error / y2;
  if (!(x_share < well_known && y_share < well_known && length <= longest)) {
    return {longest, infinity};
  }
  return {length, length * (1.5 * (x_share / 2 + y_share / 4) + 32 * u)};
}

}  // namespace touchstone::fast::motion
