// A rattleback: spun in the wrong direction it rattles, stops and turns back.
#include <Eigen/Dense>
#include <cmath>

#include "app/motion/scenes/build.h"
#include "app/motion/scenes/list.h"
#include "app/motion/scenes/truths.h"

namespace touchstone::app {
namespace {

constexpr double mass = 1, g = 10;
constexpr double radius = 0.5;  ///< of each ball, and so across the bow
constexpr double bow = 1;       ///< radius of the arc of the balls' centres; along the bow: bow + radius
constexpr double low = 0.125;   ///< distance of the centre of mass below the centre of the lowest ball, the origin
constexpr int balls = 32;       ///< on each side of the lowest ball; 1/64 rad from one to the next

/// The principal axes are rotated by 22.5° against the bow.
Mat3 inertia() { return Mat3{{0.125, 0.1875, 0}, {0.1875, 0.5, 0}, {0, 0, 0.5625}}; }
const Vec3 first_w(0, 1.5, 1);

/// Placed by tangents of half angles, so that the doubles are the same on every machine.
Shape bow_of_balls() {
  Compound compound;
  for (int k = -balls; k <= balls; ++k) {
    const double tangent = k / 128.0, share = bow / (1 + tangent * tangent);
    const Vec3 centre(2 * tangent * share, 0, 2 * tangent * tangent * share);
    compound.parts.push_back({{centre, {}}, Sphere{radius}});
  }
  return compound;
}

/// Two vectors in the body's axes: the direction down, and the angular momentum about the contact point.
using Rolling = Eigen::Matrix<Real, 6, 1>;
using Real33 = Eigen::Matrix<Real, 3, 3>;

/// From the contact point to the centre of mass. The arc's outermost point along d is bow (e + ẑ), where e is the
/// direction of d's part in the arc's plane.
Real3 arm(const Real3& d) {
  const Real3 e = Real3(d.x(), 0, d.z()).normalized();
  return -bow * e - radius * d - (bow + low) * Real3::UnitZ();
}

/// The rate of `arm` when d changes at the rate d_rate.
Real3 arm_rate(const Real3& d, const Real3& d_rate) {
  const Real turn = (d.z() * d_rate.x() - d.x() * d_rate.z()) / std::pow(std::hypot(d.x(), d.z()), Real(3));
  return -bow * turn * Real3(d.z(), 0, -d.x()) - radius * d_rate;
}

Real33 inertia_about_touch(const Real3& d) {
  const Real3 c = arm(d);
  return inertia().cast<Real>() + mass * (c.squaredNorm() * Real33::Identity() - c * c.transpose());
}

Real3 spin_of(const Rolling& now) { return inertia_about_touch(now.head<3>()).inverse() * now.tail<3>(); }

/// Without slip v = ω × c, so the contact point moves by −c', where c' is the rate of c in the body's axes, and about
/// it L' = c × m g d + c' × m v. In these axes d and L also rotate by −ω.
Rolling rate(const Rolling& now) {
  const Real3 d = now.head<3>(), L = now.tail<3>(), w = spin_of(now), c = arm(d);
  const Real3 d_rate = d.cross(w);
  Rolling made;
  made << d_rate, L.cross(w) + mass * (g * c.cross(d) + arm_rate(d, d_rate).cross(w.cross(c)));
  return made;
}

/// The spin about the vertical (rad/s), by Runge-Kutta with steps of 2⁻¹⁰ s.
Real spin_at(Real t) {
  const auto steps = static_cast<int>(std::ceil(t * 1024));
  const Real h = steps > 0 ? t / static_cast<Real>(steps) : 0;
  const Real3 down(0, 0, -1);
  Rolling now;
  now << down, inertia_about_touch(down) * first_w.cast<Real>();
  for (int k = 0; k < steps; ++k) {
    const Rolling r1 = rate(now), r2 = rate(now + h / 2 * r1), r3 = rate(now + h / 2 * r2), r4 = rate(now + h * r3);
    now += h / 6 * (r1 + 2 * r2 + 2 * r3 + r4);
  }
  return -now.head<3>().dot(spin_of(now));
}

}  // namespace

/// Balls are the only smooth shapes of a scene, so this body is a bow of balls: across the bow it is round; along the
/// bow it rocks from ball to ball, and loses energy whenever the next one comes down. The total loss is proportional to
/// the distance between balls: 33, 65, 129 and 257 balls on the same arc, simulated by `fast`, have errors of 4.6, 3.5,
/// 1.5 and 0.7 % of the initial spin, also with four times as many steps.
MotionScene rattleback() {
  Body body = body_of(bow_of_balls(), {0, 0, radius}, {first_w.cross(Vec3(0, 0, radius - low)), first_w});
  body.mass = MassProperties{mass, Vec3(0, 0, -low), inertia()};
  const Scene scene = scene_of("rattleback", {body, table()}, {.g = g, .friction = 1, .step = 0.125, .samples = 20});
  return {
      scene,
      "a smooth rattleback turns back, as its equations of motion say; this one is a bow of 65 balls, which is 3.5 % "
      "off however well it is followed; relative to its first spin",
      off_spin(scene, 0, spin_at, first_w.z())};
}

}  // namespace touchstone::app
