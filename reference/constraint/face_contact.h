// Motion of a ball that rests on a face, until slip stops or the ball crosses an edge. All numbers are enclosures.
#pragma once

#include <optional>

#include "reference/constraint.h"
#include "reference/constraint/parabola.h"

namespace touchstone::reference {

struct RollingBall {
  Enclosed radius, mass;
  Enclosed kappa;  ///< I = κ m r²
};

/// The face that the ball rests on: perpendicular to the box's `axis`, on the side of the sign `side`.
struct Face {
  const FixedBox* box = nullptr;
  std::size_t axis = 2;
  int side = 1;

  EnclosedVec normal_B() const;
  EnclosedVec normal_W() const { return box->turned_out(normal_B()); }
  Enclosed weight() const;                   ///< N = −g·n (m/s²)
  EnclosedVec tangential_gravity_B() const;  ///< g_t
};

/// What is known of the slip of a ball on a face.
enum class SlipKnowledge {
  none,      ///< known to be exactly 0
  straight,  ///< parallel to g_t, decided exactly
  any        ///< as the velocities say
};

struct ContactLaw {
  ConstraintTruth::Mode mode = ConstraintTruth::Mode::rolling;
  Parabola path;
  std::optional<Enclosed> slip_stops;  ///< τ
  Enclosed slip_rate;                  ///< at that time: how fast |u| falls
};

/// The motion from p with velocities v and w. Ignores the part of v along n, which is 0. Throws Undecided, or
/// InputError where the direction of slip turns.
ContactLaw contact_law(const RollingBall& ball, const Face& face, const Parabola& start, SlipKnowledge slip);

/// The centre crosses the edge of the face along the axis `over`.
struct EdgeCrossing {
  Enclosed tau;
  std::size_t over = 0;
  Enclosed speed;  ///< > 0, outward
};

/// The first crossing within the horizon. Requires a centre above the interior of the face.
std::optional<EdgeCrossing> first_edge_crossing(const Face& face, const Parabola& path, const Enclosed& horizon);

/// Lower bound of the distance of the centre to the edges of the face during the next `span`, without the edges across
/// axis `but`.
Float least_inside(const Face& face, const Parabola& path, const Enclosed& span, std::optional<std::size_t> but);

}  // namespace touchstone::reference
