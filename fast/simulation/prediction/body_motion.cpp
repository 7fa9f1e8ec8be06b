#include "fast/simulation/prediction/body_motion.h"

#include <algorithm>
#include <cmath>

#include "fast/bounds.h"
#include "fast/mass.h"
#include "fast/rounding.h"
#include "fast/simulation/prediction/spin.h"

namespace touchstone::fast::simulation {
namespace {

/// rad. By then rounding has changed the orientation by 2^-33 (motion/ballistic_motion.cpp), and half of the time that
/// a tumble covers in one piece has passed (motion/tumble.h). The power series of a ball whose axis turns takes so many
/// steps (prediction/spin.h): milliseconds.
constexpr double most_turn = 0x1p13;

bool is_multiple_of_one(const Mat3& I) { return I == I(0, 0) * Mat3::Identity(); }

struct Range {
  double lo, hi;
};

/// The range of p + v τ + a τ²/2 from `from` to `until`: its values at both ends and at an apex between them. Each
/// computed value is off by less than 8u of its terms.
Range swept(double p, double v, double a, double from, double until) {
  const auto at = [&](double tau) { return p + tau * (v + tau / 2 * a); };
  Range range{std::min(at(from), at(until)), std::max(at(from), at(until))};
  const double apex = a != 0 ? -v / a : from;
  if (apex > from && apex < until) {
    range.lo = std::min(range.lo, at(apex));
    range.hi = std::max(range.hi, at(apex));
  }
  const double error = 16 * u * (std::abs(p) + until * (std::abs(v) + until * std::abs(a))) + 0x1p-1000;
  return {range.lo - error, range.hi + error};
}

/// Whether a ball whose axis turns does so by more than `turn` radians until t.
bool turns_by(const Path& path, double t, double turn) {
  return turning_steps(path.w, path.alpha, t - path.since) > turn;
}

}  // namespace

BodyMotion::BodyMotion(const Body& body, double since, const Vec3& gravity)
    : fixed_(std::holds_alternative<Fixed>(body.mass)), material_(body.material), body_(&body) {
  const std::optional<MassProperties> mass = fast::mass(body);
  const auto* sphere = std::get_if<Sphere>(&body.shape);
  if (mass) inverse_mass_ = 1 / mass->mass;
  if (sphere && (!mass || (mass->p_BBcm.isZero(0) && is_multiple_of_one(mass->I_BBcm_B)))) {
    kind_ = Kind::ball;
    radius_ = sphere->radius;
    if (mass) inverse_moment_ = 1 / mass->I_BBcm_B(0, 0);
  } else if (fixed_ && std::holds_alternative<Box>(body.shape) && body.velocity.w_WB.isZero(0)) {
    kind_ = Kind::block;
    radius_ = half_extents(*this).norm() * (1 + 4 * u);
    const Aabb box = fast::box(body);
    block_ = std::make_unique<const Block>(
        Block{lin_canny::rotation(body.X_WB.q_WB), box.lo - body.X_WB.p_WB, box.hi - body.X_WB.p_WB});
  } else {
    radius_ = model().radius;
  }
  restart(since, {body.X_WB, body.velocity}, fixed_ ? Vec3(Vec3::Zero()) : gravity);
}

void BodyMotion::restart(double since, const State& state, const Vec3& acceleration, const Vec3& alpha) {
  follows_step_ = false;
  set_trajectory(since, state, acceleration, alpha);
}

void BodyMotion::follow_step(double since, const State& state, const Vec3& acceleration, const Vec3& spin) {
  follows_step_ = true;
  set_trajectory(since, {state.X_WB, {state.velocity.v_WBcm, spin}}, acceleration, Vec3::Zero());
}

void BodyMotion::set_trajectory(double since, const State& state, const Vec3& acceleration, const Vec3& alpha) {
  path_ = {since, state.X_WB.p_WB, state.velocity.v_WBcm, acceleration, state.X_WB.q_WB, state.velocity.w_WB, alpha};
  axis_turns_ = kind_ != Kind::other && axis_turns(path_.w, path_.alpha);
  if (other_) other_->ballistic.reset();
  if (kind_ == Kind::other) path_.p = ballistic().centre(since).p_WOBcm;
}

State BodyMotion::state(double t) const {
  if (kind_ == Kind::other) return ballistic().state(t);
  const double tau = t - path_.since;
  const Quaternion q = axis_turns_ ? turned(path_.q, path_.w, path_.alpha, tau)
                                   : turned(path_.q, tau * (path_.w + tau / 2 * path_.alpha));
  return {{path_.place(t), q}, {path_.velocity(t), path_.w + tau * path_.alpha}};
}

bool BodyMotion::needs_restart(double t) const {
  if (kind_ != Kind::other) return axis_turns_ && turns_by(path_, t, most_turn);
  return !fixed_ && !follows_step_ && (t - path_.since) * ballistic().rate() > most_turn;
}

bool BodyMotion::follows(double t) const {
  return kind_ == Kind::other ? ballistic().follows(t) : !axis_turns_ || !turns_by(path_, t, 2 * most_turn);
}

Aabb BodyMotion::box(double from, double until, double margin) const {
  Aabb box;
  if (kind_ == Kind::other) {
    box = ballistic().box(from, until);
    box.lo.array() -= margin;
    box.hi.array() += margin;
    return box;
  }
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Range range = swept(path_.p[i], path_.v[i], path_.a[i], from - path_.since, until - path_.since);
    const double below = kind_ == Kind::ball ? -radius_ : block_->reach_lo[i];
    const double above = kind_ == Kind::ball ? radius_ : block_->reach_hi[i];
    const double more = margin + 4 * u * (above - below);
    box.lo[i] = range.lo + below - more;
    box.hi[i] = range.hi + above + more;
  }
  return box;
}

Mat3 inertia(const BodyMotion& motion) {
  if (motion.fixed()) return Mat3::Zero();
  return motion.kind() == Kind::ball ? Mat3(1 / motion.inverse_moment() * Mat3::Identity()) : motion.model().I_BBcm_B;
}

BodyMotion::Other& BodyMotion::other() const {
  if (!other_) other_ = std::make_unique<Other>(*body_);
  return *other_;
}

const motion::RigidBodyModel& BodyMotion::model() const { return other().model; }

const motion::BallisticMotion& BodyMotion::ballistic() const {
  Other& made = other();
  if (!made.ballistic) {
    const Velocity velocity{path_.v, kind_ == Kind::ball ? Vec3(Vec3::Zero()) : path_.w};
    if (follows_step_ && !made.steady) {
      made.steady = made.model;
      made.steady->turning = motion::Turning::steady;
    }
    made.ballistic.emplace(follows_step_ ? *made.steady : made.model, path_.since, Pose{path_.p, path_.q}, velocity,
                           path_.a, motion::Against::computed);
  }
  return *made.ballistic;
}

}  // namespace touchstone::fast::simulation
