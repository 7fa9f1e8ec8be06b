// A ball's way between two changes, and when it first meets a box. All numbers enclose.
#pragma once

#include <optional>

#include "reference/enclosed_impl.h"
#include "reference/motion_impl.h"

namespace touchstone::reference {

/// A fixed box, and what the ball and it are to each other.
struct Slab {
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

/// From `start` on: p + v τ + a τ²/2, spin w + alpha τ.
struct Parabola {
  Enclosed start;  ///< s
  EnclosedVec p, v, a, w, alpha;

  Parabola later(const Enclosed& tau) const;  ///< the same way, told from start + τ
};

/// What the ball does to a box that it touches at τ = 0. `parts`: v·n > 0. `turns_off`: it has just passed the edge of
/// `face` across `over` (axes of the box), v·n = 0, and falls slower than the circle about the edge.
struct Parting {
  int body = 0;
  bool turns_off = false;
  std::size_t face = 0, over = 0;
};

/// From a point of the box to the centre, in the box's axes: centre minus the nearest point. One, two or three
/// coordinates are not 0: over a face, an edge, a corner.
EnclosedVec excess(const Slab& slab, const EnclosedVec& centre_W);

/// The first τ in (0, horizon] at which the centre is `radius` from the box, where it was farther before; none if there
/// is none. Throws Undecided where the two graze. Requires: apart at τ = 0, or `parting`.
std::optional<Enclosed> first_meeting(const Parabola& way, const Slab& slab, const Enclosed& radius,
                                      const Enclosed& horizon, const std::optional<Parting>& parting);

/// No more than how far the ball stays from the box over the next `span`.
Float least_distance(const Parabola& way, const Slab& slab, const Enclosed& radius, const Enclosed& span);

}  // namespace touchstone::reference
