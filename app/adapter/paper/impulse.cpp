#include <numbers>

#include "app/adapter/paper/build.h"

namespace touchstone::app {
namespace {

/// kg. Box: 8 ρ hx hy hz; ball: 4/3 π ρ r³.
double mass_of(const Body& body) {
  if (const auto* known = std::get_if<MassProperties>(&body.mass)) return known->mass;
  const double density = std::get<Density>(body.mass).value;
  if (const auto* box = std::get_if<Box>(&body.shape)) return density * 8 * box->half_extents.prod();
  const double r = std::get<Sphere>(body.shape).radius;
  return density * 4 / 3 * std::numbers::pi * r * r * r;
}

/// At the origin, where A is above B. Poisson's, Stronge's and Newton's laws agree on all these impacts. The materials
/// of the bodies combine to the contact's coefficients by min, and by no other rule.
PaperScene impact(const std::string& name, Body A, Body B, double e, double mu, const Velocity& after_A,
                  const Velocity& after_B) {
  A.material = {e, mu + 0.5};
  B.material = {(e + 1) / 2, mu};
  // the momentum that A gains, or that B loses
  const bool A_moves = !std::holds_alternative<Fixed>(A.mass);
  const Vec3 P = A_moves ? Vec3(mass_of(A) * (after_A.v_WBcm - A.velocity.v_WBcm))
                         : Vec3(mass_of(B) * (B.velocity.v_WBcm - after_B.v_WBcm));
  PaperScene paper{scene(name, {std::move(A), std::move(B)}), Impulse{{after_A, after_B}, P, {}, {}}};
  paper.scene.contact = Contact{{0, 0, 0}, {0, 0, 1}, Law::poisson, e, mu};
  return paper;
}

/// A ball of radius 1 with m = 1 and I = 1/2, above C.
Body ball(const Vec3& v, const Vec3& w = Vec3::Zero()) {
  return moving(given(body(Sphere{1}, {0, 0, 1}), 1, {0.5, 0.5, 0.5}), v, w);
}

/// So small that it would give way if it were not fixed: at density 1 it has 2 kg.
Body ground() { return fixed(body(Box{{1, 1, 0.25}}, {0, 0, -0.25})); }

const Vec3 o(0, 0, 0);
const Velocity at_rest{};

// Two bodies in a central impact: P = (1 + e) |u_n| m_A m_B/(m_A + m_B).
std::vector<PaperScene> two_bodies() {
  const Body heavy = given(body(Sphere{1}, {0, 0, -1}), 3, {1, 1, 1});
  const Body equal = given(body(Sphere{1}, {0, 0, -1}), 1, {0.5, 0.5, 0.5});
  return {// P = 1.5 · 2 · 3/4 = 9/4
          impact("head on", ball({0, 0, -2}), heavy, 0.5, 0, {{0, 0, 0.25}, o}, {{0, 0, -0.75}, o}),
          // equal masses and e = 1: the normal velocities are exchanged
          impact("equal balls", ball({1, 0, -3}), moving(equal, {0, 0, 1}), 1, 0, {{1, 0, 1}, o}, {{0, 0, -3}, o}),
          // balls of radii 1 and 2 and densities 3 and 1 have the masses 3 : 8: P/m_A = 1.5 · 2.75 · 8/11 = 3
          impact("balls with densities", moving(dense(body(Sphere{1}, {0, 0, 1}), 3), {0, 0, -2.75}),
                 body(Sphere{2}, {0, 0, -2}), 0.5, 0, {{0, 0, 0.25}, o}, {{0, 0, -1.125}, o}),
          // the bodies separate: nothing happens
          impact("separating", ball({1, 0, 2}, {0, 1, 0}), moving(heavy, {0, 0, 1}), 0.5, 0.25, {{1, 0, 2}, {0, 1, 0}},
                 {{0, 0, 1}, o})};
}

// On a fixed body: P_n = (1 + e) |u_n| for m = 1. The ball's M is 1 + 1/(1/2) = 3: friction min(μ P_n, |u_t|/3) acts
// against the slip u_t = v_t + w × r, r = (0, 0, −1), and changes v by P_t and w by 2 r × P_t.
std::vector<PaperScene> on_the_ground() {
  return {
      impact("a bounce", ball({1, 2, -4}), ground(), 0.5, 0, {{1, 2, 2}, o}, at_rest),
      impact("no bounce", ball({1, 2, -4}), ground(), 0, 0, {{1, 2, 0}, o}, at_rest),
      // P_n = 3, μ P_n = 3/4 < 3/3
      impact("slip along x", ball({3, 0, -2}), ground(), 0.5, 0.25, {{2.25, 0, 1}, {0, 1.5, 0}}, at_rest),
      impact("slip along y", ball({0, -3, -2}), ground(), 0.5, 0.25, {{0, -2.25, 1}, {1.5, 0, 0}}, at_rest),
      // μ P_n = 6 > 3/3: it sticks
      impact("stick", ball({3, 0, -2}), ground(), 0.5, 2, {{2, 0, 1}, {0, 2, 0}}, at_rest),
      // the spin alone makes the slip w × r = (2, 0, 0), and 2/3 < 3/4 stops it
      impact("spin", ball({0, 0, -2}, {0, -2, 0}), ground(), 0.5, 0.25, {{-2.0 / 3, 0, 1}, {0, -2.0 / 3, 0}}, at_rest),
      // a conveyor belt: slip −1, and 1/3 stops it; the belt keeps its velocity
      impact("a moving fixed body", ball({0, 0, -2}), moving(ground(), {1, 0, 0}), 0.5, 0.25,
             {{1.0 / 3, 0, 1}, {0, -2.0 / 3, 0}}, {{1, 0, 0}, o}),
      // a ball that moves with the belt does not slip
      impact("at the belt's speed", ball({1, 0, -2}), moving(ground(), {1, 0, 0}), 0.5, 0.25, {{1, 0, 1}, o},
             {{1, 0, 0}, o})};
}

/// A turntable that turns about (−1, 0, z) by 2 rad/s: its point at C has the velocity (0, 2, 0), as the ball has.
PaperScene turntable() {
  Body table = moving(ground(), o, {0, 0, 2});
  table.X_WB.p_WB = {-1, 0, -0.25};
  return impact("a turning fixed body", ball({0, 2, -2}), table, 0.5, 0.25, {{0, 2, 1}, o}, {o, {0, 0, 2}});
}

/// A fixed body above: the roles are exchanged.
PaperScene ceiling() {
  Body above = ground();
  above.X_WB.p_WB = {0, 0, 0.25};
  const Body below = moving(given(body(Sphere{1}, {0, 0, -1}), 2, {1, 1, 1}), {0, 1, 3});
  return impact("a fixed body above", above, below, 0.5, 0, at_rest, {{0, 1, -1.5}, o});
}

// Without friction: K = 1/m + |r × n|²/I, P = (1 + e) |u_n|/K; v_n changes by P/m, w by r × n P/I.
std::vector<PaperScene> off_centre() {
  // the centre of mass is at (1, 0, 1): r × n = (0, 1, 0), K = 1 + 1/(1/2), P = 2 · 2/3
  const Body shifted = moving(given(body(Sphere{1}, {0, 0, 1}), 1, {0.5, 0.5, 0.5}, {1, 0, 0}), {0, 0, -2});
  // m = 48/48, I_y = (1 + 9)/3, r = (0.5, 0, −3), r × n = (0, −0.5, 0): K = 43/40, P = 1.5 · 2 · 40/43
  const double P = 120.0 / 43;
  const Velocity after{{0, 0, P - 2}, {0, -0.15 * P, 0}};
  const auto falling = [](const Vec3& h, const Turn& turn) {
    return moving(dense(body(Box{h}, {-0.5, 0, 3}, turn), 1.0 / 48), {0, 0, -2});
  };
  return {
      impact("a centre of mass off the origin", shifted, ground(), 1, 0, {{0, 0, -2.0 / 3}, {0, 8.0 / 3, 0}}, at_rest),
      impact("a box off its centre", falling({1, 2, 3}, upright), ground(), 0.5, 0, after, at_rest),
      // the frame of the same box is turned about x, so its extents are y, z exchanged
      impact("a turned box off its centre", falling({1, 3, 2}, quarter_about_x), ground(), 0.5, 0, after, at_rest)};
}

}  // namespace

std::vector<PaperScene> impulse_on_paper() {
  std::vector<PaperScene> all = two_bodies();
  for (const auto& more : {on_the_ground(), off_centre()}) all.insert(all.end(), more.begin(), more.end());
  all.push_back(turntable());
  all.push_back(ceiling());
  return in_all(all, three_frames());
}

}  // namespace touchstone::app
