// The part of the loop that is about several contacts at once: who holds whom, and the steps that they take together.
#include <algorithm>
#include <cmath>

#include "fast/simulation/loop.h"

namespace touchstone::fast::world {
namespace {

constexpr double touching = 1 + 0x1p-6;  // envelopes: flights end within one, but for rounding
constexpr double shortest = 0x1p-20;     // of a stride: no step is asked to be shorter
constexpr double short_enough = 0x1p-6;  // of a stride: what parts now comes back by little within it
constexpr double solved = 0x1p-40;  // of speeds: contacts are solved to 2^-44 (constraint/solve.h), feet many at once
constexpr double slow = 2;          // hops: what approaches no faster does not strike
constexpr double lets_go = 64;      // hops: what parts faster has been struck
constexpr double still = 4;         // hops: who is no faster may stand; as for one body on a face

}  // namespace

Group* Loop::group_of(BodyId id) { return group_of_[id] ? &groups_.at(*group_of_[id]) : nullptr; }
const Group* Loop::group_of(BodyId id) const { return group_of_[id] ? &groups_.at(*group_of_[id]) : nullptr; }

/// Requires that its group, if it has one, has been brought to now.
State Loop::state(BodyId id) const {
  const Group* group = group_of(id);
  return group ? group->state(id) : bodies_[id].state(now_);
}

/// How hard two bodies may come to press though nothing pulls them: as a point does that goes round (m/s²).
double Loop::swing(BodyId a, BodyId b) const {
  const auto of = [&](BodyId id) {
    return bodies_[id].kind() == Kind::other ? bodies_[id].radius() * state(id).velocity.w_WB.squaredNorm() : 0;
  };
  return of(a) + of(b);
}

/// How fast a pair that is held may approach without striking: as fast as a hop within the envelope would; where
/// nothing pulls, no more slowly than the solver of contacts can tell from rest.
double Loop::hop_of(BodyId a, BodyId b) const {
  const double pull = std::max(pull_[a].norm(), pull_[b].norm());
  if (pull > 0) return least_speed(pull, envelope_);
  const double swings = least_speed(swing(a, b), envelope_);
  if (coefficients(bodies_[a], bodies_[b], scene_->flight->law).restitution == 1) return swings;
  const auto speed = [&](BodyId id) {
    const Velocity V = state(id).velocity;
    return V.v_WBcm.norm() + bodies_[id].radius() * V.w_WB.norm();
  };
  return std::max(swings, solved * (speed(a) + speed(b)));
}

double Loop::least_hop(const Group& group) const {
  double least = never;
  for (const Joint& joint : group.joints()) least = std::min(least, hop_of(joint.a, joint.b));
  return least;
}

/// Ends the step that the body's group is taking here and now.
void Loop::cut(BodyId id) {
  Group* group = group_of(id);
  if (!group) return;
  const double before = group->energy();
  group->go_to(now_);
  done_.books.contact_loss += before - group->energy();
  group->waits = true;
}

Rider Loop::rider(BodyId id) {
  const Mover& body = bodies_[id];
  return {id, &body, {&body.flyer(), state(id), body.fixed() ? Vec3(Vec3::Zero()) : pull_[id]}};
}

/// As attend, of a pair of which one at least is held. Where steps have brought them is near where they were foreseen,
/// not there: it is looked at anew. Two that are held, or fixed, go on together before they touch: then steps end where
/// they do.
void Loop::attend_held(const Due& due) {
  cut(due.a);
  cut(due.b);
  if (follows_steps(due.a) && follows_steps(due.b)) return join(due) ? void() : not_yet(due);
  const std::optional<Touch> touch = foremost(due);
  if (!touch) return not_yet(due);
  meet(due, *touch);
  stop_if_endless(due);
}

/// They are not as near as was said. A group on its way goes on by shorter steps, in which its paths are what they are
/// said to be.
void Loop::not_yet(const Due& due) {
  if (!group_of_[due.a] && !group_of_[due.b]) return watch(due.a, due.b, now_);
  for (const BodyId id : {due.a, due.b}) {
    if (Group* group = group_of(id)) group->shorten(shortest);
  }
}

/// They touch, and part: within an envelope, so that from now on they are in contact where they overlap only. Paths
/// that drift faster than the two part hide that; in a step so short that they do not, another point may come down in
/// time. Where none is short enough, and for points that have no other beside them, nobody asks within the step.
void Loop::part_held(const Due& due) {
  const bool is_point = has_closed_form(bodies_[due.a], bodies_[due.b]);
  bool shorter = false;
  for (const BodyId id : {due.a, due.b}) {
    Group* group = group_of(id);
    if (group && group->shorten(is_point ? short_enough : shortest)) shorter = true;
  }
  Memory& memory = memory_[key(due.a, due.b)];
  memory.parted = now_;
  memory.strikes = strikes_[due.a] + strikes_[due.b];
  if (is_point || !shorter) memory.unasked = now_;
}

/// From now on the two hold each other, with all that they hold already.
bool Loop::join(const Due& due) {
  Group joined(touching * envelope_, reach_);
  joined.since = now_;
  std::vector<BodyPair> links{{due.a, due.b}};
  const auto take = [&](BodyId id) {
    if (joined.has(id)) return;
    if (Group* group = group_of(id)) {
      joined.absorb(*group);
    } else {
      joined.add(rider(id));
    }
    if (rest_[id]) links.push_back({std::min(id, rest_[id]->on), std::max(id, rest_[id]->on)});
  };
  take(due.a);
  take(due.b);
  for (std::size_t i = 1; i < links.size(); ++i) {
    take(links[i].a);
    take(links[i].b);
  }
  for (const BodyPair& link : links) {
    if (!joined.link(link.a, link.b) && link.a == due.a && link.b == due.b) return false;
  }
  for (const Rider& rider : joined.riders()) {
    if (rider.fixed()) continue;
    if (group_of_[rider.id]) groups_.erase(*group_of_[rider.id]);
    group_of_[rider.id].reset();
    rest_[rider.id].reset();
  }
  enter(std::move(joined));
  return true;
}

void Loop::enter(Group group) {
  const BodyId key = group.key();
  for (const Rider& rider : group.riders()) {
    if (!rider.fixed()) group_of_[rider.id] = key;
  }
  groups_.insert_or_assign(key, std::move(group));
}

/// The first group whose next step has not begun.
std::optional<BodyId> Loop::waiting() const {
  for (const auto& [key, group] : groups_) {
    if (group.waits) return key;
  }
  return {};
}

/// The group whose step ends first.
std::optional<BodyId> Loop::first_to_arrive() const {
  std::optional<BodyId> first;
  for (const auto& [key, group] : groups_) {
    if (!group.waits && (!first || group.until < groups_.at(*first).until)) first = key;
  }
  return first;
}

void Loop::arrive(BodyId key) {
  Group& group = groups_.at(key);
  look_until(group.until, false);
  now_ = std::max(now_, group.until);
  const Joint& first = group.joints().front();
  if (!goes_on({now_, first.a, first.b})) return;
  cut(key);
  group.longest *= 2;
}

/// What follows for a group that stands at now: joints that part are let go; of who is left, a foot that comes down
/// strikes; else they rest, stand, or take a step.
void Loop::begin(BodyId key) {
  Group& group = groups_.at(key);
  const std::vector<Joint> parted = group.part([&](BodyId a, BodyId b) { return lets_go * hop_of(a, b); });
  std::vector<Group> left = group.components();
  std::vector<Rider> riders = group.riders();
  groups_.erase(key);
  for (const Rider& rider : riders) group_of_[rider.id].reset();
  for (Group& one : left) enter(std::move(one));
  for (const Rider& rider : riders) {
    if (rider.fixed() || group_of_[rider.id]) continue;
    fly_off(rider, parted);
  }
  for (const Rider& rider : riders) {
    if (!rider.fixed() && group_of_[rider.id] == rider.id) settle(rider.id);
  }
}

/// At one foot, as an impact of its pair.
void Loop::strike_in(const Strike& found) {
  if (!goes_on({now_, found.a, found.b})) return;
  const Mover &a = bodies_[found.a], &b = bodies_[found.b];
  const Coefficients c = coefficients(a, b, scene_->flight->law);
  const Due pair{now_, found.a, found.b};
  strike(Event::Kind::impact, pair, found.touch, impact(a, state(found.a), b, state(found.b), found.touch, c));
}

/// Nothing holds the body any more. Who stays held by others is said to, once more.
void Loop::fly_off(const Rider& rider, const std::vector<Joint>& parted) {
  const auto joint = std::ranges::find_if(parted, [&](const Joint& j) { return j.a == rider.id || j.b == rider.id; });
  set_out(rider.id, rider.member.state);
  if (joint != parted.end()) {
    tell(Event::Kind::release, *joint);
    const BodyId other = joint->a == rider.id ? joint->b : joint->a;
    if (Group* group = group_of(other)) group->tell_anew(other);
  }
  watch_all(rider.id, rider.id);
}

/// A group whose joints hold: a strike, and no more now; or in closed form, standing, or by a step. After so many
/// strikes at one time what approaches is taken from all feet at once, without restitution.
void Loop::settle(BodyId key) {
  Group& group = groups_.at(key);
  const std::optional<Strike> found = group.foremost();
  const bool strikes = found && found->u_n < -slow * hop_of(found->a, found->b);
  if (strikes && group.may_strike()) return strike_in(*found);
  if (rests_alone(group)) return;
  const double before = group.energy();
  const bool begins = strikes || std::ranges::any_of(group.joints(), [](const Joint& joint) {
                        return !joint.told && !joint.feet.empty();
                      });
  if (begins) group.land();
  if (group.stands(still * least_hop(group))) {
    group.until = never;
    group.margin = 0;
  } else {
    take_step(group);
  }
  done_.books.contact_loss += before - group.energy();
  group.waits = false;
  for (Joint& joint : group.joints()) {
    if (joint.told || joint.feet.empty()) continue;
    tell(Event::Kind::contact, joint);
    joint.told = true;
  }
  set_on_course(group);
}

/// One body on one face, where a closed form is known.
bool Loop::rests_alone(Group& group) {
  if (group.riders().size() != 2) return false;
  const Rider &first = group.riders()[0], &second = group.riders()[1];
  if (!first.fixed() && !second.fixed()) return false;
  const Rider &body = first.fixed() ? second : first, &on = first.fixed() ? first : second;
  const Vec3 n = group.joints().front().nhat_BA_W;
  const Vec3 towards = body.id == group.joints().front().a ? n : Vec3(-n);
  const Laid laid{body.id, on.id, towards, without_normal(*on.body, body.member.state, towards)};
  const Vec3 v_before = body.member.state.velocity.v_WBcm;
  bodies_[body.id].fly(now_, laid.state, pull_[body.id]);
  if (!rest_of(laid, 1)) return false;
  groups_.erase(*group_of_[laid.id]);
  group_of_[laid.id].reset();
  lay(laid, {}, now_);
  record_contact(Event::Kind::contact, laid.id, v_before, now_);
  return true;
}

void Loop::take_step(Group& group) {
  const double stride = group.stride(options_.contact_steps, end_);
  const double h = std::clamp(group.longest, shortest * stride, stride);
  group.link_parts(h);
  group.until = std::max(now_ + group.plan((now_ + h) - now_), std::nextafter(now_, never));
  group.margin = group.deviation();
  if (++done_.books.contact_steps > options_.most_contact_steps) {
    stop({now_, group.joints().front().a, group.joints().front().b}, "contacts that take more steps than allowed");
  }
  done_.books.deepest = std::max(done_.books.deepest, group.deepest());
}

/// The paths of its bodies, and whom they may meet on them.
void Loop::set_on_course(Group& group) {
  const bool stands = group.until == never;
  for (std::size_t i = 0; i < group.riders().size(); ++i) {
    const Rider& rider = group.riders()[i];
    if (rider.fixed()) continue;
    const State& now = rider.member.state;
    const Vec3 gained = stands ? Vec3::Zero() : Vec3(group.course().after[i].velocity.v_WBcm - now.velocity.v_WBcm);
    bodies_[rider.id].glide(now_, now, stands ? Vec3(Vec3::Zero()) : Vec3(gained / (group.until - now_)),
                            stands ? Vec3(Vec3::Zero()) : group.course().mean[i].w);
    heap_.drop(rider.id);
    file(rider.id);
  }
  for (const Rider& rider : group.riders()) {
    if (!rider.fixed()) watch_all(rider.id, rider.id);
  }
}

void Loop::tell(Event::Kind kind, const Joint& joint) {
  record({kind, now_, static_cast<int>(joint.a), static_cast<int>(joint.b), joint.p_WC, joint.nhat_BA_W, Vec3::Zero(),
          state(joint.a), state(joint.b)});
}

}  // namespace touchstone::fast::world
