// Bodies in contact, moved on together by one step of second order that makes no energy.
#pragma once

#include <vector>

#include "fast/constraint/solve.h"
#include "fast/contact/footing.h"
#include "fast/motion/flyer.h"
#include "model/answers.h"

namespace touchstone::fast::contact {

/// A body that takes part: one that moves, or one that is fixed and carries.
struct Member {
  const motion::Flyer* flyer = nullptr;
  State state;
  Vec3 pull = Vec3::Zero();  ///< m/s²; what accelerates it but for contacts

  bool is_fixed() const { return flyer->is_fixed; }
  Stance stance() const;
  constraint::Mobility mobility() const;
};

/// A foot between two members.
struct Hold {
  std::size_t a, b;
  Foot foot;
  Vec3 about = Vec3::Zero();  ///< its normal of late
  double friction = 0;
};

struct Stepped {
  std::vector<State> after;
  std::vector<constraint::Twist> mean;  ///< of the step, with which the bodies get from one stance to the other
};

/// All members after h. With u = the mean relative velocity at a foot over the step and φ its gap,
///
///   0 ≤ P_n ⟂ φ(after) ≥ 0,     |P_t| ≤ μ P_n, and P_t = −μ P_n u_t/|u_t| where it slips,
///   v' = v + h pull + ΣP/m,   c' = c + h (v + v')/2,
///   L' = L + Σ r × P,         R' = cay(h ω̄) R,   R⁻¹ω̄ = (R⁻¹ω + R'⁻¹ω')/2,
///
/// r the mean of the foot's arms before and after. By Cayley's map R'x − Rx = h ω̄ × (R'x + Rx)/2, so what a foot's
/// points move apart is exactly h u, and kinetic energy grows by P·u alone (Simo & Wong 1991), which is not above 0:
/// a step makes no energy, however long. Solved by iteration until nothing moves by more than `tolerance` (m). What
/// overlaps already is moved apart no faster than `recovery` (m/s).
///
/// Then what of u is left after, where feet stick and press, is taken from the velocities: projections, which take
/// energy only, of second order in h.
///
/// The feet keep their impulses as the next guess. Error: of second order in h.
Stepped step(const std::vector<Member>& members, std::vector<Hold>& holds, double h, double tolerance, double recovery);

/// How well forces at the feet, in their cones, balance all pulls at rest: the greatest acceleration that is left of a
/// point, as a share of the greatest pull. The feet keep their forces (times 1 s). Requires a pull.
double unbalanced(const std::vector<Member>& members, std::vector<Hold>& holds);

/// Takes from the velocities what approaches at the feet, without restitution and with friction.
void land(std::vector<Member>& members, const std::vector<Hold>& holds);

}  // namespace touchstone::fast::contact
