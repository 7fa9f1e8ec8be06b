#include "fast/simulation/rest/resting_contact.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "fast/contact/patch.h"
#include "fast/simulation/prediction/length.h"

namespace touchstone::fast::simulation {
namespace {

/// Smaller slips and slopes, relative to the quantities they are computed from, are rounding: some hundred roundings.
constexpr double negligible = 0x1p-45;

/// How long until the contact point, on the face whose normal is the block's axis `face`, crosses one of the face's
/// sides (s).
double leaves_face(const BodyMotion& block, const Vec3& s, const Vec3& v, const Vec3& a, Eigen::Index face) {
  const Mat3 R_BW = block.R_WB().transpose();
  const Vec3 s_B = R_BW * s, v_B = R_BW * v, a_B = R_BW * a;
  double first = never;
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (i == face) continue;
    for (const double side : {-1.0, 1.0}) {
      first = std::min(first, closing_time(half_extents(block)[i] - side * s_B[i], -side * v_B[i], -side * a_B[i]));
    }
  }
  return first;
}

/// λ = m r²/I of a ball.
double rolling_inertia(const BodyMotion& ball) {
  return ball.radius() * ball.radius() * ball.inverse_moment() / ball.inverse_mass();
}

/// The axis of the block along n̂; none if the contact is at an edge or corner.
std::optional<Eigen::Index> face_along(const BodyMotion& block, const Vec3& n, const Vec3& s) {
  const Vec3 n_B = block.R_WB().transpose() * n, s_B = block.R_WB().transpose() * s;
  Eigen::Index axis = 0;
  n_B.cwiseAbs().maxCoeff(&axis);
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (i != axis && (std::abs(n_B[i]) > negligible || std::abs(s_B[i]) >= half_extents(block)[i])) return {};
  }
  return axis;
}

/// The resting contact, which ends at `edge` at the latest. None if that is now: a point a rounding away from the side
/// that it moves to is at the edge.
std::optional<RestingContact> on_face_until(double edge, double now, RestingContact rest) {
  if (edge <= now) return {};
  if (edge <= rest.until) {
    rest.until = edge;
    rest.ends_by = RestingContact::End::leaves;
  }
  return rest;
}

}  // namespace

double micro_bounce_speed(double press, double envelope) { return press > 0 ? std::sqrt(2 * press * envelope) : 0; }

bool is_pulled_off(const Vec3& nhat_W, const Vec3& gravity) {
  return nhat_W.dot(gravity) > negligible * gravity.norm();
}

Vec3 face_normal(const BodyMotion& block, const Vec3& nhat_W) {
  const Vec3 n_B = block.R_WB().transpose() * nhat_W;
  Eigen::Index axis = 0;
  n_B.cwiseAbs().maxCoeff(&axis);
  const Vec3 face = n_B[axis] < 0 ? Vec3(-block.R_WB().col(axis)) : Vec3(block.R_WB().col(axis));
  return length(face - nhat_W) < 0x1p-20 ? face : nhat_W;
}

State without_normal(const BodyMotion& support, State state, const Vec3& n) {
  const Vec3 u = state.velocity.v_WBcm - support.path().v;
  state.velocity.v_WBcm -= n.dot(u) * n;
  return state;
}

State without_slip(const BodyMotion& body, const BodyMotion& block, State state, const Vec3& n) {
  if (body.kind() != Kind::ball) {
    state.velocity = {block.path().v, Vec3::Zero()};
    return state;
  }
  const double r = body.radius(), lambda = rolling_inertia(body);
  const Vec3 v = state.velocity.v_WBcm - block.path().v;
  const Vec3 slip = v - n.dot(v) * n - r * state.velocity.w_WB.cross(n);
  const Vec3 rolls = v - slip / (1 + lambda);
  state.velocity.v_WBcm = block.path().v + rolls;
  state.velocity.w_WB = n.dot(state.velocity.w_WB) * n + n.cross(rolls) / r;
  return state;
}

std::optional<RestingContact> ball_on_face(const BodyMotion& ball, const BodyMotion& block, const State& state,
                                           double t, const Vec3& n, const Vec3& gravity, double friction, double load) {
  const Vec3 s = state.X_WB.p_WB - block.path().place(t);
  const std::optional<Eigen::Index> face = face_along(block, n, s);
  if (!face) return {};
  const double r = ball.radius(), lambda = rolling_inertia(ball);
  const Vec3 v = state.velocity.v_WBcm - block.path().v, g_t = gravity - n.dot(gravity) * n;
  const double N = -load * n.dot(gravity), slope = length(g_t) > negligible * N ? length(g_t) : 0;
  const Vec3 turning = r * state.velocity.w_WB.cross(n), slip = v - n.dot(v) * n - turning;
  RestingContact rest;
  rest.nhat_W = n;
  rest.lever = rest.touch = -ball.radius() * n;
  rest.start = state;
  const bool slips = length(slip) > negligible * (length(v) + length(turning));
  if (!slips && slope <= (1 + lambda) * friction * N) {
    if (slope > 0) rest.acceleration = lambda / (1 + lambda) * g_t;
    rest.alpha = n.cross(rest.acceleration) / r;
  } else {
    const Vec3 along = slips ? Vec3(slip / length(slip)) : Vec3(g_t / slope);
    if (slope > 0 && length(along.cross(g_t)) > negligible * slope) return {};
    const Vec3 force = -friction * N * along;  // per mass
    rest.acceleration = (slope > 0 ? g_t : Vec3(Vec3::Zero())) + force;
    rest.alpha = -lambda / r * n.cross(force);
    const double rate = (slope > 0 ? g_t.dot(along) : 0) - (1 + lambda) * friction * N;
    if (slips && rate < 0) rest.until = t + length(slip) / -rate;
    rest.ends_by = RestingContact::End::slip_ends;
  }
  return on_face_until(t + leaves_face(block, s, v, rest.acceleration, *face), t, rest);
}

std::optional<RestingContact> body_on_face(const BodyMotion& body, const BodyMotion& block, State state, double t,
                                           const Vec3& n, const std::vector<Vec3>& corners, const Vec3& gravity,
                                           double friction, double rest_speed, double load) {
  const Vec3 com = body.path().place(t), w = state.velocity.w_WB, V = block.path().v;
  for (const Vec3& corner : corners) {
    const Vec3 r = corner - com;
    const Vec3 u = state.velocity.v_WBcm + w.cross(r) - V;
    if (std::abs(n.dot(u)) > rest_speed || length(w) * length(r) > rest_speed) return {};
  }
  const double g_n = -n.dot(gravity), N = load * g_n;
  const Vec3 g_t = gravity + g_n * n, slides = state.velocity.v_WBcm - V - n.dot(state.velocity.v_WBcm - V) * n;
  const double slope = length(g_t) > negligible * N ? length(g_t) : 0,
               speed = length(slides) > (friction > 0 ? rest_speed : 0) ? length(slides) : 0;
  RestingContact rest;
  rest.nhat_W = n;
  if (speed > 0 || slope > friction * N) {
    const Vec3 along = speed > 0 ? Vec3(slides / speed) : Vec3(g_t / slope);
    const bool slip_turns = friction > 0 && slope > 0 && length(along.cross(g_t)) > negligible * slope;
    if (slip_turns) return {};
    rest.acceleration = (slope > 0 ? g_t : Vec3(Vec3::Zero())) - friction * N * along;
    const double rate = (slope > 0 ? g_t.dot(along) : 0) - friction * N;
    if (speed > 0 && rate < 0) rest.until = t + speed / -rate;
    rest.ends_by = RestingContact::End::slip_ends;
  }
  state.velocity = {speed > 0 ? Vec3(V + slides) : V, Vec3::Zero()};
  rest.start = state;
  const Vec3 force = rest.acceleration - gravity - (1 - load) * g_n * n;
  const Vec3 force_point = com - n.dot(com - corners.front()) / n.dot(force) * force,
             s = force_point - block.path().place(t);
  rest.lever = force_point - state.X_WB.p_WB;
  rest.touch = body.model().solid.parts().size() > 1 ? Vec3(corners.front() - state.X_WB.p_WB) : rest.lever;
  const std::optional<Eigen::Index> face = face_along(block, n, s);
  if (!face || !contact::supports(corners, n, force_point)) return {};
  return on_face_until(t + leaves_face(block, s, state.velocity.v_WBcm - V, rest.acceleration, *face), t, rest);
}

}  // namespace touchstone::fast::simulation
