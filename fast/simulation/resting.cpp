#include "fast/simulation/resting.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace touchstone::fast::world {
namespace {

/// Slip and slopes below this are what rounding leaves of none: some hundred roundings of what they are computed from.
constexpr double none = 0x1p-45;

double length(const Vec3& v) { return std::sqrt(v.dot(v)); }

/// When the foot, on the face whose normal is the block's axis `face`, passes one of the face's sides.
double leaves_face(const Mover& block, const Vec3& s, const Vec3& v, const Vec3& a, Eigen::Index face) {
  const Mat3 R_BW = block.R_WB().transpose();
  const Vec3 s_B = R_BW * s, v_B = R_BW * v, a_B = R_BW * a;
  double first = never;
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (i == face) continue;
    for (const double side : {-1.0, 1.0}) {
      first = std::min(first, closes(block.half_extents()[i] - side * s_B[i], -side * v_B[i], -side * a_B[i]));
    }
  }
  return first;
}

/// The block's axis along n̂; none if the touch is at an edge or corner.
std::optional<Eigen::Index> face_along(const Mover& block, const Vec3& n, const Vec3& s) {
  const Vec3 n_B = block.R_WB().transpose() * n, s_B = block.R_WB().transpose() * s;
  Eigen::Index axis = 0;
  n_B.cwiseAbs().maxCoeff(&axis);
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (i != axis && (std::abs(n_B[i]) > none || std::abs(s_B[i]) >= block.half_extents()[i])) return {};
  }
  return axis;
}

}  // namespace

double least_speed(double press, double envelope) { return press > 0 ? std::sqrt(2 * press * envelope) : 0; }

State without_normal(const Mover& support, State state, const Vec3& n) {
  const Vec3 u = state.velocity.v_WBcm - support.path().v;
  state.velocity.v_WBcm -= n.dot(u) * n;
  return state;
}

State rolling(const Mover& ball, const Mover& block, State state, const Vec3& n) {
  const Vec3 v = state.velocity.v_WBcm - block.path().v;
  state.velocity.w_WB = n.dot(state.velocity.w_WB) * n + n.cross(v) / ball.radius();
  return state;
}

std::optional<Rest> rest(const Mover& ball, const Mover& block, const State& state, double t, const Vec3& n,
                         const Vec3& gravity, double friction, double load) {
  if (ball.kind() != Kind::ball || block.kind() != Kind::block) return {};
  const Vec3 s = state.X_WB.p_WB - block.path().place(t);
  const std::optional<Eigen::Index> face = face_along(block, n, s);
  if (!face) return {};
  const double r = ball.radius(), lambda = r * r * ball.inverse_moment() / ball.inverse_mass();
  const Vec3 v = state.velocity.v_WBcm - block.path().v, g_t = gravity - n.dot(gravity) * n;
  const double N = -load * n.dot(gravity), slope = length(g_t) > none * N ? length(g_t) : 0;
  const Vec3 turning = r * state.velocity.w_WB.cross(n), slip = v - n.dot(v) * n - turning;
  Rest rest;
  rest.nhat_W = n;
  const bool slips = length(slip) > none * (length(v) + length(turning));
  if (!slips && slope <= (1 + lambda) * friction * N) {
    if (slope > 0) rest.acceleration = lambda / (1 + lambda) * g_t;
    rest.alpha = n.cross(rest.acceleration) / r;
  } else {
    const Vec3 along = slips ? Vec3(slip / length(slip)) : Vec3(g_t / slope);
    if (slope > 0 && length(along.cross(g_t)) > none * slope) return {};
    const Vec3 force = -friction * N * along;  // by mass
    rest.acceleration = (slope > 0 ? g_t : Vec3(Vec3::Zero())) + force;
    rest.alpha = -lambda / r * n.cross(force);
    const double rate = (slope > 0 ? g_t.dot(along) : 0) - (1 + lambda) * friction * N;
    if (slips && rate < 0) rest.until = t + length(slip) / -rate;
    rest.then = Rest::Then::slip_ends;
  }
  const double edge = t + leaves_face(block, s, v, rest.acceleration, *face);
  if (edge <= rest.until) {
    rest.until = edge;
    rest.then = Rest::Then::leaves;
  }
  return rest;
}

}  // namespace touchstone::fast::world
