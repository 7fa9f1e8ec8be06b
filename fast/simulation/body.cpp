#include "fast/simulation/body.h"

#include <algorithm>
#include <cmath>

#include "fast/bounds.h"
#include "fast/mass.h"
#include "fast/rounding.h"
#include "fast/simulation/spin.h"

namespace touchstone::fast::world {
namespace {

/// rad. 2^-33 is what the turn rounds by then (flight.cpp), and half of the time that a tumble follows in one piece
/// (tumble.h).
constexpr double farthest = 0x1p13;

bool is_multiple_of_one(const Mat3& I) { return I == I(0, 0) * Mat3::Identity(); }

struct Range {
  double lo, hi;
};

/// p + v τ + a τ²/2 over the times: its ends and, if it turns between them, its apex. Rounding: each computed place is
/// off by less than 8u of its terms.
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

}  // namespace

Mover::Mover(const Body& body, double since, const Vec3& gravity)
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
    radius_ = half_extents().norm() * (1 + 4 * u);
    const Aabb box = fast::box(body);
    block_ = std::make_unique<const Block>(
        Block{lin_canny::rotation(body.X_WB.q_WB), box.lo - body.X_WB.p_WB, box.hi - body.X_WB.p_WB});
  } else {
    radius_ = flyer().radius;
  }
  fly(since, {body.X_WB, body.velocity}, fixed_ ? Vec3(Vec3::Zero()) : gravity);
}

bool Mover::still() const {
  return path_.v.isZero(0) && path_.a.isZero(0) && (kind_ != Kind::other || path_.w.isZero(0));
}

void Mover::fly(double since, const State& state, const Vec3& acceleration, const Vec3& alpha) {
  glides_ = false;
  set_out(since, state, acceleration, alpha);
}

void Mover::glide(double since, const State& state, const Vec3& acceleration, const Vec3& spin) {
  glides_ = true;
  set_out(since, {state.X_WB, {state.velocity.v_WBcm, spin}}, acceleration, Vec3::Zero());
}

void Mover::set_out(double since, const State& state, const Vec3& acceleration, const Vec3& alpha) {
  path_ = {since, state.X_WB.p_WB, state.velocity.v_WBcm, acceleration, state.X_WB.q_WB, state.velocity.w_WB, alpha};
  if (other_) other_->flight.reset();
  if (kind_ == Kind::other) path_.p = flight().centre(since).p_WOBcm;
}

State Mover::state(double t) const {
  if (kind_ == Kind::other) return flight().state(t);
  const double tau = t - path_.since;
  const Vec3 angle = tau * (path_.w + tau / 2 * path_.alpha);
  return {{path_.place(t), turned(path_.q, angle)}, {path_.velocity(t), path_.w + tau * path_.alpha}};
}

bool Mover::tires(double t) const {
  return kind_ == Kind::other && !fixed_ && !glides_ && (t - path_.since) * flight().rate() > farthest;
}

bool Mover::follows(double t) const { return kind_ != Kind::other || flight().follows(t); }

Aabb Mover::box(double from, double until, double margin) const {
  Aabb box;
  if (kind_ == Kind::other) {
    box = flight().box(from, until);
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

Mat3 Mover::inertia() const {
  if (fixed_) return Mat3::Zero();
  return kind_ == Kind::ball ? Mat3(1 / inverse_moment_ * Mat3::Identity()) : flyer().I_BBcm_B;
}

Mover::Other& Mover::other() const {
  if (!other_) other_ = std::make_unique<Other>(*body_);
  return *other_;
}

const motion::Flyer& Mover::flyer() const { return other().flyer; }

const motion::Flight& Mover::flight() const {
  Other& made = other();
  if (!made.flight) {
    const Velocity velocity{path_.v, kind_ == Kind::ball ? Vec3(Vec3::Zero()) : path_.w};
    if (glides_ && !made.steady) {
      made.steady = made.flyer;
      made.steady->turning = motion::Turning::steady;
    }
    made.flight.emplace(glides_ ? *made.steady : made.flyer, path_.since, Pose{path_.p, path_.q}, velocity, path_.a,
                        motion::Against::said);
  }
  return *made.flight;
}

}  // namespace touchstone::fast::world
