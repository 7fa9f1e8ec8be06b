#include "fast/constraint/stepper.h"

#include <algorithm>
#include <string>

#include "model/input_error.h"
#include "model/limits.h"

namespace touchstone::fast::constraint {
namespace {

constexpr double slip_counts = 0x1p-10;  // of the velocity that weight adds in a step; less is the solver's

std::size_t index(int i) { return static_cast<std::size_t>(i); }

std::vector<Mover> movers_of(const Scene& scene) {
  std::vector<Mover> movers;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    movers.emplace_back(scene.bodies[i], "bodies[" + std::to_string(i) + "]");
  }
  return movers;
}

}  // namespace

Stepper::Stepper(const Scene& scene, double longest_step, int sweeps)
    : scene_(scene),
      sweeps_(sweeps),
      skin_(envelope(scene) / 2),
      movers_(movers_of(scene)),
      margin_(skin_ + 2 * longest_step * greatest_speed(scene.flight->times.back())) {
  for (std::size_t i = 0; i < movers_.size(); ++i) boxes_.insert(static_cast<BodyId>(i), around(movers_[i]));
}

Aabb Stepper::around(const Mover& body) const {
  const Vec3 reach = Vec3::Constant(body.reach() + margin_);
  return {body.centre() - reach, body.centre() + reach};
}

/// No point of a body is faster, unless forces or impacts give it energy from elsewhere; then contacts are seen late.
double Stepper::greatest_speed(double duration) const {
  double greatest = 0, push = 0;
  for (const Mover& body : movers_) {
    greatest = std::max(greatest, body.twist().v.norm() + body.reach() * body.twist().w.norm());
    push = std::max(push, scene_.flight->force_bound * body.inverse_mass());
  }
  return 2 * greatest + duration * (scene_.gravity.norm() + push);
}

/// How far a point of the body may come in a step, about.
double Stepper::span(const Mover& body, double h) const {
  const double speed = body.twist().v.norm() + body.reach() * body.twist().w.norm();
  const double pull = body.is_fixed() ? 0 : scene_.gravity.norm() + scene_.flight->force_bound * body.inverse_mass();
  return h * (speed + h * pull);
}

void Stepper::meet(int a, int b, double h) {
  const Mover &A = movers_[index(a)], &B = movers_[index(b)];
  if (A.is_fixed() && B.is_fixed()) return;
  const double reach = skin_ + span(A, h) + span(B, h);
  Pair& pair = pairs_[{a, b}];
  const lin_canny::Proximity proximity =
      nearest_parts(A.solid(), lin_canny::Station(A.pose()), B.solid(), lin_canny::Station(B.pose()), pair.walk)
          .proximity;
  if (first_step_ && proximity.verdict == Verdict::overlapping) {
    throw InputError("bodies[" + std::to_string(b) + "]", "overlaps bodies[" + std::to_string(a) + "] at the start");
  }
  if (proximity.distance > reach) return;
  const Manifold found = manifold(A, B, proximity, pair.nhat_BA_W);
  pair.seen = true;
  pair.nhat_BA_W = found.nhat_BA_W;
  const Material &of_A = scene_.bodies[index(a)].material, &of_B = scene_.bodies[index(b)].material;
  Met met{&pair, touches_.size(), 0, a, b};
  for (const ContactPoint& point : found.points) {
    if (point.gap > reach) continue;
    Touch touch;
    touch.a = a;
    touch.b = b;
    touch.n = found.nhat_BA_W;
    touch.arm_A = point.p_WC - A.centre();
    touch.arm_B = point.p_WC - B.centre();
    touch.friction = std::min(of_A.friction, of_B.friction);
    touch.least_u_n = -std::max(point.gap - skin_, 0.0) / h;
    prepare(touch, mobilities_);
    touches_.push_back(touch);
    points_.push_back(point);
  }
  met.count = touches_.size() - met.first;
  if (met.count > 0) guess(met);
  met_.push_back(met);
}

/// What pushed in the last step pushes at the nearest point of this one: corners of a common face come in any order and
/// number, and under a heavy body a guess that puts its weight elsewhere is worse than none.
void Stepper::guess(const Met& met) {
  for (const Pushed& before : met.pair->pushed) {
    std::size_t nearest = met.first;
    const auto apart = [&](std::size_t i) { return (points_[i].p_WC - before.p_WC).squaredNorm(); };
    for (std::size_t i = met.first; i < met.first + met.count; ++i) {
      if (apart(i) < apart(nearest)) nearest = i;
    }
    touches_[nearest].P += before.P;
  }
}

void Stepper::meet(double h) {
  touches_.clear();
  points_.clear();
  met_.clear();
  mobilities_.clear();
  for (const Mover& body : movers_) mobilities_.push_back(body.mobility());
  for (auto& [bodies, pair] : pairs_) pair.seen = false;
  boxes_.update();
  near_ = boxes_.pairs();
  std::ranges::sort(near_);
  for (const BodyPair& pair : near_) meet(static_cast<int>(pair.a), static_cast<int>(pair.b), h);
  first_step_ = false;
}

/// A push acts from the first step that does not begin before it; one that is there from the start is no event.
void Stepper::tell_pushes(double time) {
  const std::vector<Push>& pushes = scene_.flight->pushes;
  for (; begun_ < pushes.size() && pushes[begun_].time <= time; ++begun_) {
    const Push& push = pushes[begun_];
    if (push.time <= 0) continue;
    events_.push_back({Event::Kind::push,
                       time,
                       push.body,
                       -1,
                       Vec3::Zero(),
                       Vec3::Zero(),
                       Vec3::Zero(),
                       movers_[index(push.body)].state(),
                       {}});
  }
}

std::vector<Twist> Stepper::free_twists(double time, double h) const {
  std::vector<Twist> twists;
  for (const Mover& body : movers_) {
    twists.push_back(body.twist());
    if (!body.is_fixed()) twists.back().v += h * scene_.gravity;
  }
  std::vector<Vec3> force(movers_.size(), Vec3::Zero());
  for (const Push& push : scene_.flight->pushes) {
    if (push.time <= time) force[index(push.body)] = push.force_W;
  }
  for (std::size_t i = 0; i < movers_.size(); ++i) twists[i].v += h * movers_[i].inverse_mass() * force[i];
  return twists;
}

/// Once without restitution, to learn who is hit; then, if somebody is, with it. Who only rests does not bounce: it
/// would for ever, by the velocity that weight adds in a step.
void Stepper::push(std::vector<Twist>& twists, double weight) {
  const std::vector<Twist> free = twists;
  solve(touches_, mobilities_, twists, {.sweeps = sweeps_});
  bool bounces = false;
  for (std::size_t i = 0; i < touches_.size(); ++i) {
    Touch& touch = touches_[i];
    const double e = std::min(scene_.bodies[index(touch.a)].material.restitution,
                              scene_.bodies[index(touch.b)].material.restitution);
    const double parting = -e * u_n_[i];
    if (touch.P.isZero(0) || !(parting > 0) || -u_n_[i] <= explained_by_weight * weight) continue;
    touch.least_u_n = std::max(touch.least_u_n, parting);
    bounces = true;
  }
  if (!bounces) return;
  twists = free;
  solve(touches_, mobilities_, twists, {.sweeps = sweeps_});
}

/// Moves apart what is nearer than half the skin, without a velocity: the step's shift.
std::vector<Twist> Stepper::apart(double h) {
  std::vector<Twist> shift(movers_.size());
  std::vector<Touch> near;
  for (std::size_t i = 0; i < touches_.size(); ++i) {
    if (points_[i].gap > skin_ / 2) continue;
    near.push_back(touches_[i]);
    near.back().friction = 0;
    near.back().P.setZero();
    near.back().least_u_n = (skin_ - points_[i].gap) / h;
  }
  if (!near.empty()) solve(near, mobilities_, shift, {.sweeps = sweeps_});
  return shift;
}

PairStep Stepper::told(const Met& met, double slow) const {
  PairStep step;
  step.nhat_BA_W = *met.pair->nhat_BA_W;
  double weight = 0;
  for (std::size_t i = met.first; i < met.first + met.count; ++i) {
    const Touch& touch = touches_[i];
    const double P_n = touch.n.dot(touch.P);
    if (!(P_n > 0)) continue;
    step.P_A_W += touch.P;
    step.p_WC += P_n * points_[i].p_WC;
    weight += P_n;
    step.approach = std::max(step.approach, -u_n_[i]);
    step.slips = step.slips || slip_[i] > slow;
  }
  if (weight > 0) step.p_WC /= weight;
  return step;
}

void Stepper::tell(double weight, double until) {
  const auto tell = [&](int a, int b, PairWatch& watch, const PairStep& step) {
    const auto kind = watch.see(step, weight);
    if (!kind) return;
    events_.push_back({*kind, until, a, b, step.p_WC, step.nhat_BA_W, step.P_A_W, movers_[index(a)].state(),
                       movers_[index(b)].state()});
  };
  for (const Met& met : met_) {
    met.pair->pushed.clear();
    for (std::size_t i = met.first; i < met.first + met.count; ++i) {
      met.pair->pushed.push_back({points_[i].p_WC, touches_[i].P});
    }
    tell(met.a, met.b, met.pair->watch, told(met, slip_counts * weight));
  }
  for (auto& [bodies, pair] : pairs_) {
    if (pair.seen || !pair.nhat_BA_W) continue;
    PairStep parted;
    parted.nhat_BA_W = *pair.nhat_BA_W;
    pair.pushed.clear();
    tell(bodies.first, bodies.second, pair.watch, parted);
  }
  // Who is no longer near is forgotten.
  std::erase_if(pairs_, [&](const auto& entry) {
    const BodyPair bodies{static_cast<BodyId>(entry.first.first), static_cast<BodyId>(entry.first.second)};
    return !std::ranges::binary_search(near_, bodies);
  });
}

void Stepper::step(double time, double h, double until) {
  const double weight = h * scene_.gravity.norm();
  tell_pushes(time);
  meet(h);
  std::vector<Twist> now, twists = free_twists(time, h);
  for (const Mover& body : movers_) now.push_back(body.twist());
  u_n_.clear();
  for (const Touch& touch : touches_) u_n_.push_back(touch.n.dot(relative_velocity(touch, now)));
  push(twists, weight);
  const std::vector<Twist> shift = apart(h);
  slip_.clear();
  for (const Touch& touch : touches_) {
    const Vec3 u = relative_velocity(touch, twists);
    slip_.push_back((u - touch.n.dot(u) * touch.n).norm());
  }
  std::vector<bool> touched(movers_.size(), false);
  for (const Touch& touch : touches_) {
    if (!touch.P.isZero(0)) touched[index(touch.a)] = touched[index(touch.b)] = true;
  }
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    movers_[i].advance(h, twists[i], touched[i], shift[i]);
    if (!movers_[i].is_fixed() || movers_[i].moves()) boxes_.move(static_cast<BodyId>(i), around(movers_[i]));
  }
  tell(weight, until);
}

std::vector<State> Stepper::states() const {
  std::vector<State> states;
  for (const Mover& body : movers_) states.push_back(body.state());
  return states;
}

}  // namespace touchstone::fast::constraint
