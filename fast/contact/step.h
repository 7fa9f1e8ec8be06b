// Advances bodies in contact by one step of second order that never adds energy.
#pragma once

#include <vector>

#include "fast/contact/manifold.h"
#include "fast/contact/row.h"
#include "fast/motion/rigid_body_model.h"
#include "model/answers.h"

namespace touchstone::fast::contact {

/// A body of the step: one that moves, or a fixed one that supports others.
struct StepBody {
  const motion::RigidBodyModel* model = nullptr;
  State state;
  Vec3 acceleration = Vec3::Zero();  ///< m/s²; all but the contacts' (gravity, applied forces)

  bool is_fixed() const { return model->is_fixed; }
  RigidTransform transform() const;
  Mobility mobility() const;
  double kinetic_energy() const;  ///< J
};

/// A contact point between two bodies of the step, given by their indices.
struct ContactConstraint {
  std::size_t a, b;
  ContactPoint contact_point;
  Vec3 about = Vec3::Zero();  ///< its latest normal
  double friction = 0;
};

/// How fast a contact slips before a step (m/s), and after it in the same direction, without the projection.
struct Slip {
  double before = 0, after = 0;
};

struct Stepped {
  std::vector<State> after;
  std::vector<Twist> mean;  ///< over the step: takes each body from its pose before to its pose after
  std::vector<Slip> slips;  ///< of each contact; 0 where it does not press
  double residual = 0;      ///< m; how far the contacts are from what the step solves for
};

/// The states of all bodies after h. With u = the mean relative velocity at a contact over the step, φ its gap and a
/// the applied acceleration,
///
///   0 ≤ P_n ⟂ φ(after) ≥ 0,     |P_t| ≤ μ P_n, and P_t = −μ P_n u_t/|u_t| where it slips,
///   v' = v + h a + ΣP/m,      c' = c + h (v + v')/2,
///   L' = L + Σ r × P,         R' = cay(h ω̄) R,   R⁻¹ω̄ = (R⁻¹ω + R'⁻¹ω')/2,
///
/// where r is the mean of the contact's arms before and after. By Cayley's map R'x − Rx = h ω̄ × (R'x + Rx)/2, so the
/// relative displacement of the contact's points is exactly h u, and kinetic energy grows by P·u alone (Simo & Wong
/// 1991), which is not above 0: a step never adds energy, however long it is. Solved by iteration until nothing moves
/// by more than `tolerance` (m). Where φ(after) − φ(before) is not h u_n, since features move along curves, the contact
/// point is moved until it is (Gonzalez 1996), unless it is smooth. Bodies that already overlap are moved apart no
/// faster than `recovery` (m/s).
///
/// The residual of the step is h times the greatest residual of a contact (solver.h), with the contact's last normal,
/// arms and impulse, u_n = (φ(after) − φ(before))/h from the true gaps, and min(−φ(before)/h, recovery) as least_u_n:
/// how far, in m, a point still slips or gaps when it should not. It is not 0, since iterations stop.
///
/// A ball turns by exp(h ω̄) in place of cay(h ω̄): no contact depends on how it is turned.
///
/// Afterwards the remaining relative velocity at contacts that press (its tangential part only where they stick, or
/// where slip has ended) is removed from the velocities by projections, of second order in h. Where a contact slips the
/// impulse of the projection has the direction of the step's, so that friction stays μ times all of the normal impulse:
/// without that the error of a body that slides while it turns would be of first order. A projection adds no more
/// energy than friction at that contact took in the step.
///
/// The contact constraints keep their forces as the next initial guess. Error: of second order in h.
Stepped step(const std::vector<StepBody>& step_bodies, std::vector<ContactConstraint>& constraints, double h,
             double tolerance, double recovery);

/// How well contact forces within their friction cones balance all applied accelerations at rest: the greatest
/// remaining acceleration of a point, relative to the greatest applied acceleration. The contact constraints keep their
/// forces. Requires an applied acceleration.
double unbalanced(const std::vector<StepBody>& step_bodies, std::vector<ContactConstraint>& constraints);

/// Removes the approach velocities at the contacts, without restitution and with friction.
void land(std::vector<StepBody>& step_bodies, const std::vector<ContactConstraint>& constraints);

}  // namespace touchstone::fast::contact
