// Bouncing balls: up to the limit of infinitely many bounces, and with friction and spin.
#include <Eigen/Geometry>
#include <cmath>

#include "app/motion/scenes/build.h"
#include "app/motion/scenes/list.h"
#include "app/motion/scenes/truths.h"

namespace touchstone::app {
namespace {

/// The height above the ground of a ball that is dropped from height h at rest. It falls for √(2h/g) and lands with
/// v = √(2gh). Then it flies for 2 eⁿ v/g between bounces; these times sum up to 2v/g · e/(1 − e).
Real height(Real h, Real g, Real e, Real t) {
  const Real fall = std::sqrt(2 * h / g);
  if (t <= fall) return h - g * t * t / 2;
  Real v = e * g * fall;
  const Real rest = e < 1 ? fall + 2 * v / (g * (1 - e)) : INFINITY;
  if (t >= rest) return 0;
  t -= fall;
  for (; t > 2 * v / g; v *= e) t -= 2 * v / g;
  return t * (v - g * t / 2);
}

/// Lengths are multiplied by unit², times by unit.
MotionScene bouncing_ball(const std::string& name, double e, double unit, int samples) {
  const double metre = unit * unit;
  const double radius = metre / 2, h = 1.25 * metre;
  Scene scene = scene_of(name, {ball(radius, {0, 0, radius + h}), table(32 * metre)},
                         {.restitution = e, .step = unit / 16, .samples = samples});
  scene.bodies[1].shape = Box{Vec3(32, 32, 1) * metre};
  scene.bodies[1].X_WB.p_WB = Vec3(0, 0, -metre);
  const Path path = [=](Real t) { return Real3(0, 0, radius + height(h, 10, e, t)); };
  return {scene, "height of a ball dropped from h; relative to h", off_paths(scene, {{0, path}}, h)};
}

/// A ball of radius r with κ = I/(m r²) = 2/5 that hits the ground at C: K = diag(7/2, 7/2, 1)/m, so the impulse
/// P_t = −(2/7) m u_t stops its slip; friction allows at most μ(1 + e) m |u_n|. (docs/design/impulse.md)
struct RoughBall {
  Real3 p, v, w;

  void bounce(Real r, Real e, Real mu) {
    const Real3 up(0, 0, 1);
    Real3 u = v - r * w.cross(up);
    const Real normal = -(1 + e) * v.z();  // for unit mass
    u.z() = 0;
    const Real slip = u.norm();
    const Real stopping = slip > 0 ? std::min(mu * normal / slip, Real(2) / 7) : 0;
    const Real3 tangential = -stopping * u;
    v += tangential + normal * up;
    w += -r * up.cross(tangential) / (Real(2) / 5 * r * r);
  }
};

Path rough_path(const Body& body, Real g, Real e, Real mu) {
  const Real r = std::get<Sphere>(body.shape).radius;
  const RoughBall start{body.X_WB.p_WB.cast<Real>(), body.velocity.v_WBcm.cast<Real>(),
                        body.velocity.w_WB.cast<Real>()};
  return [=](Real t) {
    RoughBall now = start;
    while (true) {
      const Real fall = (now.v.z() + std::sqrt(now.v.z() * now.v.z() + 2 * g * (now.p.z() - r))) / g;
      const Real3 down(0, 0, -g);
      const Real flown = std::min(t, fall);
      now.p += flown * (now.v + flown / 2 * down);
      now.v += flown * down;
      if (t <= fall) return now.p;
      t -= fall;
      now.p.z() = r;
      now.bounce(r, e, mu);
    }
  };
}

MotionScene rough_ball() {
  const double e = 0.75, mu = 0.25;
  const Body body = ball(0.5, {0, 0, 1.75}, {{2, 1, 0}, {16, -24, 4}});
  const Scene scene =
      scene_of("rough_ball", {body, table()}, {.restitution = e, .friction = mu, .step = 0.125, .samples = 20});
  return {scene, "a spinning ball's bounces: P_t = min(μ(1+e) m|u_n|, 2/7 m|u_t|); relative to its radius",
          off_paths(scene, {{0, rough_path(body, 10, e, mu)}}, 0.5)};
}

/// The 49 balls after SimBenchmark's elastic test: dropped from different heights; they do not touch each other.
MotionScene balls_49() {
  std::vector<Body> bodies{table()};
  for (int k = 0; k < 49; ++k) bodies.push_back(ball(0.5, {2.0 * (k % 7) - 6, 2.0 * (k / 7) - 6, 1.5 + k / 64.0}));
  const Scene scene = scene_of("balls_49", bodies, {.restitution = 1, .step = 0.25, .samples = 80});
  return {scene, "49 balls dropped, e = 1: energy stays; relative to it", off_energy(scene)};
}

}  // namespace

std::vector<MotionScene> bouncing_scenes() {
  return {bouncing_ball("bouncing_ball", 0.5, 1, 48),
          bouncing_ball("bouncing_ball_forever", 1, 1, 320),
          bouncing_ball("bouncing_ball_slow_to_rest", 0.9375, 1, 320),
          bouncing_ball("bouncing_ball_micro", 0.5, 0x1p-10, 48),
          bouncing_ball("bouncing_ball_mega", 0.5, 0x1p10, 48),
          rough_ball(),
          balls_49()};
}

}  // namespace touchstone::app
