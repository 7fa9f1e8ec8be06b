#include "fast/simulation/impact.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "fast/impulse.h"

namespace touchstone::fast::simulation {
namespace {

constexpr double rounding_of_gap = 0x1p-44;  // of a ball's radius; so is that of positions 256 radii away

Vec3 at_centre(const BodyMotion& m, const State& state) {
  return m.kind() == Kind::other && !m.fixed()
             ? Vec3(state.X_WB.p_WB + lin_canny::rotation(state.X_WB.q_WB) * m.model().p_BBcm)
             : state.X_WB.p_WB;
}

Vec3 velocity_at(const BodyMotion& m, const State& state, const Vec3& p_WC) {
  return state.velocity.v_WBcm + state.velocity.w_WB.cross(p_WC - at_centre(m, state));
}

/// m: from the centre of a ball to C, the middle of the gap. A member of an island may be hit across a gap as wide as
/// the envelope. Elsewhere a gap is rounding, which would only disturb the arm.
double arm(const BodyMotion& m, const Touch& touch) {
  const double r = m.radius();
  return std::abs(touch.gap) > rounding_of_gap * r ? r + touch.gap / 2 : r;
}

/// Each of the two a ball, or fixed.
bool are_balls(const BodyMotion& a, const BodyMotion& b) {
  return std::ranges::all_of(std::array{&a, &b},
                             [](const BodyMotion* m) { return m->kind() == Kind::ball || m->fixed(); });
}

/// Of the point of a ball, or of a fixed body, at C. The arm of a ball is along n: far from the origin that of C is
/// rounding, and then spin would seem to approach.
Vec3 velocity_along(const BodyMotion& m, const State& state, const Touch& touch, bool is_A) {
  if (m.kind() != Kind::ball) return velocity_at(m, state, touch.p_WC);
  const double along = is_A ? -arm(m, touch) : arm(m, touch);
  return state.velocity.v_WBcm + along * state.velocity.w_WB.cross(touch.nhat_BA_W);
}

/// With the arms by which the impulse acts: of other pairs, fast::impact takes those of C.
Vec3 relative_at(const BodyMotion& a, const State& at_a, const BodyMotion& b, const State& at_b, const Touch& touch) {
  if (!are_balls(a, b)) return relative_velocity(a, at_a, b, at_b, touch.p_WC);
  return velocity_along(a, at_a, touch, true) - velocity_along(b, at_b, touch, false);
}

double tangent_mobility(const BodyMotion& m, const Touch& touch) {
  const double r = arm(m, touch);
  return m.fixed() ? 0 : m.inverse_mass() + r * r * m.inverse_moment();
}

/// K = 1/m n̂n̂ᵀ + (1/m + r²/I)(1 − n̂n̂ᵀ), summed over both bodies; a fixed body adds nothing. With `reverses_slip`
/// the slip is reversed if friction suffices.
Vec3 impulse_of_balls(const BodyMotion& a, const BodyMotion& b, const Touch& touch, const Vec3& u,
                      const Coefficients& c, bool reverses_slip) {
  const Vec3& n = touch.nhat_BA_W;
  const double u_n = n.dot(u);
  const double p = (1 + c.restitution) * -u_n / (a.inverse_mass() + b.inverse_mass());
  const Vec3 slip = u - u_n * n;
  const double s = std::sqrt(slip.dot(slip));
  if (s == 0 || c.friction == 0) return p * n;
  const double stops = s / (tangent_mobility(a, touch) + tangent_mobility(b, touch));
  const bool turns = reverses_slip && 2 * stops <= c.friction * p;
  return p * n - (turns ? 2 * stops : std::min(c.friction * p, stops)) / s * slip;
}

Velocity velocity_after(const BodyMotion& m, const State& state, const Vec3& lever, const Vec3& P) {
  return {state.velocity.v_WBcm + m.inverse_mass() * P, state.velocity.w_WB + m.inverse_moment() * lever.cross(P)};
}

/// The body for fast/impulse.h, which needs its state and mass but not its shape.
Body without_shape(const BodyMotion& m, const State& state) {
  Body body{{}, Sphere{1}, state.X_WB, state.velocity, {}, Fixed{}};
  if (!m.fixed()) body.mass = MassProperties{m.model().mass, m.model().p_BBcm, m.model().I_BBcm_B};
  return body;
}

/// 1/m − [r]× R I⁻¹ Rᵀ [r]×, the velocity of the point at C per impulse there.
Mat3 mobility(const BodyMotion& m, const State& state, const Vec3& p_WC) {
  if (m.fixed()) return Mat3::Zero();
  const Mat3 R = lin_canny::rotation(state.X_WB.q_WB);
  const Vec3 r = p_WC - at_centre(m, state);
  Mat3 S;
  S << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  return m.inverse_mass() * Mat3::Identity() - S * (R * inertia(m).inverse() * R.transpose()) * S;
}

}  // namespace

Coefficients coefficients(const BodyMotion& a, const BodyMotion& b, Law law) {
  return {std::min(a.material().restitution, b.material().restitution),
          std::min(a.material().friction, b.material().friction), law};
}

Vec3 relative_velocity(const BodyMotion& a, const State& at_a, const BodyMotion& b, const State& at_b,
                       const Vec3& p_WC) {
  return velocity_at(a, at_a, p_WC) - velocity_at(b, at_b, p_WC);
}

double normal_velocity(const BodyMotion& a, const State& at_a, const BodyMotion& b, const State& at_b,
                       const Touch& touch) {
  return touch.nhat_BA_W.dot(relative_at(a, at_a, b, at_b, touch));
}

namespace {

ImpactResult balls_after(const BodyMotion& a, const State& at_a, const BodyMotion& b, const State& at_b,
                         const Touch& touch, const Vec3& P) {
  const Vec3& n = touch.nhat_BA_W;
  return {0, P, velocity_after(a, at_a, -arm(a, touch) * n, P), velocity_after(b, at_b, arm(b, touch) * n, -P), 0};
}

ImpactResult others_impact(const BodyMotion& a, const State& at_a, const BodyMotion& b, const State& at_b,
                           const Touch& touch, const Coefficients& c) {
  Scene scene;
  scene.bodies = {without_shape(a, at_a), without_shape(b, at_b)};
  scene.contact = Contact{touch.p_WC, touch.nhat_BA_W, c.law, c.restitution, c.friction};
  const Impacted done = fast::impact(scene);
  return {0, done.P_A_W, done.after[0], done.after[1], 0};
}

/// The result of a given impulse P on A.
ImpactResult others_after(const BodyMotion& a, const State& at_a, const BodyMotion& b, const State& at_b,
                          const Touch& touch, const Vec3& P) {
  const auto after = [&](const BodyMotion& m, const State& state, const Vec3& push) -> Velocity {
    if (m.fixed()) return state.velocity;
    const Mat3 R = lin_canny::rotation(state.X_WB.q_WB);
    const Vec3 turn = R * (inertia(m).inverse() * (R.transpose() * (touch.p_WC - at_centre(m, state)).cross(push)));
    return {state.velocity.v_WBcm + m.inverse_mass() * push, state.velocity.w_WB + turn};
  };
  return {0, P, after(a, at_a, P), after(b, at_b, -P), 0};
}

/// Adds u_n before the impact and the loss −(u + u')·P/2.
ImpactResult with_loss(ImpactResult result, const BodyMotion& a, const State& at_a, const BodyMotion& b,
                       const State& at_b, const Touch& touch, const Vec3& u) {
  const Vec3 u_after = relative_at(a, {at_a.X_WB, result.after_a}, b, {at_b.X_WB, result.after_b}, touch);
  result.u_n = touch.nhat_BA_W.dot(u);
  result.loss = -(u + u_after).dot(result.P_A_W) / 2;
  return result;
}

}  // namespace

ImpactResult impact(const BodyMotion& a, const State& at_a, const BodyMotion& b, const State& at_b, const Touch& touch,
                    const Coefficients& c) {
  const Vec3 u = relative_at(a, at_a, b, at_b, touch);
  const ImpactResult result = are_balls(a, b)
                                  ? balls_after(a, at_a, b, at_b, touch, impulse_of_balls(a, b, touch, u, c, false))
                                  : others_impact(a, at_a, b, at_b, touch, c);
  return with_loss(result, a, at_a, b, at_b, touch, u);
}

ImpactResult impulse_at(const BodyMotion& a, const State& at_a, const BodyMotion& b, const State& at_b,
                        const Touch& touch, const Vec3& P) {
  const Vec3 u = relative_at(a, at_a, b, at_b, touch);
  return with_loss(others_after(a, at_a, b, at_b, touch, P), a, at_a, b, at_b, touch, u);
}

ImpactResult micro_collision(const BodyMotion& a, const State& at_a, const BodyMotion& b, const State& at_b,
                             const Touch& touch, Coefficients c, double speed) {
  const Vec3 n = touch.nhat_BA_W, u = relative_at(a, at_a, b, at_b, touch);
  const Vec3 shift = -(n.dot(u) + speed) / 2 * n;  // to u_n'
  c.restitution = 1;
  c.law = Law::poisson;
  if (are_balls(a, b)) {
    const Vec3 P = impulse_of_balls(a, b, touch, u + shift, c, true);
    return with_loss(balls_after(a, at_a, b, at_b, touch, P), a, at_a, b, at_b, touch, u);
  }
  const Mat3 K = mobility(a, at_a, touch.p_WC) + mobility(b, at_b, touch.p_WC);
  Vec3 P = -2 * (K.inverse() * (u + shift));
  const double p = n.dot(P);
  if (!(p > 0 && (P - p * n).norm() <= c.friction * p)) {
    State shifted = at_a;
    shifted.velocity.v_WBcm += shift;
    P = others_impact(a, shifted, b, at_b, touch, c).P_A_W;
  }
  return impulse_at(a, at_a, b, at_b, touch, P);
}

}  // namespace touchstone::fast::simulation
