// What a contact does to its two bodies, as far as Newton's laws say it without any law of restitution or friction.
//
// In long double, for judging: its rounding, 2⁻⁶⁴, is far below any allowance. Written from the definitions alone and
// not from reference/impulse, so that the two can be held against each other.
#pragma once

#include <array>
#include <optional>

#include "model/answers.h"
#include "model/scene.h"
#include "oracle/world_points.h"

namespace touchstone::oracle {

using Matrix = Eigen::Matrix<Real, 3, 3>;

struct Struck {
  bool fixed = false;                   ///< then an impulse changes nothing
  Real mass = 0;                        ///< kg
  Point p_BBcm = Point::Zero();         ///< m; of a fixed body 0
  Matrix R_WB = Matrix::Identity();     ///< its axes
  Matrix I_B = Matrix::Zero();          ///< about the centre of mass (kg m²)
  Matrix I_inverse_B = Matrix::Zero();  ///< 1/(kg m²)
  Point moments = Point::Zero();        ///< principal, rising (kg m²)
  Point p_BcmC_W = Point::Zero();       ///< from the centre of mass to C (m)
  Point v_WBcm = Point::Zero();         ///< before (m/s)
  Point w_WB = Point::Zero();           ///< before (rad/s)

  /// I w and I⁻¹ L, by way of the body's axes: of a slender body the matrices in W's axes would lose digits.
  Point angular_momentum(const Point& w) const { return R_WB * (I_B * (R_WB.transpose() * w)); }
  Point spin(const Point& L) const { return R_WB * (I_inverse_B * (R_WB.transpose() * L)); }
  /// wᵀ I w, ≥ 0.
  Real spin_energy_twice(const Point& w) const {
    const Point w_B = R_WB.transpose() * w;
    return w_B.dot(I_B * w_B);
  }
};

/// A body of a valid scene as it moves now, seen from C.
Struck struck(const Scene& scene, std::size_t body, const Vec3& p_WC);

struct Impact {
  std::array<Struck, 2> bodies;       ///< A, B
  Point nhat_BA_W = Point::UnitZ();   ///< n/|n|
  Matrix K = Matrix::Zero();          ///< 1/kg: an impulse P on A at C, −P on B, changes u by K P
  Matrix K_inverse = Matrix::Zero();  ///< kg
  Point u = Point::Zero();            ///< velocity of A's point at C against B's (m/s)

  Real u_n() const { return nhat_BA_W.dot(u); }
  Point u_t() const { return u - u_n() * nhat_BA_W; }
  Real K_nn() const { return nhat_BA_W.dot(K * nhat_BA_W); }
  /// The tangential velocity that a unit of normal impulse makes.
  Point k() const { return K * nhat_BA_W - K_nn() * nhat_BA_W; }
  /// Of a change of velocity or of a velocity at C: √(uᵀ K⁻¹ u), √J.
  Real energy_norm(const Point& du) const;
  Real condition() const;   ///< of K, in the 2-norm
  Real least_mass() const;  ///< 1/m_A + 1/m_B, inverted: K ≥ 1/least_mass (kg)

  /// Velocity of A's point at C against B's, once the bodies move so.
  Point u_after(const std::array<Velocity, 2>& after) const;
};

/// K = Σ (1/m) 1 − [r]× I⁻¹ [r]×. A fixed body moves with the velocity that it has, and an impulse leaves it so.
/// Requires a valid scene with a contact.
Impact impact(const Scene& scene);

}  // namespace touchstone::oracle
