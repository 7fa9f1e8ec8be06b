#include "fast/simulation/response.h"

#include <algorithm>

#include "fast/simulation/rest/resting_contact.h"

namespace touchstone::fast::simulation {
namespace {

constexpr double solver_accuracy = 0x1p-40;  // of speeds: contacts are solved to 2^-44 (contact/solver.h)

// Rebound speeds: a pair in contact that separates no faster stays in contact until it is apart. Half of releases_above
// (island_event.cpp), so that no body is released by one rule and kept by the other.
constexpr double stays_below = 32;

}  // namespace

Response classify(const ContactSpeeds& speeds, bool has_closed_form, bool micro_collisions) {
  const double separates_above = speeds.in_contact ? stays_below * speeds.bounce_speed : speeds.bounce_speed / 16;
  if (speeds.u_n > separates_above) return Response::later;
  if (speeds.is_slow()) {
    if (speeds.in_contact || !has_closed_form) {
      return micro_collisions ? Response::micro_collision : Response::join_island;
    }
    if (-speeds.u_n <= speeds.bounce_speed) return Response::rest;
  }
  return speeds.u_n < 0 ? Response::impact : Response::later;
}

double speed_bound(const BodyMotion& body, const Velocity& V) {
  return V.v_WBcm.norm() + body.radius() * V.w_WB.norm();
}

double centripetal_bound(const World& world, const Islands& islands, BodyId a, BodyId b) {
  const auto of = [&](BodyId id) {
    const BodyMotion& body = world.body(id);
    return body.kind() == Kind::other ? body.radius() * islands.state(id).velocity.w_WB.squaredNorm() : 0;
  };
  return of(a) + of(b);
}

double rebound_speed(const World& world, const Islands& islands, BodyId a, BodyId b) {
  const double acceleration = std::max(world.acceleration(a).norm(), world.acceleration(b).norm());
  if (acceleration > 0) return micro_bounce_speed(acceleration, world.envelope());
  const double swings = micro_bounce_speed(centripetal_bound(world, islands, a, b), world.envelope());
  if (world.coefficients(a, b).restitution == 1) return swings;
  // An impact leaves the rounding of the velocities before it.
  const auto speed = [&](BodyId id) {
    return std::max(speed_bound(world.body(id), islands.state(id).velocity), world.speed_before_impacts(id));
  };
  return std::max(swings, solver_accuracy * (speed(a) + speed(b)));
}

ContactSpeeds contact_speeds(const World& world, const Islands& islands, BodyId a, BodyId b, const Touch& touch,
                             double u_n, bool in_contact) {
  if (in_contact) return {u_n, rebound_speed(world, islands, a, b), true};
  const double presses = pressing_acceleration(world.body(a), world.body(b), touch);
  const bool may_turn = presses <= 0 && world.coefficients(a, b).restitution < 1;
  const double turns = may_turn ? centripetal_bound(world, islands, a, b) : 0;
  return {u_n, micro_bounce_speed(std::max(presses, turns), world.envelope()), false};
}

}  // namespace touchstone::fast::simulation
