#include <cmath>
#include <numbers>

#include "app/adapter/paper/build.h"

namespace touchstone::app {
namespace {

const Vec3 o(0, 0, 0);

Body ball(double r, const Vec3& p, const Vec3& v = Vec3::Zero(), const Vec3& w = Vec3::Zero()) {
  return moving(body(Sphere{r}, p), v, w);
}

Body box(const Vec3& h, const Vec3& p, const Vec3& v = Vec3::Zero(), const Vec3& w = Vec3::Zero()) {
  return moving(body(Box{h}, p), v, w);
}

/// Its upper side is z = 0.
Body ground() { return fixed(box({20, 20, 1}, {0, 0, -1})); }

Body with(Body body, double e, double mu) {
  body.material = {e, mu};
  return body;
}

PaperScene first_contact(const std::string& name, Body A, Body B, double until, std::optional<double> time,
                         const Vec3& gravity = Vec3::Zero()) {
  TimeOfImpact known;
  known.status = time ? TimeOfImpact::Status::hit : TimeOfImpact::Status::miss;
  known.time = time;
  PaperScene paper{scene(name, {std::move(A), std::move(B)}), known};
  paper.scene.gravity = gravity;
  paper.scene.motion = Motion{.sample_times = {until}};
  return paper;
}

/// `states`: by sample time, then by body.
PaperScene trajectory(const std::string& name, std::vector<Body> bodies, const Vec3& gravity,
                      const std::vector<double>& times, std::vector<std::vector<State>> states) {
  Trajectory known;
  known.states = std::move(states);
  PaperScene paper{scene(name, std::move(bodies)), known};
  paper.scene.gravity = gravity;
  paper.scene.motion = Motion{.sample_times = times};
  return paper;
}

State at(const Vec3& p, const Vec3& v = Vec3::Zero(), const Vec3& w = Vec3::Zero(), const Quaternion& q = {}) {
  return {{p, q}, {v, w}};
}

State unmoved(const Body& body) { return {body.X_WB, body.velocity}; }

/// The rotation about z by an angle.
Quaternion about_z(double angle) { return {std::cos(angle / 2), 0, 0, std::sin(angle / 2)}; }

constexpr double quarter = std::numbers::pi / 2;

// e = min(0.5, 0.75). A fall of 2 m with g = 4 m/s² takes 1 s and ends at 4 m/s; then v = 2 − 4 s, for which the top is
// reached after 0.5 s, 0.5 m higher.
PaperScene bounce() {
  const Body falling = with(ball(0.5, {1, 2, 2.5}), 0.5, 0), floor = with(ground(), 0.75, 0);
  return trajectory("a ball bounces", {falling, floor}, {0, 0, -4}, {0.5, 1.5},
                    {{at({1, 2, 2}, {0, 0, -2}), unmoved(floor)}, {at({1, 2, 1}), unmoved(floor)}});
}

// Ballistic motion: p + v t + g t²/2, v + g t.
PaperScene ballistic() {
  return trajectory("ballistic motion", {ball(0.5, {0, 0, 10}, {3, 0, 2}), fixed(box({1, 1, 1}, {0, 0, -20}))},
                    {0, 0, -8}, {0.5, 1},
                    {{at({1.5, 0, 10}, {3, 0, -2}), at({0, 0, -20})}, {at({3, 0, 8}, {3, 0, -6}), at({0, 0, -20})}});
}

// The gap of 4 m closes at 4 m/s. Equal masses, e = min(0.5, 1): each leaves at half of its speed.
PaperScene head_on() {
  return trajectory(
      "balls meet head on", {with(ball(1, {-3, 0, 0}, {2, 0, 0}), 0.5, 0), with(ball(1, {3, 0, 0}, {-2, 0, 0}), 1, 0)},
      o, {0.5, 2},
      {{at({-2, 0, 0}, {2, 0, 0}), at({2, 0, 0}, {-2, 0, 0})}, {at({-2, 0, 0}, {-1, 0, 0}), at({2, 0, 0}, {1, 0, 0})}});
}

// A box that turns about a principal axis does so uniformly.
PaperScene spin() {
  const Vec3 w(0, 0, quarter), v(1, 0, 0);
  return trajectory("a box spins", {box({1, 2, 3}, o, v, w), fixed(box({1, 1, 1}, {0, 0, -20}))}, o, {0.5, 1},
                    {{at({0.5, 0, 0}, v, w, about_z(quarter / 2)), at({0, 0, -20})},
                     {at({1, 0, 0}, v, w, about_z(quarter)), at({0, 0, -20})}});
}

// The centre of mass (1, 0, 0) stays, and the body's origin turns about it: p = (1, 0, 0) − R (1, 0, 0).
PaperScene off_centre() {
  const Vec3 w(0, 0, quarter);
  const Body wheel = moving(given(body(Box{{1, 1, 1}}, o), 2, {1, 1, 1}, {1, 0, 0}), o, w);
  return trajectory("a centre of mass off the origin", {wheel, fixed(box({1, 1, 1}, {0, 0, -20}))}, o, {1, 2},
                    {{at({1, -1, 0}, o, w, about_z(quarter)), at({0, 0, -20})},
                     {at({2, 0, 0}, o, w, about_z(2 * quarter)), at({0, 0, -20})}});
}

// A fixed body keeps its velocity: its origin moves by v t, and it turns about its origin.
PaperScene turntable() {
  const Vec3 w(0, 0, quarter), v(0.5, 0, 0);
  return trajectory("a fixed body moves", {ball(1, {0, 0, 9}), moving(fixed(box({2, 1, 1}, o)), v, w)}, {0, 0, -2}, {1},
                    {{at({0, 0, 8}, {0, 0, -2}), at({0.5, 0, 0}, v, w, about_z(quarter))}});
}

// A force of 6 N on 2 kg: 3 m/s².
PaperScene force() {
  PaperScene paper =
      trajectory("an applied force", {given(ball(1, o), 2, {1, 1, 1}), fixed(box({1, 1, 1}, {0, 0, -20}))}, o, {1},
                 {{at({0, 1.5, 0}, {0, 3, 0}), at({0, 0, -20})}});
  paper.scene.motion->force_bound = 8;
  paper.scene.motion->forces = {{0, 0, {0, 6, 0}}};
  return paper;
}

/// A solid ball of radius 1/2 on the table, at the origin of its plane.
PaperScene on_table(const std::string& name, const Vec3& v, const Vec3& w, const Vec3& gravity,
                    const std::vector<double>& times, const std::vector<State>& states) {
  const Body rolling = with(ball(0.5, {0, 0, 0.5}, v, w), 0, 0.25), table = with(ground(), 0, 0.5);
  std::vector<std::vector<State>> all;
  for (State state : states) {
    state.X_WB.q_WB = not_judged;  // a rolling ball's rotation shows in its spin
    all.push_back({state, unmoved(table)});
  }
  return trajectory(name, {rolling, table}, gravity, times, all);
}

}  // namespace

std::vector<PaperScene> time_of_impact_on_paper() {
  const std::vector<Vec3> spike = {{0, 0, 0}, {1, 0, 2}, {-1, 1, 2}, {-1, -1, 2}};
  const Vec3 g(0, 0, -8);
  const double turned = std::acos(1.0 / 3);
  return in_all(
      {// the gap 10 − 2 closes at 3 m/s
       first_contact("balls head on", ball(1, {-5, 0, 0}, {2, 0, 0}), ball(1, {5, 0, 0}, {-1, 0, 0}), 4, 8.0 / 3),
       first_contact("the end is before the contact", ball(1, {-5, 0, 0}, {2, 0, 0}), ball(1, {5, 0, 0}, {-1, 0, 0}), 2,
                     std::nullopt),
       // they pass at 2.5 m, and touch at 2
       first_contact("balls that miss", ball(1, {-5, 0, 0}, {2, 0, 0}), ball(1, {5, 2.5, 0}, {-1, 0, 0}), 10,
                     std::nullopt),
       // 8/2 t² = 1.5
       first_contact("a ball falls", ball(0.5, {0, 0, 2}), ground(), 4, std::sqrt(0.375), g),
       // 4 t² − 2 t = 1.5
       first_contact("a ball is thrown up", ball(0.5, {0, 0, 2}, {1, 0, 2}), ground(), 4, (2 + std::sqrt(28.0)) / 8, g),
       // the apex is 3 above the face z = 1
       first_contact("a hull falls on its apex", moving(hull(spike, {0.5, 0.25, 4}, cyclic), {0, 0, -2}),
                     box({4, 3, 1}, {0, 0, 0}), 4, 1.5),
       // in the rod's frame the ball is at y = 1.5 cos θ, which is 0.25 + 0.25 when cos θ = 1/3
       first_contact("a rod turns into a ball", box({2, 0.25, 0.25}, o, o, {0, 0, 2}), ball(0.25, {0, 1.5, 0}), 4,
                     turned / 2),
       first_contact("a fixed rod turns into a ball", fixed(box({2, 0.25, 0.25}, o, o, {0, 0, 2})),
                     ball(0.25, {0, 1.5, 0}), 4, turned / 2),
       // a wall at 1.5 m/s: the gap 6 − 1 − 0.5
       first_contact("a moving wall", ball(0.5, {6, 0, 0}), fixed(box({1, 4, 4}, o, {1.5, 0, 0})), 4, 3)},
      three_frames());
}

std::vector<PaperScene> simulation_on_paper() {
  return in_all({ballistic(), bounce(), head_on(), spin(), off_centre(), turntable(), force()}, three_frames());
}

// Slip: v = v₀ − μ g t, and w grows by 5/2 μ g t/r, until they agree: v = 5/7 v₀. μ = min(0.25, 0.5). Rolling: 5/7 of
// the acceleration of a body that slides without friction.
std::vector<PaperScene> constraint_on_paper() {
  const Vec3 g(0, 0, -4);
  // A general turn would round gravity, and a table that is not level makes slip turn.
  const std::vector<WorldMotion> level = {{upright, {0, 0, 0}}, {quarter_about_x, {1, 2, -3}}, {cyclic, {3, -5, 2}}};
  return in_all(
      {// μ g = 1: it slips until t = 1
       on_table("a ball slips, then rolls", {3.5, 0, 0}, o, g, {0.5, 2},
                {at({1.625, 0, 0.5}, {3, 0, 0}, {0, 2.5, 0}), at({5.5, 0, 0.5}, {2.5, 0, 0}, {0, 5, 0})}),
       on_table("a ball rolls", {1, 0, 0}, {0, 2, 0}, g, {1, 2},
                {at({1, 0, 0.5}, {1, 0, 0}, {0, 2, 0}), at({2, 0, 0.5}, {1, 0, 0}, {0, 2, 0})}),
       on_table("a ball rests", o, o, g, {1}, {at({0, 0, 0.5})}),
       // a ramp with the slope 0.7/4: v = 5/7 · 0.7 t
       on_table("a ball rolls down a ramp", o, o, {0.7, 0, -4}, {1, 2},
                {at({0.25, 0, 0.5}, {0.5, 0, 0}, {0, 1, 0}), at({1, 0, 0.5}, {1, 0, 0}, {0, 2, 0})}),
       ballistic(), bounce()},
      level);
}

}  // namespace touchstone::app
