#include "fast/motion/inertia.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "fast/exact/rotation.h"
#include "fast/lin_canny/rotation.h"
#include "fast/motion/quaternion.h"
#include "fast/motion/spread.h"

namespace touchstone::fast::motion {
namespace {

using exact::Dyadic;

ExactMatrix exactly(const Mat3& M) {
  ExactMatrix E;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) E[i][j] = Dyadic(M(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
  }
  return E;
}

/// The axes of a symmetric matrix by Jacobi's rotations, for 12 sweeps; off-diagonal entries within rounding are left.
Quaternion axes(const Mat3& C) {
  Quaternion q;
  for (int sweep = 0; sweep < 12; ++sweep) {
    for (int k = 0; k < 3; ++k) {
      const Mat3 R = lin_canny::rotation(q);
      const Mat3 D = R.transpose() * C * R;
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      if (!(std::abs(D(i, j)) > 16 * u * C.norm())) continue;
      // tan 2φ = 2 D_ij/(D_ii − D_jj) rotates axes i and j about k by φ, |φ| ≤ π/4.
      const double cotangent = (D(i, i) - D(j, j)) / (2 * D(i, j));
      const double tangent = (cotangent < 0 ? -1 : 1) / (std::abs(cotangent) + std::sqrt(1 + cotangent * cotangent));
      const double cosine = 1 / std::sqrt(1 + tangent * tangent);
      const double half_cosine = std::sqrt((1 + cosine) / 2);
      Vec3 turn = Vec3::Zero();
      turn[k] = tangent * cosine / (2 * half_cosine);
      q = product(q, {half_cosine, turn.x(), turn.y(), turn.z()});
    }
  }
  return unit(q);
}

/// |q|⁴ RᵀM R, without rounding.
ExactMatrix turned(const ExactMatrix& M, const Quaternion& q) {
  return congruent(entries(exact::scaled_rotation({q.w, -q.x, -q.y, -q.z}).rows), M);
}

/// Removes by small rotations what doubles left off the diagonal (16u of the matrix), down to the rounding of q itself.
Quaternion polished(const ExactMatrix& M, Quaternion q) {
  const ExactMatrix D = turned(M, q);
  Vec3 turn = Vec3::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const Dyadic between = D[i][i] - D[j][j];
    const double angle = between.sign() == 0 ? 0 : exact::ratio(D[i][j], between);
    if (std::abs(angle) < 0x1p-20) turn[static_cast<Eigen::Index>(k)] = angle / 2;
  }
  return unit(product(q, {1, turn.x(), turn.y(), turn.z()}));
}

/// M in doubles, as a share of its trace.
Mat3 rounded_share(const ExactMatrix& M) {
  const Dyadic whole = trace(M);
  Mat3 rounded;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      rounded(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = exact::ratio(M[i][j], whole);
    }
  }
  return rounded;
}

/// |ω'| ≤ |ω|²/√3 for any moments, so two motions differ by at most twice that.
constexpr double any_other = 1.16;

/// Principal axes of M = C times any positive number, or of M = I. `about`: M in doubles, times any positive number;
/// `error`: of each entry of C, as a share of its trace.
Inertia in_own_axes(const ExactMatrix& M, const Mat3& about, double error, bool is_inertia) {
  Inertia found;
  found.is_aligned = false;
  found.q_BP = polished(M, axes(about));
  const ExactMatrix D = turned(M, found.q_BP);
  const Dyadic off = magnitude(D[0][1]) + magnitude(D[1][2]) + magnitude(D[2][0]);
  const Dyadic whole = trace(D);
  double off_share = 0, trace_share = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Dyadic &y = D[(i + 1) % 3][(i + 1) % 3], &z = D[(i + 2) % 3][(i + 2) % 3];
    const Dyadic moment = is_inertia ? D[i][i] : y + z;
    found.c[static_cast<Eigen::Index>(i)] = exact::ratio(is_inertia ? y - z : z - y, moment);
    off_share = std::max(off_share, exact::ratio(off, moment));
    trace_share = std::max(trace_share, exact::ratio(whole, moment));
  }
  found.c_error = 6 * off_share + 8 * u;
  if (error > 0) found.c_error += 27 * error * trace_share;
  if (!(found.c_error < any_other)) found.c_error = any_other;
  return found;
}

bool is_diagonal(const Mat3& M) { return M(0, 1) == 0 && M(0, 2) == 0 && M(1, 2) == 0; }
bool is_diagonal(const ExactMatrix& M) { return M[0][1].sign() == 0 && M[0][2].sign() == 0 && M[1][2].sign() == 0; }

/// `c` have errors of at most 5u each; that of |ω'| is at most the greatest of them over √3, since Σ ω_j² ω_k² ≤
/// |ω|⁴/3.
Inertia aligned(const Vec3& c) { return {{}, c, 3 * u * c.lpNorm<Eigen::Infinity>(), true}; }

Inertia of_spread(const ScaledC& whole, const Mat3& about) {
  const ExactMatrix& C = whole.C;
  if (whole.error > 0 || !is_diagonal(C)) return in_own_axes(C, about, whole.error, false);
  const auto c = [&](std::size_t y, std::size_t z) { return exact::ratio(C[z][z] - C[y][y], C[y][y] + C[z][z]); };
  return aligned({c(1, 2), c(2, 0), c(0, 1)});
}

Inertia of(const Shape&, const Fixed&) { return {}; }

Inertia of(const Shape&, const MassProperties& given) {
  const Mat3& I = given.I_BBcm_B;
  if (is_diagonal(I)) {
    return aligned({(I(1, 1) - I(2, 2)) / I(0, 0), (I(2, 2) - I(0, 0)) / I(1, 1), (I(0, 0) - I(1, 1)) / I(2, 2)});
  }
  return in_own_axes(exactly(I), I, 0, true);
}

Inertia of(const Shape& shape, const Density&) {
  if (std::holds_alternative<Sphere>(shape)) return {};
  if (const auto* box = std::get_if<Box>(&shape)) {
    // (z − y)(z + y)/(y² + z²) for (z² − y²)/(y² + z²): the difference keeps its digits.
    const Vec3 h = box->half_extents / box->half_extents.maxCoeff();
    const auto c = [&](int i) {
      const double y = h[(i + 1) % 3], z = h[(i + 2) % 3];
      return (z - y) * (z + y) / (y * y + z * z);
    };
    return aligned({c(0), c(1), c(2)});
  }
  if (const auto* polytope = std::get_if<Polytope>(&shape)) {
    const ExactSpread whole = exact_spread(*polytope);
    const double size = whole.rounded.C.norm();
    const bool is_moderate = size > 0x1p-500 && size < 0x1p500;
    return of_spread(whole.scaled, is_moderate ? whole.rounded.C : rounded_share(whole.scaled.C));
  }
  const ScaledC whole = scaled_spread(std::get<Compound>(shape));
  return of_spread(whole, rounded_share(whole.C));
}

}  // namespace

Inertia inertia(const Body& body) {
  return std::visit([&](const auto& mass) { return of(body.shape, mass); }, body.mass);
}

}  // namespace touchstone::fast::motion
