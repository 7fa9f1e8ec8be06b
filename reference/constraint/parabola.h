// The path of a ball between two changes, and its first contact with a box. All numbers are enclosures.
#pragma once

#include <optional>

#include "reference/exact/enclosed.h"
#include "reference/motion/plain_pose.h"

namespace touchstone::reference {

/// A fixed box, with the coefficients of its pair with the ball.
struct FixedBox {
  int body = 0;
  Square<Enclosed> axes;  ///< axes[k]: the box's k-th axis in W
  EnclosedVec origin, half;
  EnclosedVec gravity;  ///< in the box's axes
  Enclosed friction, restitution;

  EnclosedVec turned_in(const EnclosedVec& v_W) const { return times(axes, v_W); }
  EnclosedVec in(const EnclosedVec& p_W) const { return turned_in(minus(p_W, origin)); }
  EnclosedVec turned_out(const EnclosedVec& v_B) const {
    return plus(plus(scaled(v_B[0], axes[0]), scaled(v_B[1], axes[1])), scaled(v_B[2], axes[2]));
  }
};

/// From `start` on: p + v τ + a τ²/2, angular velocity w + alpha τ.
struct Parabola {
  Enclosed start;  ///< s
  EnclosedVec p, v, a, w, alpha;

  Parabola later(const Enclosed& tau) const;  ///< the same path with its start at start + τ
};

/// The path with its start at the contact with a face of the box after tau, narrowed by what is known there: the centre
/// is exactly `radius` above the face, and along its normal v² = v₀² + 2 a (x − x₀) and τ = (v − v₀)/a. So enclosures
/// do not grow from one bounce to the next. `axis` is that of the face; the ball approaches.
Parabola at_face(const Parabola& path, const Enclosed& tau, const FixedBox& box, std::size_t axis,
                 const Enclosed& radius);

/// How the ball leaves a box that it touches at τ = 0. By default it separates: v·n > 0. `turns_off`: it has just
/// crossed the edge of `face` along the axis `over` (axes of the box), with v·n = 0, and falls more slowly than the
/// circle about the edge.
struct LeavingContact {
  int body = 0;
  bool turns_off = false;
  std::size_t face = 0, over = 0;
};

/// From the box's nearest point to the ball's centre, in the box's axes. One, two or three coordinates are not 0 if the
/// centre is over a face, an edge or a corner.
EnclosedVec excess(const FixedBox& box, const EnclosedVec& centre_W);

/// The first τ in (0, horizon] at which the centre comes to the distance `radius` of the box from farther away; none if
/// there is none. Throws Undecided for grazing contact. Requires that the two are apart at τ = 0, or `leaving`.
std::optional<Enclosed> first_contact(const Parabola& path, const FixedBox& box, const Enclosed& radius,
                                      const Enclosed& horizon, const std::optional<LeavingContact>& leaving);

/// Lower bound of the distance between ball and box during the next `span`.
Float least_distance(const Parabola& path, const FixedBox& box, const Enclosed& radius, const Enclosed& span);

}  // namespace touchstone::reference
