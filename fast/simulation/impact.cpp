#include "fast/simulation/impact.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "fast/impulse.h"

namespace touchstone::fast::world {
namespace {

Vec3 at_centre(const Mover& m, const State& state) {
  return m.kind() == Kind::other && !m.fixed()
             ? Vec3(state.X_WB.p_WB + lin_canny::rotation(state.X_WB.q_WB) * m.flyer().p_BBcm)
             : state.X_WB.p_WB;
}

Vec3 velocity_at(const Mover& m, const State& state, const Vec3& p_WC) {
  return state.velocity.v_WBcm + state.velocity.w_WB.cross(p_WC - at_centre(m, state));
}

double tangent_mobility(const Mover& m) {
  return m.fixed() ? 0 : m.inverse_mass() + m.radius() * m.radius() * m.inverse_moment();
}

/// K = 1/m n̂n̂ᵀ + (1/m + r²/I)(1 − n̂n̂ᵀ), summed over the two; a fixed body adds nothing. `back`: slip is turned round,
/// where friction suffices.
Vec3 impulse_of_balls(const Mover& a, const Mover& b, const Vec3& n, const Vec3& u, const Coefficients& c, bool back) {
  const double u_n = n.dot(u);
  const double p = (1 + c.restitution) * -u_n / (a.inverse_mass() + b.inverse_mass());
  const Vec3 slip = u - u_n * n;
  const double s = std::sqrt(slip.dot(slip));
  if (s == 0 || c.friction == 0) return p * n;
  const double stops = s / (tangent_mobility(a) + tangent_mobility(b));
  const bool turns = back && 2 * stops <= c.friction * p;
  return p * n - (turns ? 2 * stops : std::min(c.friction * p, stops)) / s * slip;
}

Velocity pushed(const Mover& m, const State& state, const Vec3& lever, const Vec3& P) {
  return {state.velocity.v_WBcm + m.inverse_mass() * P, state.velocity.w_WB + m.inverse_moment() * lever.cross(P)};
}

/// What fast/impulse.h needs to know of a body: where it is and what it weighs, not its shape.
Body weighed(const Mover& m, const State& state) {
  Body body{{}, Sphere{1}, state.X_WB, state.velocity, {}, Fixed{}};
  if (!m.fixed()) body.mass = MassProperties{m.flyer().mass, m.flyer().p_BBcm, m.flyer().I_BBcm_B};
  return body;
}

/// R I⁻¹ Rᵀ and −[r]× of it [r]× + 1/m.
Mat3 mobility(const Mover& m, const State& state, const Vec3& p_WC) {
  if (m.fixed()) return Mat3::Zero();
  const Mat3 R = lin_canny::rotation(state.X_WB.q_WB);
  const Vec3 r = p_WC - at_centre(m, state);
  Mat3 S;
  S << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  return m.inverse_mass() * Mat3::Identity() - S * (R * m.inertia().inverse() * R.transpose()) * S;
}

bool is_ball_or_fixed(const Mover& m) { return m.kind() == Kind::ball || m.fixed(); }

}  // namespace

Coefficients coefficients(const Mover& a, const Mover& b, Law law) {
  return {std::min(a.material().restitution, b.material().restitution),
          std::min(a.material().friction, b.material().friction), law};
}

double approach(const Mover& a, const State& at_a, const Mover& b, const State& at_b, const Touch& touch) {
  return touch.nhat_BA_W.dot(velocity_at(a, at_a, touch.p_WC) - velocity_at(b, at_b, touch.p_WC));
}

namespace {

Hit balls_hit(const Mover& a, const State& at_a, const Mover& b, const State& at_b, const Vec3& n, const Vec3& P) {
  return {0, P, pushed(a, at_a, -a.radius() * n, P), pushed(b, at_b, b.radius() * n, -P), 0};
}

Hit others_hit(const Mover& a, const State& at_a, const Mover& b, const State& at_b, const Touch& touch,
               const Coefficients& c) {
  Scene scene;
  scene.bodies = {weighed(a, at_a), weighed(b, at_b)};
  scene.contact = Contact{touch.p_WC, touch.nhat_BA_W, c.law, c.restitution, c.friction};
  const Impacted done = fast::impact(scene);
  return {0, done.P_A_W, done.after[0], done.after[1], 0};
}

/// P on A, from a given impulse.
Hit others_pushed(const Mover& a, const State& at_a, const Mover& b, const State& at_b, const Touch& touch,
                  const Vec3& P) {
  const auto after = [&](const Mover& m, const State& state, const Vec3& push) -> Velocity {
    if (m.fixed()) return state.velocity;
    const Mat3 R = lin_canny::rotation(state.X_WB.q_WB);
    const Vec3 turn = R * (m.inertia().inverse() * (R.transpose() * (touch.p_WC - at_centre(m, state)).cross(push)));
    return {state.velocity.v_WBcm + m.inverse_mass() * push, state.velocity.w_WB + turn};
  };
  return {0, P, after(a, at_a, P), after(b, at_b, -P), 0};
}

/// What it was, and what is gone: −(u + u')·P/2.
Hit booked(Hit hit, const Mover& a, const State& at_a, const Mover& b, const State& at_b, const Touch& touch,
           const Vec3& u) {
  const Vec3 u_after =
      velocity_at(a, {at_a.X_WB, hit.after_a}, touch.p_WC) - velocity_at(b, {at_b.X_WB, hit.after_b}, touch.p_WC);
  hit.u_n = touch.nhat_BA_W.dot(u);
  hit.loss = -(u + u_after).dot(hit.P_A_W) / 2;
  return hit;
}

}  // namespace

Hit impact(const Mover& a, const State& at_a, const Mover& b, const State& at_b, const Touch& touch,
           const Coefficients& c) {
  const Vec3 n = touch.nhat_BA_W, u = velocity_at(a, at_a, touch.p_WC) - velocity_at(b, at_b, touch.p_WC);
  const bool balls = is_ball_or_fixed(a) && is_ball_or_fixed(b);
  const Hit hit = balls ? balls_hit(a, at_a, b, at_b, n, impulse_of_balls(a, b, n, u, c, false))
                        : others_hit(a, at_a, b, at_b, touch, c);
  return booked(hit, a, at_a, b, at_b, touch, u);
}

Hit micro_collision(const Mover& a, const State& at_a, const Mover& b, const State& at_b, const Touch& touch,
                    Coefficients c, double speed) {
  const Vec3 n = touch.nhat_BA_W, u = velocity_at(a, at_a, touch.p_WC) - velocity_at(b, at_b, touch.p_WC);
  const Vec3 shift = -(n.dot(u) + speed) / 2 * n;  // to u_n'
  c.restitution = 1;
  c.law = Law::poisson;
  if (is_ball_or_fixed(a) && is_ball_or_fixed(b)) {
    const Vec3 P = impulse_of_balls(a, b, n, u + shift, c, true);
    return booked(balls_hit(a, at_a, b, at_b, n, P), a, at_a, b, at_b, touch, u);
  }
  const Mat3 K = mobility(a, at_a, touch.p_WC) + mobility(b, at_b, touch.p_WC);
  Vec3 P = -2 * (K.inverse() * (u + shift));
  const double p = n.dot(P);
  if (!(p > 0 && (P - p * n).norm() <= c.friction * p)) {
    State shifted = at_a;
    shifted.velocity.v_WBcm += shift;
    P = others_hit(a, shifted, b, at_b, touch, c).P_A_W;
  }
  return booked(others_pushed(a, at_a, b, at_b, touch, P), a, at_a, b, at_b, touch, u);
}

}  // namespace touchstone::fast::world
