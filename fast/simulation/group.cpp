#include "fast/simulation/group.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "fast/lin_canny/proximity.h"
#include "fast/simulation/length.h"
#include "model/limits.h"

namespace touchstone::fast::world {
namespace {

constexpr double balanced = 0x1p-30;             // of the pull: forces that leave no more carry
constexpr std::size_t strikes_of_a_joint = 4;    // at one time
constexpr int most_halvings = 60;                // of a step, until the corner that comes down is where it may be
constexpr double least_share_of_step = 0x1p-20;  // of a step: then it is taken, whatever sinks
constexpr double of_the_gap = 0x1p-10;           // how exactly a step is solved, as a share of what counts as touching

/// Of the directions that rule a joint, the one that keeps its parts apart best: the foot's, or a face's of either.
Vec3 ruling(const contact::Part& A, const contact::Part& B, const Vec3& n) {
  Vec3 best = n;
  double widest = apart(A, B, n);
  for (const Vec3& other : contact::faces_along(A, B, n)) {
    const double wide = apart(A, B, other);
    if (wide > widest) widest = wide, best = other;
  }
  return best;
}

lin_canny::Proximity proximity_of(const contact::Part& A, const State& at_a, const contact::Part& B,
                                  const State& at_b) {
  lin_canny::FeaturePair memory;
  return lin_canny::proximity(*A.convex, lin_canny::Station(at_a.X_WB), *B.convex, lin_canny::Station(at_b.X_WB),
                              memory);
}

}  // namespace

void Group::add(const Rider& rider) {
  const auto place = std::ranges::lower_bound(riders_, rider.id, {}, &Rider::id);
  riders_.insert(place, rider);
}

std::size_t Group::index(BodyId id) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(riders_, id, {}, &Rider::id) - riders_.begin());
}

bool Group::has(BodyId id) const {
  const std::size_t i = index(id);
  return i < riders_.size() && riders_[i].id == id;
}

bool Group::holds(BodyId a, BodyId b) const {
  return std::ranges::any_of(joints_, [=](const Joint& j) { return j.a == std::min(a, b) && j.b == std::max(a, b); });
}

BodyId Group::key() const {
  return std::ranges::find_if(riders_, [](const Rider& rider) { return !rider.fixed(); })->id;
}

contact::Member& Group::member(BodyId id) { return riders_[index(id)].member; }
const State& Group::state(BodyId id) const { return riders_[index(id)].member.state; }

void Group::strike(BodyId id, const Velocity& velocity) {
  member(id).state.velocity = velocity;
  tell_anew(id);
}

void Group::set_pull(BodyId id, const Vec3& pull) { member(id).pull = pull; }

void Group::sort_joints() {
  std::ranges::stable_sort(joints_, {}, [](const Joint& j) { return std::tuple(j.a, j.b, j.part_a, j.part_b); });
}

void Group::absorb(const Group& other) {
  for (const Rider& rider : other.riders_) {
    if (!has(rider.id)) add(rider);
  }
  joints_.insert(joints_.end(), other.joints_.begin(), other.joints_.end());
  sort_joints();
  longest = std::min(longest, other.longest);
  if (other.struck_at_ > struck_at_) struck_at_ = other.struck_at_, strikes_ = 0;
  if (other.struck_at_ == struck_at_) strikes_ = std::max(strikes_, other.strikes_);
}

contact::Part Group::part_of(BodyId id, std::size_t part, const State& state) const {
  const Rider& rider = riders_[index(id)];
  contact::Member there = rider.member;
  there.state = state;
  return contact::part_of(rider.body->flyer().solid.parts()[part], lin_canny::Station(state.X_WB), there.stance());
}

bool Group::link(BodyId id_a, BodyId id_b) {
  const BodyId a = std::min(id_a, id_b), b = std::max(id_a, id_b);
  link(a, b, reach_);
  return holds(a, b);
}

/// Requires a < b.
void Group::link(BodyId a, BodyId b, double reach) {
  const std::size_t parts_a = riders_[index(a)].body->flyer().solid.parts().size();
  const std::size_t parts_b = riders_[index(b)].body->flyer().solid.parts().size();
  for (std::size_t i = 0; i < parts_a; ++i) {
    for (std::size_t j = 0; j < parts_b; ++j) {
      const auto same = [&](const Joint& k) { return k.a == a && k.b == b && k.part_a == i && k.part_b == j; };
      if (std::ranges::any_of(joints_, same)) continue;
      Joint joint{a, b, i, j};
      if (renew(joint, reach)) joints_.push_back(std::move(joint));
    }
  }
  sort_joints();
}

void Group::link_parts(double h) {
  std::vector<BodyPair> pairs;
  for (const Joint& joint : joints_) pairs.push_back({joint.a, joint.b});
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  for (const BodyPair& pair : pairs) link(pair.a, pair.b, reach_ + h * (pace(pair.a, h) + pace(pair.b, h)));
}

/// How fast a point of the body may be within h (m/s), where no force at a foot speeds it up.
double Group::pace(BodyId id, double h) const {
  const Rider& rider = riders_[index(id)];
  const Velocity& V = rider.member.state.velocity;
  return length(V.v_WBcm) + length(V.w_WB) * rider.body->radius() + h * length(rider.member.pull);
}

/// That of its feet as the two stand, if it has any: they have not gone far since. But where these say that the two
/// overlap, it is another one by now: an edge's end, say, hangs over a face's side.
Vec3 Group::normal(const Joint& joint, const contact::Part& A, const State& at_a, const contact::Part& B,
                   const State& at_b) const {
  if (joint.feet.empty()) return contact::parting(A, B, proximity_of(A, at_a, B, at_b));
  const contact::Foot& foot = joint.feet.front();
  const Vec3 n = ruling(A, B, nearness(foot.a, A.body, foot.b, B.body, joint.nhat_BA_W).nhat_BA_W);
  const double wide = apart(A, B, n);
  if (wide >= -near_ / 4) return n;
  const Vec3 other = contact::parting(A, B, proximity_of(A, at_a, B, at_b));
  return apart(A, B, other) > wide ? other : n;
}

/// Its normal and feet, as the two stand; false: they are out of reach.
bool Group::renew(Joint& joint, double reach) const {
  const State &at_a = state(joint.a), &at_b = state(joint.b);
  const contact::Part A = part_of(joint.a, joint.part_a, at_a), B = part_of(joint.b, joint.part_b, at_b);
  joint.nhat_BA_W = normal(joint, A, at_a, B, at_b);
  const double gap = apart(A, B, joint.nhat_BA_W);
  if (gap > reach) return false;
  std::vector<contact::Foot> feet;
  // Of parts that overlap a little, all that does.
  if (gap <= near_) feet = contact::feet(A, B, joint.nhat_BA_W, near_ + std::max(0.0, -gap));
  if (gap <= near_ && feet.empty()) {
    const lin_canny::Proximity found = proximity_of(A, at_a, B, at_b);
    joint.nhat_BA_W = contact::parting(A, B, found);
    if (apart(A, B, joint.nhat_BA_W) <= near_) feet = contact::feet(A, B, joint.nhat_BA_W, near_);
    if (feet.empty() && !(found.distance > near_)) {
      feet = {contact::foot_between(A, found.p_WCa, B, found.p_WCb, joint.nhat_BA_W)};
    }
  }
  // The guess: as in the last step, if the points may be the same.
  for (std::size_t i = 0; i < feet.size() && feet.size() == joint.feet.size(); ++i) feet[i].P_A_W = joint.feet[i].P_A_W;
  joint.feet = std::move(feet);
  joint.touched = joint.touched || !joint.feet.empty();
  if (!joint.feet.empty()) joint.p_WC = strike_at(joint, joint.feet.front()).touch.p_WC;
  return true;
}

std::vector<contact::Member> Group::members() const {
  std::vector<contact::Member> all;
  for (const Rider& rider : riders_) all.push_back(rider.member);
  return all;
}

std::vector<contact::Hold> Group::holds() const {
  std::vector<contact::Hold> all;
  for (const Joint& joint : joints_) {
    const std::size_t a = index(joint.a), b = index(joint.b);
    const double friction = coefficients(*riders_[a].body, *riders_[b].body, Law::poisson).friction;
    for (const contact::Foot& foot : joint.feet) all.push_back({a, b, foot, joint.nhat_BA_W, friction});
  }
  return all;
}

Group::Plan Group::planned(double h) const {
  Plan made{h, {}, holds()};
  made.stepped = step(members(), made.holds, h, of_the_gap * near_, near_ / std::max(h, stride_));
  return made;
}

std::vector<State> Group::states_at(double time) const {
  if (!waits && until != never && time > since) return planned(time - since).stepped.after;
  std::vector<State> states;
  for (const Rider& rider : riders_) states.push_back(rider.member.state);
  return states;
}

void Group::go_to(double time) {
  const double h = time - since;
  since = time;
  if (until == never || !(h > 0)) return;
  const Plan taken = plan_ && plan_->h == h ? *plan_ : planned(h);
  for (std::size_t i = 0; i < riders_.size(); ++i) riders_[i].member.state = taken.stepped.after[i];
  auto hold = taken.holds.begin();
  for (Joint& joint : joints_) {
    for (contact::Foot& foot : joint.feet) foot = (hold++)->foot;
  }
}

std::vector<Joint> Group::part(const std::function<double(BodyId, BodyId)>& slow) {
  std::vector<bool> held(riders_.size());
  for (std::size_t i = 0; i < riders_.size(); ++i) held[i] = riders_[i].fixed();
  std::vector<Joint> near, kept, out;
  for (Joint& joint : joints_) {
    const Joint before = joint;
    if (!renew(joint, reach_)) {
      out.push_back(before);
      continue;
    }
    for (const contact::Foot& foot : joint.feet) {
      const Strike at = strike_at(joint, foot);
      if (at.u_n <= slow(joint.a, joint.b) || at.touch.gap < -near_ * of_the_gap)
        held[index(joint.a)] = held[index(joint.b)] = true;
    }
    near.push_back(joint);
  }
  for (const Joint& joint : near) (held[index(joint.a)] && held[index(joint.b)] ? kept : out).push_back(joint);
  joints_ = std::move(kept);
  std::erase_if(out, [](const Joint& joint) { return !joint.touched; });
  return out;
}

Strike Group::strike_at(const Joint& joint, const contact::Foot& foot) const {
  const Rider &A = riders_[index(joint.a)], &B = riders_[index(joint.b)];
  const contact::Nearness near = nearness(foot.a, A.member.stance(), foot.b, B.member.stance(), joint.nhat_BA_W);
  const Vec3 n = near.nhat_BA_W.normalized();  // a plane's may be off by a few u
  const Touch touch{near.gap, near.p_WC - near.gap / 2 * n, n};
  return {joint.a, joint.b, touch, approach(*A.body, A.member.state, *B.body, B.member.state, touch)};
}

std::optional<Strike> Group::foremost() const {
  std::optional<Strike> most;
  for (const Joint& joint : joints_) {
    for (const contact::Foot& foot : joint.feet) {
      const Strike found = strike_at(joint, foot);
      if (!most || found.u_n < most->u_n) most = found;
    }
  }
  return most;
}

bool Group::may_strike() {
  if (struck_at_ != since) struck_at_ = since, strikes_ = 0;
  return ++strikes_ <= strikes_of_a_joint * joints_.size();
}

std::vector<Group> Group::components() const {
  std::vector<std::size_t> root(riders_.size());
  for (std::size_t i = 0; i < root.size(); ++i) root[i] = i;
  const auto find = [&](std::size_t i) {
    while (root[i] != i) i = root[i];
    return i;
  };
  for (const Joint& joint : joints_) {
    const std::size_t a = find(index(joint.a)), b = find(index(joint.b));
    if (!riders_[index(joint.a)].fixed() && !riders_[index(joint.b)].fixed()) root[std::max(a, b)] = std::min(a, b);
  }
  std::vector<Group> groups;
  for (std::size_t i = 0; i < riders_.size(); ++i) {
    if (riders_[i].fixed() || root[i] != i) continue;
    Group group(near_, reach_);
    group.since = since;
    group.longest = longest;
    group.struck_at_ = struck_at_;
    group.strikes_ = strikes_;
    for (const Joint& joint : joints_) {
      const std::size_t a = index(joint.a), b = index(joint.b);
      if (find(riders_[a].fixed() ? b : a) != i) continue;
      for (const std::size_t rider : {a, b}) {
        if (!group.has(riders_[rider].id)) group.add(riders_[rider]);
      }
      group.joints_.push_back(joint);
    }
    if (!group.joints_.empty()) groups.push_back(std::move(group));
  }
  return groups;
}

void Group::land() {
  std::vector<contact::Member> all = members();
  contact::land(all, holds());
  for (std::size_t i = 0; i < riders_.size(); ++i) riders_[i].member.state = all[i].state;
}

bool Group::stands(double still) {
  bool pulled = false;
  for (const Rider& rider : riders_) {
    const Velocity& V = rider.member.state.velocity;
    const double speed = length(V.v_WBcm) + length(V.w_WB) * rider.body->radius();
    if (speed > (rider.fixed() ? 0 : still)) return false;
    pulled = pulled || (!rider.fixed() && !rider.member.pull.isZero(0));
  }
  std::vector<contact::Hold> feet = holds();
  if (pulled && !(contact::unbalanced(members(), feet) <= balanced)) return false;
  for (Rider& rider : riders_) rider.member.state.velocity = {};
  return true;
}

/// m; of all vertices of all joints, along the direction that keeps each joint's parts apart best.
std::vector<double> Group::clearances(const std::vector<State>& states) const {
  std::vector<double> all;
  for (const Joint& joint : joints_) {
    const State &at_a = states[index(joint.a)], &at_b = states[index(joint.b)];
    const contact::Part A = part_of(joint.a, joint.part_a, at_a), B = part_of(joint.b, joint.part_b, at_b);
    const std::vector<double> some = contact::clearances(A, B, normal(joint, A, at_a, B, at_b));
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

/// A vertex that did not touch may come down to a quarter of what counts as touching; of one that did, it may sink by
/// that much. How far the lowest is above (m).
double Group::spare(const std::vector<double>& before, const std::vector<double>& after) const {
  double least = never;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double lowest = before[i] > near_ ? near_ / 4 : std::min(0.0, before[i]) - near_ / 4;
    least = std::min(least, after[i] - lowest);
  }
  return least;
}

double Group::plan(double h) {
  const std::vector<double> before = clearances(states_at(since));
  const auto spare_of = [&](const Plan& plan) { return spare(before, clearances(plan.stepped.after)); };
  plan_ = planned(h);
  const double enough = -near_ / 4;
  double low = 0, over = spare_of(*plan_), over_later = over, later = h;
  if (over >= 0) return h;
  for (int k = 0; k < most_halvings && over < enough && plan_->h > least_share_of_step * h; ++k) {
    const double high = plan_->h, secant = high - (over - enough / 2) * (later - high) / (over_later - over);
    const Plan shorter = planned(secant > low && secant < high ? secant : (low + high) / 2);
    const double found = spare_of(shorter);
    if (found >= 0) {
      low = shorter.h;
    } else {
      later = high, over_later = over;
      plan_ = shorter, over = found;
    }
  }
  return plan_->h;
}

double Group::deepest() const { return std::max(0.0, -std::ranges::min(clearances(plan_->stepped.after))); }

void Group::tell_anew(BodyId id) {
  for (Joint& joint : joints_) joint.told = joint.told && joint.a != id && joint.b != id;
}

double Group::energy() const {
  double sum = 0;
  for (const Rider& rider : riders_) {
    if (rider.fixed()) continue;
    const contact::Stance stance = rider.member.stance();
    const Velocity& V = rider.member.state.velocity;
    const Vec3 w_B = stance.R_WB.transpose() * V.w_WB;
    const double moving = V.v_WBcm.dot(V.v_WBcm) / 2 - rider.member.pull.dot(stance.centre);
    sum += moving * rider.member.flyer->mass + w_B.dot(rider.member.flyer->I_BBcm_B * w_B) / 2;
  }
  return sum;
}

bool Group::shorten(double least_share) {
  if (!plan_) return true;
  longest = std::min(longest, std::max(plan_->h / 4, least_share * stride_));
  return plan_->h > least_share * stride_;
}

double Group::stride(double steps, double most) {
  double rate = 0;
  for (const Rider& rider : riders_) {
    if (rider.fixed()) continue;
    const Velocity& V = rider.member.state.velocity;
    const double size = touchstone::size(rider.body->body().shape);
    rate = std::max(rate, length(V.w_WB) + length(V.v_WBcm) / size + std::sqrt(length(rider.member.pull) / size));
  }
  return stride_ = std::min(most, 1 / (steps * rate));
}

double Group::deviation() const {
  const double h = plan_->h;
  const contact::Stepped& stepped = plan_->stepped;
  double most = 0;
  for (std::size_t i = 0; i < riders_.size(); ++i) {
    if (riders_[i].fixed()) continue;
    const Velocity &before = riders_[i].member.state.velocity, &after = stepped.after[i].velocity;
    const double turn = h * length(stepped.mean[i].w);
    const double spun = h * length(after.w_WB - before.w_WB) / 4 + turn * turn * turn / 8;
    const double bent = h * length(after.v_WBcm - before.v_WBcm) / 4;
    most = std::max(most, spun * (riders_[i].body->kind() == Kind::ball ? 0 : riders_[i].body->radius()) + bent);
  }
  return most;
}

}  // namespace touchstone::fast::world
