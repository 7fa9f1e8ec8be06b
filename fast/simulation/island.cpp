#include "fast/simulation/island.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "fast/lin_canny/proximity.h"
#include "fast/simulation/length.h"
#include "model/limits.h"

namespace touchstone::fast::world {
namespace {

constexpr double balance_tolerance = 0x1p-30;    // greatest unbalanced acceleration, relative to the applied one
constexpr std::size_t impacts_of_a_pair = 4;     // at one time, on average over the contact pairs
constexpr int most_halvings = 60;                // of a step, in the search for its end at a corner that comes down
constexpr double least_share_of_step = 0x1p-20;  // of a step: a step that short is taken even if corners overlap
constexpr double step_tolerance = 0x1p-10;       // accuracy of a step, relative to the distance that counts as touching

/// The direction of greatest separation among n, the contact point's normal, and the normals of nearby faces of A and
/// B.
Vec3 separating_direction(const contact::Part& A, const contact::Part& B, const Vec3& n) {
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
  return lin_canny::proximity(*A.convex, lin_canny::CachedPose(at_a.X_WB), *B.convex, lin_canny::CachedPose(at_b.X_WB),
                              memory);
}

}  // namespace

void Island::add(const IslandBody& island_body) {
  const auto place = std::ranges::lower_bound(bodies_, island_body.id, {}, &IslandBody::id);
  bodies_.insert(place, island_body);
}

std::size_t Island::index(BodyId id) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(bodies_, id, {}, &IslandBody::id) - bodies_.begin());
}

bool Island::has(BodyId id) const {
  const std::size_t i = index(id);
  return i < bodies_.size() && bodies_[i].id == id;
}

bool Island::connects(BodyId a, BodyId b) const {
  return std::ranges::any_of(contact_pairs_,
                             [=](const ContactPair& j) { return j.a == std::min(a, b) && j.b == std::max(a, b); });
}

BodyId Island::key() const {
  return std::ranges::find_if(bodies_, [](const IslandBody& island_body) { return !island_body.fixed(); })->id;
}

contact::StepBody& Island::step_body(BodyId id) { return bodies_[index(id)].step_body; }
const State& Island::state(BodyId id) const { return bodies_[index(id)].step_body.state; }

void Island::set_velocity(BodyId id, const Velocity& velocity) {
  step_body(id).state.velocity = velocity;
  emit_again(id);
}

void Island::set_acceleration(BodyId id, const Vec3& acceleration) { step_body(id).acceleration = acceleration; }

void Island::sort_contact_pairs() {
  std::ranges::stable_sort(contact_pairs_, {},
                           [](const ContactPair& j) { return std::tuple(j.a, j.b, j.part_a, j.part_b); });
}

void Island::absorb(const Island& other) {
  for (const IslandBody& island_body : other.bodies_) {
    if (!has(island_body.id)) add(island_body);
  }
  contact_pairs_.insert(contact_pairs_.end(), other.contact_pairs_.begin(), other.contact_pairs_.end());
  sort_contact_pairs();
  longest = std::min(longest, other.longest);
  if (other.last_impact_ > last_impact_) last_impact_ = other.last_impact_, impacts_now_ = 0;
  if (other.last_impact_ == last_impact_) impacts_now_ = std::max(impacts_now_, other.impacts_now_);
}

contact::Part Island::part_of(BodyId id, std::size_t part, const State& state) const {
  const IslandBody& island_body = bodies_[index(id)];
  contact::StepBody there = island_body.step_body;
  there.state = state;
  return contact::part_of(island_body.body->model().solid.parts()[part], lin_canny::CachedPose(state.X_WB),
                          there.transform());
}

bool Island::link(BodyId id_a, BodyId id_b) {
  const BodyId a = std::min(id_a, id_b), b = std::max(id_a, id_b);
  link(a, b, reach_);
  return connects(a, b);
}

/// Requires a < b.
void Island::link(BodyId a, BodyId b, double reach) {
  const std::size_t parts_a = bodies_[index(a)].body->model().solid.parts().size();
  const std::size_t parts_b = bodies_[index(b)].body->model().solid.parts().size();
  for (std::size_t i = 0; i < parts_a; ++i) {
    for (std::size_t j = 0; j < parts_b; ++j) {
      const auto same = [&](const ContactPair& k) { return k.a == a && k.b == b && k.part_a == i && k.part_b == j; };
      if (std::ranges::any_of(contact_pairs_, same)) continue;
      ContactPair contact_pair{a, b, i, j};
      if (update(contact_pair, reach)) contact_pairs_.push_back(std::move(contact_pair));
    }
  }
  sort_contact_pairs();
}

void Island::link_parts(double h) {
  std::vector<BodyPair> pairs;
  for (const ContactPair& contact_pair : contact_pairs_) pairs.push_back({contact_pair.a, contact_pair.b});
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  for (const BodyPair& pair : pairs)
    link(pair.a, pair.b, reach_ + h * (speed_bound(pair.a, h) + speed_bound(pair.b, h)));
}

/// An upper bound of the speed of any point of the body within h (m/s), without contact forces.
double Island::speed_bound(BodyId id, double h) const {
  const IslandBody& island_body = bodies_[index(id)];
  const Velocity& V = island_body.step_body.state.velocity;
  return length(V.v_WBcm) + length(V.w_WB) * island_body.body->radius() +
         h * length(island_body.step_body.acceleration);
}

/// The normal of the first contact point's features at the given poses, if the pair has contact points, since the
/// bodies have not moved far. If it says that the parts overlap, other features may separate them by now, as when the
/// end of an edge hangs over the side of a face: then all normals of the separating-axis theorem are tested.
Vec3 Island::normal(const ContactPair& contact_pair, const contact::Part& A, const State& at_a, const contact::Part& B,
                    const State& at_b) const {
  if (contact_pair.contact_points.empty()) return contact::parting(A, B, proximity_of(A, at_a, B, at_b));
  const contact::ContactPoint& contact_point = contact_pair.contact_points.front();
  const Vec3 n = separating_direction(
      A, B, nearness(contact_point.a, A.body, contact_point.b, B.body, contact_pair.nhat_BA_W).nhat_BA_W);
  const double wide = apart(A, B, n);
  if (wide >= -near_ / 4) return n;
  const Vec3 other = contact::parting(A, B, proximity_of(A, at_a, B, at_b));
  return apart(A, B, other) > wide ? other : n;
}

/// Recomputes the normal and the contact points from the current states. Returns false if the parts are out of reach.
bool Island::update(ContactPair& contact_pair, double reach) const {
  const State &at_a = state(contact_pair.a), &at_b = state(contact_pair.b);
  const contact::Part A = part_of(contact_pair.a, contact_pair.part_a, at_a),
                      B = part_of(contact_pair.b, contact_pair.part_b, at_b);
  contact_pair.nhat_BA_W = normal(contact_pair, A, at_a, B, at_b);
  const double gap = apart(A, B, contact_pair.nhat_BA_W);
  if (gap > reach) return false;
  std::vector<contact::ContactPoint> contact_points;
  // If the parts overlap a little, all corners in the overlap become contact points.
  if (gap <= near_) contact_points = contact::contact_points(A, B, contact_pair.nhat_BA_W, near_ + std::max(0.0, -gap));
  if (gap <= near_ && contact_points.empty()) {
    const lin_canny::Proximity found = proximity_of(A, at_a, B, at_b);
    contact_pair.nhat_BA_W = contact::parting(A, B, found);
    if (apart(A, B, contact_pair.nhat_BA_W) <= near_)
      contact_points = contact::contact_points(A, B, contact_pair.nhat_BA_W, near_);
    if (contact_points.empty() && !(found.distance > near_)) {
      contact_points = {contact::contact_point_between(A, found.p_WCa, B, found.p_WCb, contact_pair.nhat_BA_W)};
    }
  }
  // Initial guess: the impulses of the last step, if the points may be the same ones.
  for (std::size_t i = 0; i < contact_points.size() && contact_points.size() == contact_pair.contact_points.size(); ++i)
    contact_points[i].P_A_W = contact_pair.contact_points[i].P_A_W;
  contact_pair.contact_points = std::move(contact_points);
  contact_pair.touched = contact_pair.touched || !contact_pair.contact_points.empty();
  if (!contact_pair.contact_points.empty())
    contact_pair.p_WC = candidate_at(contact_pair, contact_pair.contact_points.front()).touch.p_WC;
  return true;
}

std::vector<contact::StepBody> Island::step_bodies() const {
  std::vector<contact::StepBody> all;
  for (const IslandBody& island_body : bodies_) all.push_back(island_body.step_body);
  return all;
}

std::vector<contact::ContactConstraint> Island::constraints() const {
  std::vector<contact::ContactConstraint> all;
  for (const ContactPair& contact_pair : contact_pairs_) {
    const std::size_t a = index(contact_pair.a), b = index(contact_pair.b);
    const double friction = coefficients(*bodies_[a].body, *bodies_[b].body, Law::poisson).friction;
    for (const contact::ContactPoint& contact_point : contact_pair.contact_points)
      all.push_back({a, b, contact_point, contact_pair.nhat_BA_W, friction});
  }
  return all;
}

Island::Plan Island::planned(double h) const {
  Plan made{h, {}, constraints()};
  made.stepped = step(step_bodies(), made.constraints, h, step_tolerance * near_, near_ / std::max(h, step_length_));
  return made;
}

std::vector<State> Island::states_at(double time) const {
  if (!waits && until != never && time > since) return planned(time - since).stepped.after;
  std::vector<State> states;
  for (const IslandBody& island_body : bodies_) states.push_back(island_body.step_body.state);
  return states;
}

void Island::advance_to(double time) {
  const double h = time - since;
  since = time;
  if (until == never || !(h > 0)) return;
  const Plan taken = plan_ && plan_->h == h ? *plan_ : planned(h);
  for (std::size_t i = 0; i < bodies_.size(); ++i) bodies_[i].step_body.state = taken.stepped.after[i];
  auto constraint = taken.constraints.begin();
  for (ContactPair& contact_pair : contact_pairs_) {
    for (contact::ContactPoint& contact_point : contact_pair.contact_points)
      contact_point = (constraint++)->contact_point;
  }
}

std::vector<ContactPair> Island::take_out_separating(const std::function<double(BodyId, BodyId)>& release_speed) {
  std::vector<bool> held(bodies_.size());
  for (std::size_t i = 0; i < bodies_.size(); ++i) held[i] = bodies_[i].fixed();
  std::vector<ContactPair> near, kept, out;
  for (ContactPair& contact_pair : contact_pairs_) {
    const ContactPair before = contact_pair;
    if (!update(contact_pair, reach_)) {
      out.push_back(before);
      continue;
    }
    for (const contact::ContactPoint& contact_point : contact_pair.contact_points) {
      const ImpactCandidate at = candidate_at(contact_pair, contact_point);
      if (at.u_n <= release_speed(contact_pair.a, contact_pair.b) || at.touch.gap < -near_ * step_tolerance)
        held[index(contact_pair.a)] = held[index(contact_pair.b)] = true;
    }
    near.push_back(contact_pair);
  }
  for (const ContactPair& contact_pair : near)
    (held[index(contact_pair.a)] && held[index(contact_pair.b)] ? kept : out).push_back(contact_pair);
  contact_pairs_ = std::move(kept);
  std::erase_if(out, [](const ContactPair& contact_pair) { return !contact_pair.touched; });
  return out;
}

ImpactCandidate Island::candidate_at(const ContactPair& contact_pair,
                                     const contact::ContactPoint& contact_point) const {
  const IslandBody &A = bodies_[index(contact_pair.a)], &B = bodies_[index(contact_pair.b)];
  const contact::Nearness near = nearness(contact_point.a, A.step_body.transform(), contact_point.b,
                                          B.step_body.transform(), contact_pair.nhat_BA_W);
  const Vec3 n = near.nhat_BA_W.normalized();  // the normal of a plane may be off by a few u
  const Touch touch{near.gap, near.p_WC - near.gap / 2 * n, n};
  return {contact_pair.a, contact_pair.b, touch,
          normal_velocity(*A.body, A.step_body.state, *B.body, B.step_body.state, touch)};
}

std::optional<ImpactCandidate> Island::fastest_approach() const {
  std::optional<ImpactCandidate> most;
  for (const ContactPair& contact_pair : contact_pairs_) {
    for (const contact::ContactPoint& contact_point : contact_pair.contact_points) {
      const ImpactCandidate found = candidate_at(contact_pair, contact_point);
      if (!most || found.u_n < most->u_n) most = found;
    }
  }
  return most;
}

bool Island::allows_impact() {
  if (last_impact_ != since) last_impact_ = since, impacts_now_ = 0;
  return ++impacts_now_ <= impacts_of_a_pair * contact_pairs_.size();
}

std::vector<Island> Island::components() const {
  std::vector<std::size_t> root(bodies_.size());
  for (std::size_t i = 0; i < root.size(); ++i) root[i] = i;
  const auto find = [&](std::size_t i) {
    while (root[i] != i) i = root[i];
    return i;
  };
  for (const ContactPair& contact_pair : contact_pairs_) {
    const std::size_t a = find(index(contact_pair.a)), b = find(index(contact_pair.b));
    if (!bodies_[index(contact_pair.a)].fixed() && !bodies_[index(contact_pair.b)].fixed())
      root[std::max(a, b)] = std::min(a, b);
  }
  std::vector<Island> islands;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i].fixed() || root[i] != i) continue;
    Island island(near_, reach_);
    island.since = since;
    island.longest = longest;
    island.last_impact_ = last_impact_;
    island.impacts_now_ = impacts_now_;
    for (const ContactPair& contact_pair : contact_pairs_) {
      const std::size_t a = index(contact_pair.a), b = index(contact_pair.b);
      if (find(bodies_[a].fixed() ? b : a) != i) continue;
      for (const std::size_t body : {a, b}) {
        if (!island.has(bodies_[body].id)) island.add(bodies_[body]);
      }
      island.contact_pairs_.push_back(contact_pair);
    }
    if (!island.contact_pairs_.empty()) islands.push_back(std::move(island));
  }
  return islands;
}

void Island::remove_approach() {
  std::vector<contact::StepBody> all = step_bodies();
  contact::land(all, constraints());
  for (std::size_t i = 0; i < bodies_.size(); ++i) bodies_[i].step_body.state = all[i].state;
}

bool Island::rest_test(double rest_speed) {
  bool pulled = false;
  for (const IslandBody& island_body : bodies_) {
    const Velocity& V = island_body.step_body.state.velocity;
    const double speed = length(V.v_WBcm) + length(V.w_WB) * island_body.body->radius();
    if (speed > (island_body.fixed() ? 0 : rest_speed)) return false;
    pulled = pulled || (!island_body.fixed() && !island_body.step_body.acceleration.isZero(0));
  }
  std::vector<contact::ContactConstraint> contact_points = constraints();
  if (pulled && !(contact::unbalanced(step_bodies(), contact_points) <= balance_tolerance)) return false;
  for (IslandBody& island_body : bodies_) island_body.step_body.state.velocity = {};
  return true;
}

/// The separations of all vertices of all contact pairs (m), each along the normal of its pair.
std::vector<double> Island::clearances(const std::vector<State>& states) const {
  std::vector<double> all;
  for (const ContactPair& contact_pair : contact_pairs_) {
    const State &at_a = states[index(contact_pair.a)], &at_b = states[index(contact_pair.b)];
    const contact::Part A = part_of(contact_pair.a, contact_pair.part_a, at_a),
                        B = part_of(contact_pair.b, contact_pair.part_b, at_b);
    const std::vector<double> some = contact::clearances(A, B, normal(contact_pair, A, at_a, B, at_b));
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

/// The least distance of a vertex above its allowed separation (m). A vertex that did not touch may come down to
/// near_/4; one that touched may sink by near_/4.
double Island::clearance_left(const std::vector<double>& before, const std::vector<double>& after) const {
  double least = never;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double lowest = before[i] > near_ ? near_ / 4 : std::min(0.0, before[i]) - near_ / 4;
    least = std::min(least, after[i] - lowest);
  }
  return least;
}

double Island::plan(double h) {
  const std::vector<double> before = clearances(states_at(since));
  const auto clearance_left_of = [&](const Plan& plan) {
    return clearance_left(before, clearances(plan.stepped.after));
  };
  plan_ = planned(h);
  const double enough = -near_ / 4;
  double low = 0, over = clearance_left_of(*plan_), over_later = over, later = h;
  if (over >= 0) return h;
  for (int k = 0; k < most_halvings && over < enough && plan_->h > least_share_of_step * h; ++k) {
    const double high = plan_->h, secant = high - (over - enough / 2) * (later - high) / (over_later - over);
    const Plan shorter = planned(secant > low && secant < high ? secant : (low + high) / 2);
    const double found = clearance_left_of(shorter);
    if (found >= 0) {
      low = shorter.h;
    } else {
      later = high, over_later = over;
      plan_ = shorter, over = found;
    }
  }
  return plan_->h;
}

double Island::deepest() const { return std::max(0.0, -std::ranges::min(clearances(plan_->stepped.after))); }

void Island::emit_again(BodyId id) {
  for (ContactPair& contact_pair : contact_pairs_)
    contact_pair.emitted = contact_pair.emitted && contact_pair.a != id && contact_pair.b != id;
}

double Island::energy() const {
  double sum = 0;
  for (const IslandBody& island_body : bodies_) {
    if (island_body.fixed()) continue;
    const contact::RigidTransform transform = island_body.step_body.transform();
    const Velocity& V = island_body.step_body.state.velocity;
    const Vec3 w_B = transform.R_WB.transpose() * V.w_WB;
    const double moving = V.v_WBcm.dot(V.v_WBcm) / 2 - island_body.step_body.acceleration.dot(transform.centre);
    sum += moving * island_body.step_body.model->mass + w_B.dot(island_body.step_body.model->I_BBcm_B * w_B) / 2;
  }
  return sum;
}

bool Island::shorten(double least_share) {
  if (!plan_) return true;
  longest = std::min(longest, std::max(plan_->h / 4, least_share * step_length_));
  return plan_->h > least_share * step_length_;
}

double Island::step_length(double steps, double most) {
  double rate = 0;
  for (const IslandBody& island_body : bodies_) {
    if (island_body.fixed()) continue;
    const Velocity& V = island_body.step_body.state.velocity;
    const double size = touchstone::size(island_body.body->body().shape);
    rate = std::max(
        rate, length(V.w_WB) + length(V.v_WBcm) / size + std::sqrt(length(island_body.step_body.acceleration) / size));
  }
  return step_length_ = std::min(most, 1 / (steps * rate));
}

double Island::deviation() const {
  const double h = plan_->h;
  const contact::Stepped& stepped = plan_->stepped;
  double most = 0;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i].fixed()) continue;
    const Velocity &before = bodies_[i].step_body.state.velocity, &after = stepped.after[i].velocity;
    const double turn = h * length(stepped.mean[i].w);
    const double spun = h * length(after.w_WB - before.w_WB) / 4 + turn * turn * turn / 8;
    const double bent = h * length(after.v_WBcm - before.v_WBcm) / 4;
    most = std::max(most, spun * (bodies_[i].body->kind() == Kind::ball ? 0 : bodies_[i].body->radius()) + bent);
  }
  return most;
}

}  // namespace touchstone::fast::world
