#include "fast/constraint/stepper.h"

#include <algorithm>
#include <string>

#include "fast/contact/solver.h"
#include "model/input_error.h"
#include "model/limits.h"

namespace touchstone::fast::constraint {
namespace {

using contact::index;

// Share of the velocity that weight adds in a step; smaller slip velocities are the solver's error.
constexpr double slip_counts = 0x1p-10;

std::vector<StepperBody> bodies_of(const Scene& scene) {
  std::vector<StepperBody> bodies;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    bodies.emplace_back(scene.bodies[i], "bodies[" + std::to_string(i) + "]");
  }
  return bodies;
}

/// Where an impulse acts, in gaps from the middle towards A. If one body is fixed, at the point of the moving body,
/// which is where contact will be once the gap is closed. If both move, midway, so that equal impulses have opposite
/// moments.
double from_middle(const StepperBody& A, const StepperBody& B) {
  if (A.is_fixed()) return -0.5;
  return B.is_fixed() ? 0.5 : 0;
}

}  // namespace

Stepper::Stepper(const Scene& scene, double longest_step, int sweeps)
    : scene_(scene),
      sweeps_(sweeps),
      skin_(envelope(scene) / 2),
      bodies_(bodies_of(scene)),
      margin_(skin_ + 2 * longest_step * greatest_speed(scene.motion->sample_times.back())) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) boxes_.insert(static_cast<BodyId>(i), around(bodies_[i]));
}

Aabb Stepper::around(const StepperBody& body) const {
  const Vec3 reach = Vec3::Constant(body.reach() + margin_);
  return {body.centre() - reach, body.centre() + reach};
}

/// An upper bound of any point's speed, unless forces or impacts add energy from elsewhere; contacts are then detected
/// late.
double Stepper::greatest_speed(double duration) const {
  double greatest = 0, push = 0;
  for (const StepperBody& body : bodies_) {
    greatest = std::max(greatest, body.twist().v.norm() + body.reach() * body.twist().w.norm());
    push = std::max(push, scene_.motion->force_bound * body.inverse_mass());
  }
  return 2 * greatest + duration * (scene_.gravity.norm() + push);
}

/// Approximately how far a point of the body may move in a step.
double Stepper::span(const StepperBody& body, double h) const {
  const double speed = body.twist().v.norm() + body.reach() * body.twist().w.norm();
  const double acceleration =
      body.is_fixed() ? 0 : scene_.gravity.norm() + scene_.motion->force_bound * body.inverse_mass();
  return h * (speed + h * acceleration);
}

void Stepper::find_contacts(int a, int b, double h) {
  const StepperBody &A = bodies_[index(a)], &B = bodies_[index(b)];
  if (A.is_fixed() && B.is_fixed()) return;
  const double reach = skin_ + span(A, h) + span(B, h);
  Pair& pair = pairs_[{a, b}];
  const lin_canny::Proximity proximity =
      nearest_parts(A.solid(), lin_canny::CachedPose(A.pose()), B.solid(), lin_canny::CachedPose(B.pose()), pair.walk)
          .proximity;
  if (first_step_ && proximity.verdict == Verdict::overlapping) {
    throw InputError("bodies[" + std::to_string(b) + "]", "overlaps bodies[" + std::to_string(a) + "] at the start");
  }
  if (proximity.distance > reach) return;
  const contact::GapManifold found = gap_manifold(A.part(), B.part(), proximity, pair.nhat_BA_W);
  pair.seen = true;
  pair.nhat_BA_W = found.nhat_BA_W;
  const Material &of_A = scene_.bodies[index(a)].material, &of_B = scene_.bodies[index(b)].material;
  ContactPair contact_pair{&pair, rows_.size(), 0, a, b};
  for (contact::GapPoint point : found.points) {
    if (point.gap > reach) continue;
    point.p_WC += from_middle(A, B) * point.gap * found.nhat_BA_W;
    contact::ContactRow row;
    row.a = a;
    row.b = b;
    row.n = found.nhat_BA_W;
    row.arm_A = point.p_WC - A.centre();
    row.arm_B = point.p_WC - B.centre();
    row.friction = std::min(of_A.friction, of_B.friction);
    row.least_u_n = -std::max(point.gap - skin_, 0.0) / h;
    prepare(row, mobilities_);
    rows_.push_back(row);
    points_.push_back(point);
  }
  contact_pair.count = rows_.size() - contact_pair.first;
  if (contact_pair.count > 0) guess(contact_pair);
  contact_pairs_.push_back(contact_pair);
}

/// Assigns each impulse of the last step to the nearest contact point of this one. The corners of a common face come in
/// any order and number, and under a heavy body a guess with the load at the wrong points is worse than none.
void Stepper::guess(const ContactPair& contact_pair) {
  for (const Pushed& before : contact_pair.pair->pushed) {
    std::size_t nearest = contact_pair.first;
    const auto apart = [&](std::size_t i) { return (points_[i].p_WC - before.p_WC).squaredNorm(); };
    for (std::size_t i = contact_pair.first; i < contact_pair.first + contact_pair.count; ++i) {
      if (apart(i) < apart(nearest)) nearest = i;
    }
    rows_[nearest].P += before.P;
  }
}

void Stepper::find_contacts(double h) {
  rows_.clear();
  points_.clear();
  contact_pairs_.clear();
  mobilities_.clear();
  for (const StepperBody& body : bodies_) mobilities_.push_back(body.mobility());
  for (auto& [bodies, pair] : pairs_) pair.seen = false;
  boxes_.update();
  near_ = boxes_.pairs();
  std::ranges::sort(near_);
  for (const BodyPair& pair : near_) find_contacts(static_cast<int>(pair.a), static_cast<int>(pair.b), h);
  first_step_ = false;
}

/// A force acts from the first step that does not begin before it. One that acts from the start emits no event.
void Stepper::emit_forces(double time) {
  const std::vector<AppliedForce>& pushes = scene_.motion->forces;
  for (; begun_ < pushes.size() && pushes[begun_].time <= time; ++begun_) {
    const AppliedForce& push = pushes[begun_];
    if (push.time <= 0) continue;
    events_.push_back({Event::Kind::force,
                       time,
                       push.body,
                       -1,
                       Vec3::Zero(),
                       Vec3::Zero(),
                       Vec3::Zero(),
                       bodies_[index(push.body)].state(),
                       {}});
  }
}

std::vector<contact::Twist> Stepper::free_twists(double time, double h) const {
  std::vector<contact::Twist> twists;
  for (const StepperBody& body : bodies_) {
    twists.push_back(body.twist());
    if (!body.is_fixed()) twists.back().v += h * scene_.gravity;
  }
  std::vector<Vec3> force(bodies_.size(), Vec3::Zero());
  for (const AppliedForce& push : scene_.motion->forces) {
    if (push.time <= time) force[index(push.body)] = push.force_W;
  }
  for (std::size_t i = 0; i < bodies_.size(); ++i) twists[i].v += h * bodies_[i].inverse_mass() * force[i];
  return twists;
}

/// Solves without restitution to find which contacts are impacts; if there are any, solves again with restitution. A
/// resting contact must not bounce: it would do so for ever, with the velocity that weight adds in a step.
void Stepper::push(std::vector<contact::Twist>& twists, double weight) {
  const std::vector<contact::Twist> free = twists;
  solve(rows_, mobilities_, twists, {.sweeps = sweeps_});
  bool bounces = false;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    contact::ContactRow& row = rows_[i];
    const double e =
        std::min(scene_.bodies[index(row.a)].material.restitution, scene_.bodies[index(row.b)].material.restitution);
    const double parting = -e * u_n_[i];
    if (row.P.isZero(0) || !(parting > 0) || -u_n_[i] <= explained_by_weight * weight) continue;
    row.least_u_n = std::max(row.least_u_n, parting);
    bounces = true;
  }
  if (!bounces) return;
  twists = free;
  solve(rows_, mobilities_, twists, {.sweeps = sweeps_});
}

/// The step's position correction: moves apart what is nearer than half the skin, without adding velocity.
std::vector<contact::Twist> Stepper::apart(double h) {
  std::vector<contact::Twist> shift(bodies_.size());
  std::vector<contact::ContactRow> near;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (points_[i].gap > skin_ / 2) continue;
    near.push_back(rows_[i]);
    near.back().friction = 0;
    near.back().P.setZero();
    near.back().least_u_n = (skin_ - points_[i].gap) / h;
  }
  if (!near.empty()) solve(near, mobilities_, shift, {.sweeps = sweeps_});
  return shift;
}

PairStep Stepper::pair_step(const ContactPair& contact_pair, double slow) const {
  PairStep step;
  step.nhat_BA_W = *contact_pair.pair->nhat_BA_W;
  double weight = 0;
  for (std::size_t i = contact_pair.first; i < contact_pair.first + contact_pair.count; ++i) {
    const contact::ContactRow& row = rows_[i];
    const double P_n = row.n.dot(row.P);
    if (!(P_n > 0)) continue;
    step.P_A_W += row.P;
    step.p_WC += P_n * points_[i].p_WC;
    weight += P_n;
    step.approach = std::max(step.approach, -u_n_[i]);
    step.slips = step.slips || slip_[i] > slow;
  }
  if (weight > 0) step.p_WC /= weight;
  return step;
}

void Stepper::emit(double weight, double until) {
  const auto emit_event = [&](int a, int b, PairEvents& pair_events, const PairStep& step) {
    const auto kind = pair_events.update(step, weight);
    if (!kind) return;
    events_.push_back({*kind, until, a, b, step.p_WC, step.nhat_BA_W, step.P_A_W, bodies_[index(a)].state(),
                       bodies_[index(b)].state()});
  };
  for (const ContactPair& contact_pair : contact_pairs_) {
    contact_pair.pair->pushed.clear();
    for (std::size_t i = contact_pair.first; i < contact_pair.first + contact_pair.count; ++i) {
      contact_pair.pair->pushed.push_back({points_[i].p_WC, rows_[i].P});
    }
    emit_event(contact_pair.a, contact_pair.b, contact_pair.pair->pair_events,
               pair_step(contact_pair, slip_counts * weight));
  }
  for (auto& [bodies, pair] : pairs_) {
    if (pair.seen || !pair.nhat_BA_W) continue;
    PairStep parted;
    parted.nhat_BA_W = *pair.nhat_BA_W;
    pair.pushed.clear();
    emit_event(bodies.first, bodies.second, pair.pair_events, parted);
  }
  // Forgets pairs whose boxes no longer overlap.
  std::erase_if(pairs_, [&](const auto& entry) {
    const BodyPair bodies{static_cast<BodyId>(entry.first.first), static_cast<BodyId>(entry.first.second)};
    return !std::ranges::binary_search(near_, bodies);
  });
}

void Stepper::step(double time, double h, double until) {
  const double weight = h * scene_.gravity.norm();
  emit_forces(time);
  find_contacts(h);
  std::vector<contact::Twist> now, twists = free_twists(time, h);
  for (const StepperBody& body : bodies_) now.push_back(body.twist());
  u_n_.clear();
  for (const contact::ContactRow& row : rows_) u_n_.push_back(row.n.dot(relative_velocity(row, now)));
  push(twists, weight);
  const std::vector<contact::Twist> shift = apart(h);
  slip_.clear();
  for (const contact::ContactRow& row : rows_) {
    const Vec3 u = relative_velocity(row, twists);
    slip_.push_back((u - row.n.dot(u) * row.n).norm());
  }
  std::vector<bool> touched(bodies_.size(), false);
  for (const contact::ContactRow& row : rows_) {
    if (!row.P.isZero(0)) touched[index(row.a)] = touched[index(row.b)] = true;
  }
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    bodies_[i].advance(h, twists[i], touched[i], shift[i]);
    if (!bodies_[i].is_fixed() || bodies_[i].moves()) boxes_.move(static_cast<BodyId>(i), around(bodies_[i]));
  }
  emit(weight, until);
}

std::vector<State> Stepper::states() const {
  std::vector<State> states;
  for (const StepperBody& body : bodies_) states.push_back(body.state());
  return states;
}

}  // namespace touchstone::fast::constraint
