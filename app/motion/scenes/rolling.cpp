// Rolling balls: after sliding, down a ramp, on a turntable, and with an eccentric centre of mass.
#include <Eigen/Geometry>
#include <cmath>

#include "app/motion/scenes/build.h"
#include "app/motion/scenes/list.h"
#include "app/motion/scenes/truths.h"

namespace touchstone::app {
namespace {

constexpr Real g = 10;

/// κ = I/(m r²) of a solid ball.
constexpr Real kappa = Real(2) / 5;

/// Sliding: a = −μ g. The slip v − rω decreases by μ g (1 + 1/κ) per second, so the ball rolls from
/// t = κ v₀/((1+κ) μ g) on, with v₀/(1+κ) = 5 v₀/7.
Real slid(Real v0, Real mu, Real t) {
  const Real rolls = kappa * v0 / ((1 + kappa) * mu * g);
  const Real slides = std::min(t, rolls);
  return slides * (v0 - mu * g * slides / 2) + (t - slides) * v0 / (1 + kappa);
}

MotionScene slide_to_roll() {
  const double mu = 0.25, v0 = 7;
  const Scene scene = scene_of("slide_to_roll", {ball(0.5, {0, 0, 0.5}, {{v0, 0, 0}, {0, 0, 0}}), table(64)},
                               {.friction = mu, .step = 0.125, .samples = 16});
  const Path path = [=](Real t) { return Real3(slid(v0, mu, t), 0, 0.5); };
  return {scene, "slides, then rolls at 5/7 of its speed; relative to its radius", off_paths(scene, {{0, path}}, 0.5)};
}

/// The 25 balls after SimBenchmark's rolling test, with different speeds; they do not touch each other.
MotionScene rolling_balls() {
  const double mu = 0.5;
  std::vector<Body> bodies{table(64)};
  std::map<int, Path> paths;
  for (int k = 0; k < 25; ++k) {
    const double x = 4.0 * (k % 5) - 8, y = 4.0 * (k / 5) - 20, v0 = 1 + k % 5;
    paths[k + 1] = [=](Real t) { return Real3(x, y + slid(v0, mu, t), 0.5); };
    bodies.push_back(ball(0.5, {x, y, 0.5}, {{0, v0, 0}, {0, 0, 0}}));
  }
  const Scene scene = scene_of("rolling_balls", bodies, {.friction = mu, .step = 0.25, .samples = 16});
  return {scene, "25 balls slide, then roll at 5/7 of their speeds; relative to their radius",
          off_paths(scene, paths, 0.5)};
}

/// The ramp falls along (4, 0, −3)/5, tan α = 3/4, and (3, 0, 4) is 5 above its middle. All these values are exact.
/// Rolling: a = g sin α/(1 + κ), if tan α ≤ μ(1 + 1/κ); else the ball slips: a = g(sin α − μ cos α).
MotionScene ball_down_ramp(const std::string& name, double mu) {
  Body ramp = fixed_block({64, 8, 4}, Vec3::Zero());
  ramp.X_WB.q_WB = {3, 0, 1, 0};
  const Scene scene = scene_of(name, {ball(1, {3, 0, 4}), ramp}, {.friction = mu, .step = 0.125, .samples = 24});
  const Real sine = Real(3) / 5, cosine = Real(4) / 5;
  const bool rolls = sine <= cosine * mu * (1 + 1 / kappa);
  const Real a = rolls ? g * sine / (1 + kappa) : g * (sine - mu * cosine);
  const Path path = [=](Real t) { return Real3(Real3(3, 0, 4) + a * t * t / 2 * Real3(cosine, 0, -sine)); };
  return {scene,
          rolls ? "rolls: a = 5/7 g sin α; relative to its radius"
                : "slips: a = g(sin α − μ cos α); relative to its radius",
          off_paths(scene, {{0, path}}, 1)};
}

/// A table that rotates at Ω drags the ball along without slip. The friction force F in m v' = F + m g_t and
/// I ω' = −r ẑ × F, with v − r ω × ẑ = Ω ẑ × x, gives v' = ω_c ẑ × v + g_t/(1 + κ) with ω_c = Ω κ/(1 + κ): circles at
/// 2/7 of the table's rate, which drift with ẑ × g_t/(κ Ω).
MotionScene turntable(const std::string& name, const Vec3& gravity, const Vec3& v0, int samples) {
  const double spin = 2, r = 0.5;
  const Vec3 p(2, 0, r);
  Body disc = table();
  disc.velocity.w_WB = Vec3(0, 0, spin);
  const Vec3 w((spin * p.x() - v0.y()) / r, v0.x() / r, 0);
  Scene scene = scene_of(name, {ball(r, p, {v0, w}), disc}, {.friction = 0.5, .step = 0.25, .samples = samples});
  scene.gravity = gravity;
  const Real turn = spin * kappa / (1 + kappa);
  const Real3 pull = gravity.cast<Real>(), up(0, 0, 1);
  const Real3 drift = up.cross(pull) / (kappa * spin);
  const Real3 v = v0.cast<Real>() - drift, start = p.cast<Real>();
  const Path path = [=](Real t) {
    return Real3(start + drift * t + (std::sin(turn * t) * v + (1 - std::cos(turn * t)) * up.cross(v)) / turn);
  };
  return {scene, "circles at 2/7 of the table's turn, and drifts by ẑ × g_t/(κΩ); relative to its radius",
          off_paths(scene, {{0, path}}, r)};
}

/// A ball whose centre of mass is a = 1/4 below its centre rocks without slip about its lowest point: with
/// A(θ) = m(r² + a² − 2 r a cos θ) + I, A θ'' + m r a sin θ θ'² + m g a sin θ = 0 (Lagrange), integrated by Runge-Kutta
/// with steps of 2⁻¹² s. Its centre is at r(θ − θ₀).
MotionScene rocking_ball() {
  const double mass = 1, r = 1, a = 0.25, I = 0.375;
  Body body = ball(r, {0, 0, r});
  body.X_WB.q_WB = {4, 0, 1, 0};
  body.mass = MassProperties{mass, Vec3(0, 0, -a), I * Mat3::Identity()};
  const Scene scene = scene_of("rocking_ball", {body, table()}, {.friction = 1, .step = 0.125, .samples = 32});
  const Real first = 2 * std::atan(Real(1) / 4);
  const Path path = [=](Real t) {
    const auto bent = [&](Real angle, Real speed) {
      const Real A = mass * (r * r + a * a - 2 * r * a * std::cos(angle)) + I;
      return -mass * a * std::sin(angle) * (r * speed * speed + g) / A;
    };
    const auto steps = static_cast<int>(std::ceil(t * 4096));
    const Real h = steps > 0 ? t / static_cast<Real>(steps) : 0;
    Real angle = first, speed = 0;
    for (int k = 0; k < steps; ++k) {
      const Real a1 = bent(angle, speed), v1 = speed;
      const Real v2 = speed + h / 2 * a1, a2 = bent(angle + h / 2 * v1, v2);
      const Real v3 = speed + h / 2 * a2, a3 = bent(angle + h / 2 * v2, v3);
      const Real v4 = speed + h * a3, a4 = bent(angle + h * v3, v4);
      angle += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
      speed += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    return Real3(r * (angle - first), 0, r);
  };
  return {scene, "a ball with its mass off the centre rocks as its equation of motion says; relative to its radius",
          off_paths(scene, {{0, path}}, r)};
}

}  // namespace

std::vector<MotionScene> rolling_scenes() {
  return {slide_to_roll(),
          rolling_balls(),
          ball_down_ramp("ball_rolls_down_ramp", 0.5),
          ball_down_ramp("ball_slips_down_ramp", 0.125),
          turntable("turntable", {0, 0, -10}, {0, 1, 0}, 48),
          turntable("turntable_tilted", {1, 0, -10}, {0, 0, 0}, 24),
          rocking_ball(),
          rattleback()};
}

}  // namespace touchstone::app
