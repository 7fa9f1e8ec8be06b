// How long two bodies surely stay on their sides of a plane.
#pragma once

#include <limits>
#include <vector>

#include "fast/time_of_impact/side.h"

namespace touchstone::fast::meeting {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// First h ≥ 0 at which z + s h + c h²/2 = 0, for z ≥ 0; infinity if there is none.
double first_root(double z, double s, double c);

/// The plane may turn, at right angles to m(h) = n + turn h: |n| = 1, from A to B, turn ⊥ n. With a vertex at p from
/// some point near both, and p, ṗ, p̈ known at t,
///
///   m·p(t + h) = n·p + (n·ṗ + turn·p) h + (n·p̈ + 2 turn·ṗ) h²/2 + rest,   |rest| ≤ (|p⃛| + 3 |turn||p̈|) h³/6,
///
/// and h³/6 ≤ (H/3) h²/2 for h ≤ H. A plane that moves at a constant speed, halfway between the foremost vertices of
/// the two, parts the bodies until the first vertex may cross it: one quadratic a vertex. If the plane turns as the
/// features do that are closest, the gap that is left then is of third order in the step. (If it does not, the ends of
/// an edge, or the corners of a face, cross it while the closest points are still apart: each step leaves a share of
/// the gap.)
class Slab {
 public:
  /// `p_OC`: a point near both, in the pair's frame.
  Slab(const Side& A, const Side& B, const Vec3& n, const Vec3& turn, const Vec3& p_OC);

  const Vec3& direction() const { return n_; }
  /// ≤ the distance (m), and how much of it was taken off for rounding.
  double gap() const { return gap_; }
  double error() const { return error_; }

  /// Surely apart, and by more than rounding.
  bool is_clear() const { return gap_ > 2 * error_; }
  /// Of two that do not overlap: all points that may touch surely part.
  bool parts() const { return gap_ > -8 * error_ && least_speed(8 * error_) > 0; }

  /// ≤ the rate of the gap (m/s) as far as vertices rule it that are within `above` (m) of the foremost.
  double least_speed(double above) const;
  /// ≥ |n·(p̈_B − p̈_A)| of vertices, at all times (m/s²).
  double greatest_bend() const { return greatest_bend_; }

  /// A time until which the two surely stay apart, at most h_max. Requires that they are apart, or touch, at h = 0: a
  /// gap below 0 is rounding's doing and counts as 0.
  double clear_until(double h_max) const;

 private:
  struct Height {
    double height, speed, bend;
  };
  /// Of vertices, seen so that the other body is above: B's are turned round.
  struct Heights {
    std::vector<Height> of;
    double whirl = 0;
    /// As seen from a point that is at `place` (height) from the core's origin, and has the velocity `v` and the
    /// acceleration `a` against its centre of mass; `from_C`: from C to the core's origin.
    void see(const Side& side, const Vec3& up, const Vec3& turn, double place, const Vec3& from_C, const Vec3& v,
             const Vec3& a);
    double highest() const;
    double fastest(double at_least_as_high_as) const;
    /// Until when all are below a plane at height z + s h, at most H.
    double below(double z, double s, double bend_error, double H) const;
  };

  Vec3 n_;
  Heights A_, B_;
  double gap_ = 0, error_ = 0, speed_error_ = 0, bend_error_ = 0, greatest_bend_ = 0, greatest_rate_ = 0;
};

}  // namespace touchstone::fast::meeting
