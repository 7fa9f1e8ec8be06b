#include "fast/constraint/stepper.h"

#include <algorithm>
#include <array>
#include <string>

#include "fast/contact/solver.h"
#include "fast/mark.h"
#include "model/limits.h"

namespace touchstone::fast::constraint {
namespace {

using contact::index;

// Share of the velocity that weight adds in a step; smaller slip velocities are the solver's error.
constexpr double slip_counts = 0x1p-10;

constexpr int longest_long_step = 256;   // short steps
constexpr double same_force = 0x1p-20;   // relative; the solver's error is far below
constexpr double same_normal = 0x1p-40;  // rounding

std::vector<StepperBody> bodies_of(const Scene& scene) {
  std::vector<StepperBody> bodies;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    bodies.emplace_back(scene.bodies[i], "bodies[" + std::to_string(i) + "]");
  }
  return bodies;
}

/// Whether StepperBody::advance_evenly over h errs no more than short steps, which neglect that ω changes in each: by
/// h |Δω|/2 of the short h. The next terms of the series that it uses are at most h |Δω| (x²/120 + x³/720), x = |ω| h.
bool rotates_as_accurately(const Vec3& w, const Vec3& w_after, double h, double short_h) {
  const double x = h * std::max(w.norm(), w_after.norm());
  return w.cross(w_after).isZero(0) || (x < 2 && h * x * x * (1.0 / 120 + x / 720) <= short_h / 2);
}

std::optional<LoneBall> lone_ball(const Scene& scene, const std::vector<StepperBody>& bodies) {
  if (!scene.motion->forces.empty()) return std::nullopt;
  std::optional<LoneBall> ball;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].is_fixed() && !bodies[i].moves()) continue;
    if (ball || !bodies[i].is_ball()) return std::nullopt;
    ball = LoneBall{i, StepLength(longest_long_step)};
  }
  return ball;
}

}  // namespace

Stepper::Stepper(const Scene& scene, double short_step, int sweeps)
    : scene_(scene),
      sweeps_(sweeps),
      skin_(envelope(scene) / 2),
      bodies_(bodies_of(scene)),
      lone_ball_(lone_ball(scene, bodies_)),
      search_(scene, bodies_, skin_, short_step * (lone_ball_ ? longest_long_step : 1)) {}

void Stepper::find_contacts(double h) {
  mobilities_.clear();
  for (const StepperBody& body : bodies_) mobilities_.push_back(body.mobility());
  contacts_ = search_.find(bodies_, h);
  for (contact::ContactRow& row : contacts_.rows) prepare(row, mobilities_);
}

/// A force acts from the first step that does not begin before it. One that acts from the start emits no event.
void Stepper::emit_forces(double time) {
  const std::vector<AppliedForce>& forces = scene_.motion->forces;
  for (; begun_ < forces.size() && forces[begun_].time <= time; ++begun_) {
    const AppliedForce& force = forces[begun_];
    if (force.time <= 0) continue;
    mark(Mark::step_force);
    events_.push_back({Event::Kind::force,
                       time,
                       force.body,
                       -1,
                       Vec3::Zero(),
                       Vec3::Zero(),
                       Vec3::Zero(),
                       bodies_[index(force.body)].state(),
                       {}});
  }
}

std::vector<contact::Twist> Stepper::free_twists(const std::vector<Vec3>& force_W, double h) const {
  std::vector<contact::Twist> twists;
  for (const StepperBody& body : bodies_) {
    twists.push_back(body.twist());
    if (!body.is_fixed()) twists.back().v += h * scene_.gravity;
  }
  for (std::size_t i = 0; i < bodies_.size(); ++i) twists[i].v += h * bodies_[i].inverse_mass() * force_W[i];
  return twists;
}

std::vector<Vec3> Stepper::applied_forces(double time) const {
  std::vector<Vec3> force_W(bodies_.size(), Vec3::Zero());
  for (const AppliedForce& force : scene_.motion->forces) {
    if (force.time <= time) force_W[index(force.body)] = force.force_W;
  }
  return force_W;
}

/// Of all bodies, since what presses one presses those below it.
double Stepper::weight(const std::vector<Vec3>& force_W, double h) const {
  double greatest = scene_.gravity.norm();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (force_W[i].isZero(0)) continue;
    greatest = std::max(greatest, (scene_.gravity + bodies_[i].inverse_mass() * force_W[i]).norm());
  }
  return h * greatest;
}

/// Solves without restitution to find which contacts are impacts; if there are any, solves again with restitution. A
/// resting contact must not bounce: it would do so for ever, with the velocity that weight adds in a step.
void Stepper::solve_contacts(std::vector<contact::Twist>& twists, double weight) {
  const std::vector<contact::Twist> free = twists;
  solve(contacts_.rows, mobilities_, twists, {.sweeps = sweeps_});
  bool bounces = false;
  for (std::size_t i = 0; i < contacts_.rows.size(); ++i) {
    contact::ContactRow& row = contacts_.rows[i];
    const double e =
        std::min(scene_.bodies[index(row.a)].material.restitution, scene_.bodies[index(row.b)].material.restitution);
    const double parting = -e * u_n_[i];
    if (row.P.isZero(0) || !(parting > 0) || -u_n_[i] <= explained_by_weight * weight) continue;
    row.least_u_n = std::max(row.least_u_n, parting);
    bounces = true;
  }
  if (!bounces) return;
  mark(Mark::step_bounce);
  twists = free;
  solve(contacts_.rows, mobilities_, twists, {.sweeps = sweeps_});
}

/// The step's position correction: moves apart what is nearer than half the skin, without adding velocity.
std::vector<contact::Twist> Stepper::apart(double h) {
  std::vector<contact::Twist> shift(bodies_.size());
  std::vector<contact::ContactRow> near;
  for (std::size_t i = 0; i < contacts_.rows.size(); ++i) {
    if (contacts_.points[i].gap > skin_ / 2) continue;
    near.push_back(contacts_.rows[i]);
    near.back().friction = 0;
    near.back().P.setZero();
    near.back().least_u_n = (skin_ - contacts_.points[i].gap) / h;
  }
  if (near.empty()) return shift;
  mark(Mark::step_shift);
  solve(near, mobilities_, shift, {.sweeps = sweeps_});
  return shift;
}

PairStep Stepper::pair_step(const ContactPair& contact_pair, double slow) const {
  PairStep step;
  step.nhat_BA_W = *contact_pair.tracked->nhat_BA_W;
  double weight = 0;
  for (std::size_t i = contact_pair.first; i < contact_pair.first + contact_pair.count; ++i) {
    const contact::ContactRow& row = contacts_.rows[i];
    const double P_n = row.n.dot(row.P);
    if (!(P_n > 0)) continue;
    step.P_A_W += row.P;
    step.p_WC += P_n * contacts_.points[i].p_WC;
    weight += P_n;
    step.approach = std::max(step.approach, -u_n_[i]);
    step.slips = step.slips || slip_[i] > slow;
  }
  if (weight > 0) step.p_WC /= weight;
  return step;
}

/// For the next step.
void Stepper::keep_impulses(const ContactPair& contact_pair) const {
  contact_pair.tracked->loaded.clear();
  for (std::size_t i = contact_pair.first; i < contact_pair.first + contact_pair.count; ++i) {
    contact_pair.tracked->loaded.push_back({contacts_.points[i].p_WC, contacts_.rows[i].P});
  }
}

void Stepper::emit(double weight, double until) {
  const auto emit_event = [&](int a, int b, PairEvents& pair_events, const PairStep& step) {
    const auto kind = pair_events.update(step, weight);
    if (!kind) return;
    events_.push_back({*kind, until, a, b, step.p_WC, step.nhat_BA_W, step.P_A_W, bodies_[index(a)].state(),
                       bodies_[index(b)].state()});
  };
  for (const ContactPair& contact_pair : contacts_.pairs) {
    keep_impulses(contact_pair);
    emit_event(contact_pair.a, contact_pair.b, contact_pair.tracked->pair_events,
               pair_step(contact_pair, slip_counts * weight));
  }
  for (auto& [bodies, tracked] : search_.tracked()) {
    if (tracked.seen || !tracked.nhat_BA_W) continue;
    PairStep parted;
    parted.nhat_BA_W = *tracked.nhat_BA_W;
    tracked.loaded.clear();
    emit_event(bodies.first, bodies.second, tracked.pair_events, parted);
  }
  search_.forget_distant();
}

/// Whether a long step with these twists at its end ends as short ones would. The ball's path is then a parabola, which
/// stays in the convex hull of its start, its end, and the point that its first velocity reaches in h/2. A plane that
/// separates it from a body at these three does so all the way; and if a face is nearest to all three, then all the
/// way, since the points to which a face is nearest are a convex set. Forces are constant, so no slip begins, ends or
/// turns.
bool Stepper::changes_nothing(const std::vector<contact::Twist>& twists, double h, double short_h) {
  const auto& [moves, length, last_h] = *lone_ball_;
  for (const auto& [ids, tracked] : search_.tracked()) {
    if (!tracked.seen && !tracked.loaded.empty()) return false;
  }
  const StepperBody& ball = bodies_[moves];
  const contact::Twist &before = ball.twist(), &after = twists[moves];
  if (!rotates_as_accurately(before.w, after.w, h, short_h)) return false;
  const std::array<Vec3, 2> ways{h / 2 * before.v, h / 2 * (before.v + after.v)};
  for (const ContactPair& pair : contacts_.pairs) {
    const double side = index(pair.a) == moves ? 1 : -1;
    Vec3 P = Vec3::Zero(), P_before = Vec3::Zero();
    for (const TrackedPair::Loaded& loaded : pair.tracked->loaded) P_before += loaded.P;
    for (std::size_t i = pair.first; i < pair.first + pair.count; ++i) P += contacts_.rows[i].P;
    if ((last_h * P - h * P_before).norm() > same_force * last_h * P.norm()) return false;
    for (const Vec3& way : ways) {
      if (P.isZero(0)) {
        for (std::size_t i = pair.first; i < pair.first + pair.count; ++i) {
          if (!(contacts_.points[i].gap + side * contacts_.rows[i].n.dot(way) > skin_)) return false;
        }
      } else {
        const Vec3 normal = search_.normal(pair, bodies_, moves, way);
        if ((normal - *pair.tracked->nhat_BA_W).norm() > same_normal) return false;
      }
    }
  }
  return true;
}

bool Stepper::long_step(double time, double h, double short_h) {
  find_contacts(h);
  std::vector<contact::Twist> twists = free_twists(applied_forces(time), h);
  solve(contacts_.rows, mobilities_, twists, {.sweeps = sweeps_});
  if (!changes_nothing(twists, h, short_h)) return false;
  mark(Mark::step_long);
  StepperBody& ball = bodies_[lone_ball_->index];
  ball.advance_evenly(h, twists[lone_ball_->index]);
  search_.move(lone_ball_->index, ball);
  for (const ContactPair& pair : contacts_.pairs) keep_impulses(pair);
  search_.forget_distant();
  return true;
}

void Stepper::advance(double from, double to, int steps) {
  const auto time = [&](int i) { return i == steps ? to : from + (to - from) * i / steps; };
  const double short_h = (to - from) / steps;
  for (int i = 0; i < steps;) {
    const int n = lone_ball_ ? lone_ball_->length.next(steps - i) : 1;
    const double h = n == 1 ? short_h : time(i + n) - time(i);
    if (n == 1) {
      short_step(time(i), h, time(i + 1));
    } else if (!long_step(time(i), h, short_h)) {
      lone_ball_->length.refuse(n);
      continue;
    }
    if (lone_ball_) {
      lone_ball_->length.take(n);
      lone_ball_->last_h = h;
    }
    i += n;
  }
}

void Stepper::short_step(double time, double h, double until) {
  const std::vector<Vec3> force_W = applied_forces(time);
  const double weight = this->weight(force_W, h);
  emit_forces(time);
  find_contacts(h);
  std::vector<contact::Twist> now, twists = free_twists(force_W, h);
  for (const StepperBody& body : bodies_) now.push_back(body.twist());
  u_n_.clear();
  for (const contact::ContactRow& row : contacts_.rows) u_n_.push_back(row.n.dot(relative_velocity(row, now)));
  solve_contacts(twists, weight);
  const std::vector<contact::Twist> shift = apart(h);
  slip_.clear();
  for (const contact::ContactRow& row : contacts_.rows) {
    const Vec3 u = relative_velocity(row, twists);
    slip_.push_back((u - row.n.dot(u) * row.n).norm());
  }
  std::vector<bool> touched(bodies_.size(), false);
  for (const contact::ContactRow& row : contacts_.rows) {
    if (!row.P.isZero(0)) touched[index(row.a)] = touched[index(row.b)] = true;
  }
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    bodies_[i].advance(h, twists[i], touched[i], shift[i]);
    if (!bodies_[i].is_fixed() || bodies_[i].moves()) search_.move(i, bodies_[i]);
  }
  emit(weight, until);
}

std::vector<State> Stepper::states() const {
  std::vector<State> states;
  for (const StepperBody& body : bodies_) states.push_back(body.state());
  return states;
}

}  // namespace touchstone::fast::constraint
