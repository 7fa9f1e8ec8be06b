#include "fast/time_of_impact/capsule.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "fast/lin_canny/rotation.h"
#include "fast/motion/steady_turn.h"
#include "model/infinity.h"

namespace touchstone::fast::time_of_impact {
namespace {

// Choices: a capsule is wider than its body, and a body whose axis turns almost as fast as itself gains nothing.
constexpr double thin = 0.25;          // of the radius over the length
constexpr double turns_slowly = 0.25;  // of the rate of the axis over that of the body

/// The axis about which a body has its least moment: c₂ > 0 > c₃.
int long_axis(const Vec3& c) {
  int axis = 0;
  while (axis < 2 && !(c[(axis + 1) % 3] > 0 && c[(axis + 2) % 3] < 0)) ++axis;
  return axis;
}

Mat3 principal_axes(const motion::RigidBodyModel& body, const lin_canny::Convex& part,
                    const lin_canny::PosedHull& core) {
  const Mat3 R_WB = part.is_posed ? Mat3(core.R.lazyProduct(part.R_BP.transpose())) : core.R;
  return body.inertia.is_aligned ? R_WB : Mat3(R_WB.lazyProduct(lin_canny::rotation(body.inertia.q_BP)));
}

/// Where the vertices of a core are along an axis e through the centre of mass, and beside it (m).
struct Extent {
  double lo = infinity, hi = -infinity, beside = 0;
};

Extent extent(const MovingCore& side, const Vec3& e) {
  Extent found;
  for (const Vec3& x : side.core.hull->vertices()) {
    const Vec3 p = side.core.turned_out(x) + side.arm;
    const double along = e.dot(p);
    found.lo = std::min(found.lo, along);
    found.hi = std::max(found.hi, along);
    found.beside = std::max(found.beside, motion::length(p - along * e));
  }
  return found;
}

}  // namespace

std::optional<AxisMotion> axis_motion(const motion::Inertia& inertia, int axis, const Vec3& w_P, double w_error,
                                      double rate) {
  const double c1 = inertia.c[axis], c2 = inertia.c[(axis + 1) % 3], c3 = inertia.c[(axis + 2) % 3];
  const double a2 = std::abs(c2), a3 = std::abs(c3), off = 16 * u + 2 * inertia.c_error;
  if (!(c2 * c3 < 0) || !(std::min(a2, a3) > 0.5) || !(off < 0x1p-20)) return {};
  const double w2 = std::abs(w_P[(axis + 1) % 3]) + w_error + off * rate;
  const double w3 = std::abs(w_P[(axis + 2) % 3]) + w_error + off * rate;
  const double across = std::sqrt(std::max(a2, a3) * (w2 * w2 / a2 + w3 * w3 / a3)) * (1 + 0x1p-16) + 4 * off * rate;
  const double kappa = std::max(std::abs(1 + c3), std::abs(1 - c2)) + off;
  AxisMotion moves;
  moves.acceleration = across * across + (kappa * across + off * rate) * rate;
  moves.jerk = ((std::abs(c2 + c3) + off) * rate + across) * across * across +
               kappa * ((std::abs(c1) + off) * across * across * across + (a2 + a3 + 2) * rate * rate * across) +
               8 * off * rate * rate * rate;
  moves.acceleration *= 1 + 0x1p-20;
  moves.jerk *= 1 + 0x1p-20;
  return moves;
}

/// Rounding of the vertices and the axis, which are turned by the same matrix, and of the distances: 96u of the reach.
/// The errors of velocities and accelerations of `side` hold for all points within its reach.
std::optional<std::array<MovingCore, 2>> capsule_about(const motion::BallisticMotion& motion, std::size_t part,
                                                       const MovingCore& side) {
  const motion::RigidBodyModel& body = motion.model();
  if (body.is_fixed || body.turning == motion::Turning::steady) return {};
  const double rate = motion.rate();
  const int axis = long_axis(body.inertia.c);
  const Mat3 R_WP = principal_axes(body, body.solid.parts()[part], side.core);
  const Vec3 e = R_WP.col(axis), turns = side.w.cross(e), bends = side.alpha.cross(e) + side.w.cross(turns);
  if (!(motion::length(turns) < turns_slowly * rate)) return {};
  const Extent of = extent(side, e);
  if (!(of.beside < thin * (of.hi - of.lo))) return {};
  const double reach = std::min(body.radius, side.arm.lpNorm<1>() + side.core.hull->radius());
  const double w_error = side.slope_error / reach + 64 * u * rate;
  const std::optional<AxisMotion> moves = axis_motion(body.inertia, axis, R_WP.transpose() * side.w, w_error, rate);
  if (!moves) return {};
  static const lin_canny::Hull point(Vec3::Zero());
  const auto end = [&](double along) {
    MovingCore ball;
    ball.core.hull = &point;
    ball.core.t = (side.core.t - side.arm) + along * e;
    ball.core.turn_error = 0;
    ball.core.shift_error =
        side.core.shift_error + (side.core.turn_error + 64 * u) * reach + 4 * u * side.core.t.lpNorm<1>();
    ball.radius = of.beside + side.radius + 96 * u * reach;
    ball.v = side.v + along * turns;
    ball.slope_error = side.slope_error + 64 * u * (side.v.lpNorm<1>() + reach * rate);
    ball.acceleration = side.acceleration + along * bends;
    ball.acceleration_bound = 2 * moves->acceleration * std::abs(along);
    ball.bend_error = side.bend_error + (128 * u + body.inertia.c_error) * rate * rate * reach;
    ball.jerk_bound = moves->jerk * std::abs(along);
    return ball;
  };
  return std::array<MovingCore, 2>{end(of.lo), end(of.hi)};
}

}  // namespace touchstone::fast::time_of_impact
