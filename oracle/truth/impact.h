// The dynamics of a contact of two bodies that follow from Newton's laws alone, without a law of restitution or
// friction.
//
// In long double, for judging: its rounding, 2⁻⁶⁴, is far below the allowance of a subject that answers in doubles, and
// a part of that of an exact one (oracle/tolerance/impulse.h). Written from the definitions and independent of
// reference/impulse, so that the two can be compared.
#pragma once

#include <array>
#include <optional>

#include "model/answers.h"
#include "model/scene.h"
#include "oracle/truth/world_points.h"

namespace touchstone::oracle {

using Matrix = Eigen::Matrix<Real, 3, 3>;

struct ImpactBody {
  bool fixed = false;                   ///< an impulse does not change its velocity
  Real mass = 0;                        ///< kg
  Point p_BBcm = Point::Zero();         ///< m; 0 for a fixed body
  Matrix R_WB = Matrix::Identity();     ///< the body's axes
  Matrix I_B = Matrix::Zero();          ///< about the centre of mass (kg m²)
  Matrix I_inverse_B = Matrix::Zero();  ///< 1/(kg m²)
  Point moments = Point::Zero();        ///< principal moments, ascending (kg m²)
  Point p_BcmC_W = Point::Zero();       ///< from the centre of mass to C (m)
  Point v_WBcm = Point::Zero();         ///< before (m/s)
  Point w_WB = Point::Zero();           ///< before (rad/s)

  /// I w and I⁻¹ L, computed in the body's axes: for a slender body the matrices in W's axes would lose digits.
  Point angular_momentum(const Point& w) const { return R_WB * (I_B * (R_WB.transpose() * w)); }
  Point spin(const Point& L) const { return R_WB * (I_inverse_B * (R_WB.transpose() * L)); }
  /// wᵀ I w, ≥ 0.
  Real spin_energy_twice(const Point& w) const {
    const Point w_B = R_WB.transpose() * w;
    return w_B.dot(I_B * w_B);
  }
};

/// Of q/|q|.
Matrix rotation_matrix(const Quaternion& q);

/// A body of a valid scene with its present velocity, and the arm to C.
ImpactBody impact_body(const Scene& scene, std::size_t body, const Vec3& p_WC);

struct Impact {
  std::array<ImpactBody, 2> bodies;  ///< A, B
  Point nhat_BA_W = Point::UnitZ();  ///< n/|n|
  Matrix K = Matrix::Zero();         ///< 1/kg: an impulse P on A at C, −P on B, changes u by K P
  Matrix L = Matrix::Zero();         ///< kg^-1/2: K = L Lᵀ, lower triangular
  Point u = Point::Zero();           ///< velocity of A's point at C relative to B's (m/s)

  Real u_n() const { return nhat_BA_W.dot(u); }
  Point u_t() const { return u - u_n() * nhat_BA_W; }
  Real K_nn() const { return nhat_BA_W.dot(K * nhat_BA_W); }
  /// The tangential velocity caused by a unit of normal impulse.
  Point k() const { return K * nhat_BA_W - K_nn() * nhat_BA_W; }
  /// K⁻¹ du, the impulse that changes u by du (N s); and K⁻¹ itself (kg). By L: an inverse of K loses what a needle has
  /// in its stiff direction, which may be 2^-40 of the rest, to rounding.
  Point impulse_for(const Point& du) const;
  Matrix K_inverse() const;
  /// √(uᵀ K⁻¹ u), √J, for a velocity or a change of velocity at C.
  Real energy_norm(const Point& du) const;
  Real condition() const;   ///< condition number of K, in the 2-norm
  Real least_mass() const;  ///< 1/m_A + 1/m_B, inverted: K ≥ 1/least_mass (kg)

  /// Velocity of A's point at C relative to B's, for the velocities `after`.
  Point u_after(const std::array<Velocity, 2>& after) const;
};

/// K = Σ (1/m) 1 − [r]× I⁻¹ [r]×. A fixed body keeps its velocity; an impulse does not change it.
/// Requires a valid scene with a contact.
Impact impact(const Scene& scene);

}  // namespace touchstone::oracle
