// How long two bodies surely stay on their sides of a slab that is fixed in space.
#pragma once

#include <vector>

#include "fast/time_of_impact/side.h"

namespace touchstone::fast::meeting {

/// First h ≥ 0 at which z + s h + c h²/2 = 0, for z ≥ 0 and c ≤ 0; infinity if there is none.
double first_root(double z, double s, double c);

/// For a unit n from A to B: with heights x_i = n·p_i and speeds x_i' of A's vertices, y_j of B's,
///
///   n·(p_j − p_i)(t + h) ≥ (y_j − x_i) + (y_j' − x_i') h + c h²/2,   c = n·(a_B − a_A) − swirl_A − swirl_B,
///
/// so the least of these over all pairs, less the radii, is a lower bound of the distance at t + h. It is concave in h
/// (c > 0 counts as 0): positive at 0 and at h, it is positive between. What heights and speeds are off by is taken
/// off.
class Slab {
 public:
  Slab(const Side& A, const Side& B, const Vec3& n);

  const Vec3& direction() const { return n_; }
  /// The bound at h = 0 (m), and how much of it was taken off for rounding.
  double gap() const { return gap_; }
  double error() const { return error_; }

  /// ≤ n·(v_B − v_A) of vertices that are within `above` (m) of the gap's own, rounding taken off (m/s).
  double least_speed(double above) const;
  double speed_error() const { return speed_error_; }
  double curvature() const { return c_; }

  /// A time up to which the bound is positive, and at which its first root is, up to a billionth; at most h_max.
  /// Requires that the two are apart, or touch, at h = 0: a gap below 0 is rounding's doing and counts as 0.
  double clear_until(double h_max) const;

 private:
  /// Of vertices: n·p and its rate.
  struct Heights {
    std::vector<double> height, speed;
    void see(const Side& side, const Vec3& n, double height, double speed);
    /// Index of the one that is highest (sign 1) or lowest (−1) at h.
    std::size_t foremost(double h, double sign) const;
  };
  struct Parabola {
    double z, s;
  };
  Parabola between(double h) const;

  Vec3 n_;
  Heights A_, B_;
  double gap_ = 0, error_ = 0, radii_ = 0, speed_error_ = 0, c_ = 0;
};

}  // namespace touchstone::fast::meeting
