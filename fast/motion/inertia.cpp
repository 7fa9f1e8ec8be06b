#include "fast/motion/inertia.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>
#include <vector>

#include "fast/exact/vector.h"
#include "fast/lin_canny/rotation.h"
#include "fast/motion/quaternion.h"
#include "fast/motion/spread.h"
#include "model/infinity.h"
#include "model/input_error.h"

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

Spread spread(const Sphere& sphere) {
  const double r2 = sphere.radius * sphere.radius;
  const double volume = 4.1887902047863905 * sphere.radius * r2;  // 4π/3
  return {volume, Vec3::Zero(), volume * r2 / 5 * Mat3::Identity(), 16 * u * volume * r2};
}

Spread spread(const Box& box) {
  const Vec3& h = box.half_extents;
  const double volume = 8 * h.x() * h.y() * h.z();
  return {volume, Vec3::Zero(), (volume / 3 * h.cwiseProduct(h)).asDiagonal(), 8 * u * volume * h.squaredNorm()};
}

Spread spread(const Polytope& polytope) { return exact_spread(polytope).rounded; }

/// Steiner's theorem. Rotating a part rounds by 64u‖C‖; its distance from the compound's centroid rounds by 32u of the
/// lengths involved, its volume by 16u and n sums.
Spread spread(const Compound& compound) {
  std::vector<Spread> parts;
  Spread whole;
  const double n = static_cast<double>(compound.parts.size());
  for (const Part& part : compound.parts) {
    Spread posed = std::visit([](const auto& shape) { return spread(shape); }, part.shape);
    const Mat3 R = lin_canny::rotation(part.X_BP.q_WB);
    posed.centroid = R * posed.centroid + part.X_BP.p_WB;
    posed.C = R * posed.C * R.transpose();
    posed.error += 64 * u * posed.C.norm();
    whole.volume += posed.volume;
    parts.push_back(posed);
  }
  double farthest = 0;
  for (const Spread& part : parts) {
    whole.centroid += part.volume / whole.volume * part.centroid;
    farthest = std::max(farthest, part.centroid.norm());
  }
  for (const Spread& part : parts) {
    const Vec3 off = part.centroid - whole.centroid;
    whole.C += part.C + part.volume * off * off.transpose();
    whole.error += part.error + (64 + 4 * n) * u * part.volume * (off.norm() + farthest) * off.norm();
  }
  whole.error += (16 + n) * u * whole.C.norm();
  return whole;
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
  const Dyadic w(q.w), x(q.x), y(q.y), z(q.z), two(2);
  const Dyadic ww = w * w, xx = x * x, yy = y * y, zz = z * z;
  const ExactMatrix N{{{ww + xx - yy - zz, two * (x * y - w * z), two * (x * z + w * y)},
                       {two * (x * y + w * z), ww + yy - xx - zz, two * (y * z - w * x)},
                       {two * (x * z - w * y), two * (y * z + w * x), ww + zz - xx - yy}}};
  ExactMatrix D;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t l = 0; l < 3; ++l) D[i][j] = D[i][j] + N[k][i] * M[k][l] * N[l][j];
      }
    }
  }
  return D;
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

Dyadic magnitude(const Dyadic& x) { return x.sign() < 0 ? -x : x; }

/// Principal axes of M = C times any positive number, or of M = I. `error`: of M, in its unit.
Inertia in_own_axes(const ExactMatrix& M, const Mat3& about, double error, bool is_inertia) {
  Inertia found;
  found.is_aligned = false;
  found.q_BP = polished(M, axes(about));
  const ExactMatrix D = turned(M, found.q_BP);
  const Quaternion& q = found.q_BP;
  const double scale = 1 / ((q.w * q.w + q.x * q.x) + (q.y * q.y + q.z * q.z));
  const Dyadic off = magnitude(D[0][1]) + magnitude(D[1][2]) + magnitude(D[2][0]);
  double off_share = 0, least = infinity;
  for (std::size_t i = 0; i < 3; ++i) {
    const Dyadic &y = D[(i + 1) % 3][(i + 1) % 3], &z = D[(i + 2) % 3][(i + 2) % 3];
    const Dyadic moment = is_inertia ? D[i][i] : y + z;
    found.c[static_cast<Eigen::Index>(i)] = exact::ratio(is_inertia ? y - z : z - y, moment);
    off_share = std::max(off_share, exact::ratio(off, moment));
    least = std::min(least, moment.approximate() * scale * scale);
  }
  found.c_error = 6 * off_share + 8 * u;
  if (error > 0) found.c_error += 9 * error / least * (1 + 16 * u);
  if (!(found.c_error < 1)) found.c_error = 1;
  return found;
}

bool is_diagonal(const Mat3& M) { return M(0, 1) == 0 && M(0, 2) == 0 && M(1, 2) == 0; }
bool is_diagonal(const ExactMatrix& M) { return M[0][1].sign() == 0 && M[0][2].sign() == 0 && M[1][2].sign() == 0; }

/// `c` have errors of at most 5u each; that of |ω'| is at most the greatest of them over √3, since Σ ω_j² ω_k² ≤
/// |ω|⁴/3.
Inertia aligned(const Vec3& c) { return {{}, c, 3 * u * c.lpNorm<Eigen::Infinity>(), true}; }

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
    const ExactMatrix& C = whole.scaled_C;
    if (!is_diagonal(C)) return in_own_axes(C, whole.rounded.C, 0, false);
    const auto c = [&](std::size_t y, std::size_t z) { return exact::ratio(C[z][z] - C[y][y], C[y][y] + C[z][z]); };
    return aligned({c(1, 2), c(2, 0), c(0, 1)});
  }
  const Spread whole = std::visit([](const auto& s) { return spread(s); }, shape);
  return in_own_axes(exactly(whole.C), whole.C, whole.error, false);
}

}  // namespace

Inertia inertia(const Body& body) {
  return std::visit([&](const auto& mass) { return of(body.shape, mass); }, body.mass);
}

}  // namespace touchstone::fast::motion
