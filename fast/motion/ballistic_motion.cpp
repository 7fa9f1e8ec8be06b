#include "fast/motion/ballistic_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <variant>

#include "fast/lin_canny/rotation.h"
#include "fast/motion/quaternion.h"
#include "fast/motion/steady_turn.h"
#include "fast/outward/displacement.h"
#include "fast/outward/outward.h"

namespace touchstone::fast::motion {
namespace {

using lin_canny::rotation;

/// Ω² = |ω|² + c_j c_k ω_i², where i is the middle axis, the only one with c_j c_k ≥ 0. (2T(1/I₁ + 1/I₃) − L²/(I₁I₃) is
/// Σ ω_i² I_i (I₁ + I₃ − I_i)/(I₁I₃), and I₂(I₁ + I₃ − I₂) = I₁I₃ + (I₁ − I₂)(I₂ − I₃).) The exact c differ by up to
/// c_error, and a motion by the exact Euler equations has the exact ones: the bound covers both.
double greatest_rate(const Inertia& inertia, const Vec3& w_P) {
  const double rate = length(w_P);
  if (rate == 0 || inertia.c.isZero(0)) return rate * (1 + 8 * u);
  const Vec3& c = inertia.c;
  const Vec3 s = w_P / rate;
  double sum = 1;
  for (int i = 0; i < 3; ++i) {
    const double product = c[(i + 1) % 3] * c[(i + 2) % 3] + 3 * inertia.c_error;
    sum += std::max(0.0, product) * s[i] * s[i];
  }
  return rate * std::sqrt(sum) * (1 + 128 * u);
}

/// p̈ − c̈ = α × r + ω × (ω × r), and α_i = c_i ω_j ω_k: |α|² ≤ max c² |ω|⁴/3.
double greatest_acceleration_per_radius(const Inertia& inertia, double rate) {
  const double c = inertia.c.lpNorm<Eigen::Infinity>() + 2 * inertia.c_error;
  return rate * rate * (1 + c / std::numbers::sqrt3) * (1 + 8 * u);
}

/// With c as above, |α| ≤ cΩ²/√3 and, in the body's axes, |α'| ≤ 2c|α|Ω; so p''' = α' × r + 2α × (ω × r) + ω × (α × r)
/// + ω × (ω × (ω × r)), where α' = (α' in the body) + ω × α, is at most (1 + (4c + 2c²)/√3) Ω³ |r|.
double greatest_jerk_per_radius(const Inertia& inertia, double rate) {
  const double c = inertia.c.lpNorm<Eigen::Infinity>() + 2 * inertia.c_error;
  return rate * rate * rate * (1 + (4 * c + 2 * c * c) / std::numbers::sqrt3) * (1 + 8 * u);
}

/// R maps axes to axes exactly, if a quaternion's components are each 0 or of one common size, and not exactly three of
/// them differ from 0. Products with R are then exact.
bool maps_axes(const Quaternion& q) {
  const std::array<double, 4> sizes{std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)};
  const double size = *std::ranges::max_element(sizes);
  const auto zeros = std::ranges::count(sizes, 0.0);
  return zeros != 1 && std::ranges::count(sizes, size) + zeros == 4;
}

/// A spin about a principal axis then persists, even about the middle axis, from which any rounding would lead away.
bool is_along_own_axis(const RigidBodyModel& model, const Quaternion& q_WB, const Vec3& w_WB) {
  return model.inertia.is_aligned && maps_axes(q_WB) && ((rotation(q_WB).transpose() * w_WB).array() != 0).count() <= 1;
}

/// α = I⁻¹ (Iω × ω) in W; its components in P are c_i ω_j ω_k.
Vec3 spin_up(const Inertia& inertia, const Quaternion& q_WB, const Vec3& w_WB) {
  Mat3 R_WP = rotation(q_WB);
  if (!inertia.is_aligned) R_WP = R_WP.lazyProduct(rotation(inertia.q_BP)).eval();
  const Vec3 w = R_WP.transpose() * w_WB;
  const Vec3& c = inertia.c;
  return R_WP * Vec3(c[0] * w[1] * w[2], c[1] * w[2] * w[0], c[2] * w[0] * w[1]);
}

}  // namespace

BallisticMotion::BallisticMotion(const RigidBodyModel& model, double since, const Pose& X_WB, const Velocity& velocity,
                                 const Vec3& acceleration, Against against)
    : model_(&model),
      turning_(model.turning),
      against_(against),
      since_(since),
      start_(X_WB),
      velocity_(velocity),
      acceleration_(acceleration) {
  if (model.is_fixed) acceleration_ = Vec3::Zero();
  p_BBcm_W_ = model.p_BBcm.isZero(0) ? model.p_BBcm : Vec3(rotation(X_WB.q_WB) * model.p_BBcm);
  if (is_along_own_axis(model, X_WB.q_WB, velocity.w_WB)) turning_ = Turning::steady;
  if (turning_ != Turning::tumbling) {
    rate_ = length(velocity.w_WB) * (1 + 8 * u);
  } else {
    // Rotated once into B and, unless B's axes are P's, once more: 18u each time, unless exactly.
    const double w_error = (maps_axes(X_WB.q_WB) ? 0 : 18 * u) + (model.inertia.is_aligned ? 0 : 18 * u);
    Vec3 w_P = rotation(X_WB.q_WB).transpose() * velocity.w_WB;
    if (!model.inertia.is_aligned) w_P = rotation(model.inertia.q_BP).transpose() * w_P;
    rate_ = greatest_rate(model.inertia, w_P);
    tumble_ = Tumble(model.inertia.c, model.inertia.c_error, w_P, w_error);
  }
  acceleration_per_radius_ = greatest_acceleration_per_radius(model.inertia, rate_);
  jerk_per_radius_ = greatest_jerk_per_radius(model.inertia, rate_);
}

/// τ, v τ and a τ²/2 round by u, 3u and 6u (a itself by 64u more), p_WB − O by u, R p_BBcm by 18u; then there are three
/// sums. If the exact centre of mass differs by δ in the body, the computed point moves along the same parabola but
/// rotates: 2δ.
Centre BallisticMotion::centre(double t, const Origin& O) const {
  const double tau = t - since_;
  const Vec3 start = (start_.p_WB - O.p_WO) + p_BBcm_W_;
  const Vec3 gained = (acceleration_ - O.a_WO) * tau;
  const Vec3 moved = (velocity_.v_WBcm + gained / 2) * tau;
  const double lengths = (start_.p_WB - O.p_WO).lpNorm<1>() + velocity_.v_WBcm.lpNorm<1>() * tau;
  const double fallen = gained.lpNorm<1>();
  return {
      start + moved, velocity_.v_WBcm + gained,
      8 * u * lengths + 32 * u * p_BBcm_W_.lpNorm<1>() + 40 * u * fallen * tau + 2 * model_->centre_error + 0x1p-1000,
      4 * u * velocity_.v_WBcm.lpNorm<1>() + 72 * u * fallen};
}

/// Errors of the rotation: q₀/|q₀| 24u, each product of quaternions 16u, R's own rounding 12u; q_BP 24u (twice), but it
/// is 1, and its products exact, if the axes are B's.
Kinematics BallisticMotion::kinematics(double t, const Origin& O) const {
  const double tau = t - since_;
  Kinematics now{centre(t, O), start_.q_WB, {}, velocity_.w_WB, 12 * u, 0, Vec3::Zero()};
  const Vec3& w = velocity_.w_WB;
  if (turns() && tau > 0) {
    const Quaternion q_WB0 = unit(start_.q_WB);
    if (turning_ == Turning::steady) {
      const SteadyTurn turn = steady_turn(w, tau);
      now.q_WB = product(turn.q, q_WB0);
      now.turn_error = turn.error + 56 * u;
    } else if (turning_ == Turning::precessing) {
      // With moments I about axis a and J about the others, ω = L/J + s e_a and s = (1 − I/J) ω_a = c ω_a: the body
      // rotates about L at L/J and about its own axis at s. ω_a, s, e_a and L/J have errors of 25u, 32|c|u, 42u and
      // (78|c| + 2)u of |ω|: of a body that is nearly round, L/J is nearly ω.
      const int a = model_->axis;
      const double c = model_->inertia.c[(a + 1) % 3];
      const Vec3 e_W = rotation(q_WB0).col(a);
      const double s = c * e_W.dot(w);
      const SteadyTurn about_L = steady_turn(w - s * e_W, tau);
      const SteadyTurn about_e = steady_turn(s * Vec3::Unit(a), tau);
      now.q_WB = product(product(about_L.q, q_WB0), about_e.q);
      now.R_WB = rotation(now.q_WB);
      now.w_WB = (w - s * e_W) + s * now.R_WB.col(a);
      now.turn_error = about_L.error + about_e.error + (110 * std::abs(c) + 2) * u * rate_ * tau + 72 * u;
      now.w_error = rate_ * (2 * now.turn_error + 128 * u);
    } else {
      const Tumble::Now tumbled = tumble_.at(tau);
      const Quaternion q_WP = product(product(q_WB0, model_->inertia.q_BP), tumbled.q_P0P);
      now.q_WB = product(q_WP, conjugate(model_->inertia.q_BP));
      now.w_WB = rotation(q_WP) * tumbled.w_P;
      const bool is_exact = against_ == Against::exact;
      now.turn_error =
          (is_exact ? tumbled.error : tumbled.computed_error) + (model_->inertia.is_aligned ? 60 : 140) * u;
      now.w_error = rate_ * (now.turn_error + 64 * u) + (is_exact ? tumbled.w_error : tumbled.computed_w_error);
    }
  }
  now.R_WB = rotation(now.q_WB);
  if (turning_ != Turning::steady && turns()) now.alpha_WB = spin_up(model_->inertia, now.q_WB, now.w_WB);
  return now;
}

bool BallisticMotion::follows(double t) const { return turning_ != Turning::tumbling || tumble_.follows(t - since_); }

State BallisticMotion::state(double t) const {
  if (t == since_) return {start_, velocity_};
  const Kinematics now = kinematics(t);
  const Vec3 p_BBcm_W = turns() ? Vec3(now.R_WB * model_->p_BBcm) : p_BBcm_W_;
  return {{now.centre.p_WOBcm - p_BBcm_W, now.q_WB}, {now.centre.v_WBcm, now.w_WB}};
}

Aabb BallisticMotion::box(double from, double until, double greatest_force) const {
  using outward::unit;
  const Centre c = centre(from, {start_.p_WB});
  const double duration = (until - from) * (1 + 2 * u);
  const double slack = (c.error + c.v_error * duration) / unit;
  outward::Grower grower;
  if (turns() || greatest_force > 0) {
    outward::Motion X;
    X.t = start_.p_WB / unit;
    X.offsets = X.t.lpNorm<1>() + c.p_WOBcm.lpNorm<1>() / unit;
    X.poses = 1;
    grower.add(X, c.p_WOBcm / unit, Vec3::Constant(model_->radius / unit + slack), model_->radius / unit);
  } else {
    std::visit([&](const auto& shape) { grow(grower, shape, outward::motion(start_)); }, model_->shape);
    const Vec3 moved = (c.p_WOBcm - p_BBcm_W_) / unit;
    const Vec3 step = Vec3::Constant(slack + 4 * u * (c.p_WOBcm.lpNorm<1>() + p_BBcm_W_.lpNorm<1>()) / unit);
    grower.stretch(moved - step, moved + step);
  }
  const double f = greatest_force > 0 ? greatest_force / model_->mass / unit * (1 + 128 * u) : 0;
  Vec3 lo, hi;
  for (int i = 0; i < 3; ++i) {
    const double v = c.v_WBcm[i] / unit, a = acceleration_[i] / unit;
    const double step = 2 * u * (std::abs(a) + f);
    lo[i] = outward::displacement(v, f > 0 ? (a - f) - step : a, duration).lo;
    hi[i] = outward::displacement(v, f > 0 ? (a + f) + step : a, duration).hi;
  }
  grower.stretch(lo, hi);
  return grower.box();
}

}  // namespace touchstone::fast::motion
