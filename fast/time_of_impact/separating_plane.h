// For how long a moving plane is proved to separate two bodies.
#pragma once

#include <vector>

#include "fast/time_of_impact/moving_core.h"
#include "model/infinity.h"

namespace touchstone::fast::time_of_impact {

/// The first h ≥ 0 at which z + s h + c h²/2 = 0, for z ≥ 0; infinity if there is none.
double first_root(double z, double s, double c);

/// The plane may rotate: it is perpendicular to m(h) = n + turn h, with |n| = 1, n from A to B, and turn ⊥ n. Let a
/// vertex be at p, relative to some point near both bodies, with p, ṗ, p̈ known at t. Then
///
///   m·p(t + h) = n·p + (n·ṗ + turn·p) h + (n·p̈ + 2 turn·ṗ) h²/2 + rest,   |rest| ≤ (|p⃛| + 3 |turn||p̈|) h³/6,
///
/// and h³/6 ≤ (H/3) h²/2 for h ≤ H. A plane that moves at a constant speed, halfway between the foremost vertices of
/// the two bodies, separates them until the first vertex may cross it: one quadratic equation per vertex. If the plane
/// rotates as the closest features do, the gap at that time is of third order in the step. If it does not, the ends of
/// an edge, or the corners of a face, cross the plane while the closest points are still apart, and each step leaves a
/// fraction of the gap.
class SeparatingPlane {
 public:
  /// `p_OC`: a point near both bodies, in the pair's frame.
  SeparatingPlane(const MovingCore& A, const MovingCore& B, const Vec3& n, const Vec3& turn, const Vec3& p_OC);

  const Vec3& direction() const { return n_; }
  /// gap() ≤ the distance (m); error() is the part that was subtracted for rounding.
  double gap() const { return gap_; }
  double error() const { return error_; }

  /// Proved separated, by more than rounding.
  bool is_clear() const { return gap_ > 2 * error_; }
  /// For bodies that do not overlap: all points that may touch are proved to separate.
  bool parts() const { return gap_ > -8 * error_ && least_speed(8 * error_) > 0; }

  /// ≤ the rate of change of the gap (m/s), as determined by the vertices within `above` (m) of the foremost.
  double least_speed(double above) const;
  /// ≥ |n·(p̈_B − p̈_A)| of the vertices, at all times (m/s²).
  double greatest_bend() const { return greatest_bend_; }

  /// A time, at most h_max, until which the two are proved to stay separated. Requires that they are separated or touch
  /// at h = 0: a negative gap is due to rounding and counts as 0.
  double clear_until(double h_max) const;

 private:
  struct Height {
    double height, speed, bend;
  };
  /// The heights of the vertices, with the other body above: B's are turned upside down.
  struct Heights {
    std::vector<Height> of;
    double jerk_bound = 0;
    /// Computes the heights of `side` along `up`. The core's origin is at height `place`, and at `from_C` from C; the
    /// centre of mass has the velocity `v` and the acceleration `a`.
    void see(const MovingCore& side, const Vec3& up, const Vec3& turn, double place, const Vec3& from_C, const Vec3& v,
             const Vec3& a);
    double highest() const;
    double fastest(double at_least_as_high_as) const;
    /// A time, at most H, until which all vertices are below a plane at height z + s h.
    double below(double z, double s, double bend_error, double H) const;
  };

  Vec3 n_;
  Heights A_, B_;
  double gap_ = 0, error_ = 0, speed_error_ = 0, bend_error_ = 0, greatest_bend_ = 0, greatest_rate_ = 0;
};

}  // namespace touchstone::fast::time_of_impact
