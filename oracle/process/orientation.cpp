#include "oracle/process/orientation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "reference/rational.h"

namespace touchstone::oracle {
namespace {

using reference::Rational;
using Exact = std::array<Rational, 3>;

Exact difference(const Vec3& to, const Vec3& from) {
  return {Rational(to.x()) - from.x(), Rational(to.y()) - from.y(), Rational(to.z()) - from.z()};
}

Exact cross(const Exact& u, const Exact& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

/// Products of three such numbers neither overflow nor underflow.
bool is_moderate(const Vec3& v) {
  return ((v.array() == 0) || (v.array().abs() > 1e-90 && v.array().abs() < 1e90)).all();
}

__extension__ using Integer = __int128;

/// The sign of the determinant, if each of the nine differences is a double and all are whole multiples of one power of
/// two, below 2^40 of it. Coordinates that people write usually are, and then 0 is found without rational numbers.
std::optional<int> in_integers(const std::array<Vec3, 3>& u, double greatest) {
  const int exponent = std::ilogb(greatest) - 38;
  if (std::abs(exponent) > 900) return std::nullopt;
  const double scale = std::ldexp(1.0, -exponent);
  std::array<std::array<Integer, 3>, 3> m;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double whole = u[i][static_cast<Eigen::Index>(j)] * scale;
      if (whole != std::trunc(whole)) return std::nullopt;
      m[i][j] = static_cast<Integer>(whole);
    }
  }
  const Integer volume = m[2][0] * (m[0][1] * m[1][2] - m[0][2] * m[1][1]) +
                         m[2][1] * (m[0][2] * m[1][0] - m[0][0] * m[1][2]) +
                         m[2][2] * (m[0][0] * m[1][1] - m[0][1] * m[1][0]);
  return (volume > 0) - (volume < 0);
}

/// Is the computed b − a exact? Its error is a double, computed here by Knuth's TwoSum.
bool is_exact(const Vec3& a, const Vec3& b, const Vec3& ab) {
  const Vec3 from_a = b - ab;
  return (((b - (ab + from_a)) + (from_a - a)).array() == 0).all();
}

}  // namespace

/// In doubles the determinant's error is less than 16u times the product of the three 1-norms: u for each difference,
/// 2u for each of its six products of three, and five sums.
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ab = b - a, ac = c - a, ad = d - a;
  if (is_moderate(ab) && is_moderate(ac) && is_moderate(ad)) {
    const double volume = ad.dot(ab.cross(ac));
    const double error = 0x1p-49 * ab.lpNorm<1>() * ac.lpNorm<1>() * ad.lpNorm<1>();
    if (std::abs(volume) > error) return volume > 0 ? 1 : -1;
    if (is_exact(a, b, ab) && is_exact(a, c, ac) && is_exact(a, d, ad)) {
      const double greatest =
          std::max({ab.lpNorm<Eigen::Infinity>(), ac.lpNorm<Eigen::Infinity>(), ad.lpNorm<Eigen::Infinity>()});
      if (greatest == 0) return 0;
      if (const auto sign = in_integers({ab, ac, ad}, greatest)) return *sign;
    }
  }
  const Exact normal = cross(difference(b, a), difference(c, a));
  const Exact out = difference(d, a);
  return (normal[0] * out[0] + normal[1] * out[1] + normal[2] * out[2]).sign();
}

bool collinear(const Vec3& a, const Vec3& b, const Vec3& c) {
  for (const Rational& component : cross(difference(b, a), difference(c, a))) {
    if (component.sign() != 0) return false;
  }
  return true;
}

}  // namespace touchstone::oracle
