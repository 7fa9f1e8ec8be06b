// What a ball does that rests on a face: its law of motion until slip stops or the face ends. All numbers enclose.
#pragma once

#include <optional>

#include "reference/constraint.h"
#include "reference/parabola_impl.h"

namespace touchstone::reference {

struct Ball {
  Enclosed radius, mass;
  Enclosed kappa;  ///< I = κ m r²
};

/// The face that the ball rests on: the box's `axis`, towards `side`.
struct Face {
  const Slab* slab = nullptr;
  std::size_t axis = 2;
  int side = 1;

  EnclosedVec normal_B() const;
  EnclosedVec normal_W() const { return slab->turned_out(normal_B()); }
  Enclosed weight() const;     ///< N = −g·n (m/s²)
  EnclosedVec pull_B() const;  ///< g_t
};

/// Slip of the ball at rest on a face.
enum class Slip {
  none,      ///< known to be exactly 0
  straight,  ///< along g_t, as was decided exactly
  any        ///< as the velocities say
};

struct ContactLaw {
  ConstraintTruth::Mode mode = ConstraintTruth::Mode::rolls;
  Parabola way;
  std::optional<Enclosed> slip_stops;  ///< τ
  Enclosed slip_rate;                  ///< then: how fast |u| falls
};

/// From v, w at p on. v's part along n is not looked at: it is 0. Throws Undecided, or InputError where slip turns.
ContactLaw contact_law(const Ball& ball, const Face& face, const Parabola& start, Slip slip);

/// Passing the edge of the face across the axis `over`.
struct Passing {
  Enclosed tau;
  std::size_t over = 0;
  Enclosed speed;  ///< > 0, outward
};

/// The first within the horizon. Requires a centre over the face's inside.
std::optional<Passing> first_passing(const Face& face, const Parabola& way, const Enclosed& horizon);

/// No more than how far the centre stays inside the face's edges over the next `span`; but for those across `but`.
Float least_inside(const Face& face, const Parabola& way, const Enclosed& span, std::optional<std::size_t> but);

}  // namespace touchstone::reference
