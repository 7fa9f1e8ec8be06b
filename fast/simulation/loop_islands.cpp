// The part of the loop that handles islands: how they merge, take steps, sleep and release bodies.
#include <algorithm>
#include <cmath>

#include "fast/simulation/loop.h"

namespace touchstone::fast::world {
namespace {

constexpr double contact_envelopes = 1 + 0x1p-6;  // envelopes: ballistic motion ends within one, up to rounding
constexpr double shortest_step = 0x1p-20;         // of the longest step: no step is requested to be shorter
constexpr double short_step = 0x1p-6;             // of the longest step: a separating pair hardly returns within it
constexpr double solver_accuracy = 0x1p-40;       // of speeds: contacts are solved to 2^-44 (constraint/solve.h)
constexpr double collides_above = 2;              // rebound speeds: a slower approach is not an impact
constexpr double releases_above = 64;             // rebound speeds: a contact that separates faster has had an impact
constexpr double rests_below = 4;                 // rebound speeds: a slower body may sleep; as for one body on a face

}  // namespace

Island* Loop::island_of(BodyId id) { return island_of_[id] ? &islands_.at(*island_of_[id]) : nullptr; }
const Island* Loop::island_of(BodyId id) const { return island_of_[id] ? &islands_.at(*island_of_[id]) : nullptr; }

/// Requires that its island, if it has one, has been advanced to now_.
State Loop::state(BodyId id) const {
  const Island* island = island_of(id);
  return island ? island->state(id) : bodies_[id].state(now_);
}

/// An upper bound of the acceleration with which the rotation of two bodies may press them together without applied
/// forces: the centripetal acceleration of their points (m/s²).
double Loop::centripetal_bound(BodyId a, BodyId b) const {
  const auto of = [&](BodyId id) {
    return bodies_[id].kind() == Kind::other ? bodies_[id].radius() * state(id).velocity.w_WB.squaredNorm() : 0;
  };
  return of(a) + of(b);
}

/// The unit of approach speeds of a pair in contact (m/s): the speed of a micro-bounce within the envelope. Without
/// applied accelerations and with e < 1, at least the speed that the contact solver cannot distinguish from rest.
double Loop::rebound_speed(BodyId a, BodyId b) const {
  const double acceleration = std::max(acceleration_[a].norm(), acceleration_[b].norm());
  if (acceleration > 0) return micro_bounce_speed(acceleration, envelope_);
  const double swings = micro_bounce_speed(centripetal_bound(a, b), envelope_);
  if (coefficients(bodies_[a], bodies_[b], scene_->motion->law).restitution == 1) return swings;
  const auto speed = [&](BodyId id) {
    const Velocity V = state(id).velocity;
    return V.v_WBcm.norm() + bodies_[id].radius() * V.w_WB.norm();
  };
  return std::max(swings, solver_accuracy * (speed(a) + speed(b)));
}

double Loop::least_rebound_speed(const Island& island) const {
  double least = never;
  for (const ContactPair& contact_pair : island.contact_pairs())
    least = std::min(least, rebound_speed(contact_pair.a, contact_pair.b));
  return least;
}

/// Ends the current step of the body's island at now_.
void Loop::cut_step(BodyId id) {
  Island* island = island_of(id);
  if (!island) return;
  const double before = island->energy();
  island->advance_to(now_);
  done_.statistics.contact_loss += before - island->energy();
  island->waits = true;
}

IslandBody Loop::island_body(BodyId id) {
  const BodyMotion& body = bodies_[id];
  return {id, &body, {&body.model(), state(id), body.fixed() ? Vec3(Vec3::Zero()) : acceleration_[id]}};
}

/// Like process_pair_event, for a pair with at least one body in an island. The steps lead near the predicted contact
/// but not exactly there, so the contact is tested again. If both bodies are in islands or fixed, their islands merge
/// before the bodies touch: steps of the merged island end where they do.
void Loop::process_island_event(const PairEvent& pair_event) {
  cut_step(pair_event.a);
  cut_step(pair_event.b);
  if (follows_steps(pair_event.a) && follows_steps(pair_event.b))
    return merge_islands(pair_event) ? void() : recheck(pair_event);
  const std::optional<Touch> touch = fastest_approach(pair_event);
  if (!touch) return recheck(pair_event);
  respond(pair_event, *touch);
  stop_if_endless(pair_event);
}

/// The pair is farther apart than predicted. An island continues with shorter steps, within which its represented
/// trajectories are more accurate.
void Loop::recheck(const PairEvent& pair_event) {
  if (!island_of_[pair_event.a] && !island_of_[pair_event.b]) return schedule(pair_event.a, pair_event.b, now_);
  for (const BodyId id : {pair_event.a, pair_event.b}) {
    if (Island* island = island_of(id)) island->shorten(shortest_step);
  }
}

/// The pair touches within the envelope but separates: from now on it counts as in contact only where the bodies
/// overlap. If the represented trajectories deviate faster than the bodies separate, this cannot be decided, so steps
/// get shorter until another contact point that comes down is found in time. If no step is short enough, or if the pair
/// can touch at one point only, it is not queried within the step.
void Loop::defer_separating_pair(const PairEvent& pair_event) {
  const bool is_point = has_closed_form(bodies_[pair_event.a], bodies_[pair_event.b]);
  bool shorter = false;
  for (const BodyId id : {pair_event.a, pair_event.b}) {
    Island* island = island_of(id);
    if (island && island->shorten(is_point ? short_step : shortest_step)) shorter = true;
  }
  PairMemory& memory = memory_[key(pair_event.a, pair_event.b)];
  memory.separating_at = now_;
  memory.impacts = impacts_[pair_event.a] + impacts_[pair_event.b];
  if (is_point || !shorter) memory.not_queried_at = now_;
}

/// Puts both bodies, with all bodies that they are in contact with, into one island. Returns false if they are out of
/// reach.
bool Loop::merge_islands(const PairEvent& pair_event) {
  Island merged(contact_envelopes * envelope_, reach_);
  merged.since = now_;
  std::vector<BodyPair> links{{pair_event.a, pair_event.b}};
  const auto take = [&](BodyId id) {
    if (merged.has(id)) return;
    if (Island* island = island_of(id)) {
      merged.absorb(*island);
    } else {
      merged.add(island_body(id));
    }
    if (rest_[id]) links.push_back({std::min(id, rest_[id]->on), std::max(id, rest_[id]->on)});
  };
  take(pair_event.a);
  take(pair_event.b);
  for (std::size_t i = 1; i < links.size(); ++i) {
    take(links[i].a);
    take(links[i].b);
  }
  for (const BodyPair& link : links) {
    if (!merged.link(link.a, link.b) && link.a == pair_event.a && link.b == pair_event.b) return false;
  }
  for (const IslandBody& island_body : merged.bodies()) {
    if (island_body.fixed()) continue;
    if (island_of_[island_body.id]) islands_.erase(*island_of_[island_body.id]);
    island_of_[island_body.id].reset();
    rest_[island_body.id].reset();
  }
  add_island(std::move(merged));
  return true;
}

void Loop::add_island(Island island) {
  const BodyId key = island.key();
  for (const IslandBody& island_body : island.bodies()) {
    if (!island_body.fixed()) island_of_[island_body.id] = key;
  }
  islands_.insert_or_assign(key, std::move(island));
}

/// The first island whose next step has not begun.
std::optional<BodyId> Loop::next_waiting() const {
  for (const auto& [key, island] : islands_) {
    if (island.waits) return key;
  }
  return {};
}

/// The island whose step ends first.
std::optional<BodyId> Loop::first_to_finish() const {
  std::optional<BodyId> first;
  for (const auto& [key, island] : islands_) {
    if (!island.waits && (!first || island.until < islands_.at(*first).until)) first = key;
  }
  return first;
}

void Loop::finish_step(BodyId key) {
  Island& island = islands_.at(key);
  sample_until(island.until, false);
  now_ = std::max(now_, island.until);
  const ContactPair& first = island.contact_pairs().front();
  if (!makes_progress({now_, first.a, first.b})) return;
  cut_step(key);
  island.longest *= 2;
}

/// Begins the next step of an island at now_: releases the bodies whose contacts separate, splits the rest into
/// connected islands, and resolves each of these.
void Loop::begin_step(BodyId key) {
  Island& island = islands_.at(key);
  const std::vector<ContactPair> released =
      island.take_out_separating([&](BodyId a, BodyId b) { return releases_above * rebound_speed(a, b); });
  std::vector<Island> left = island.components();
  std::vector<IslandBody> bodies = island.bodies();
  islands_.erase(key);
  for (const IslandBody& island_body : bodies) island_of_[island_body.id].reset();
  for (Island& one : left) add_island(std::move(one));
  for (const IslandBody& island_body : bodies) {
    if (island_body.fixed() || island_of_[island_body.id]) continue;
    release_from_island(island_body, released);
  }
  for (const IslandBody& island_body : bodies) {
    if (!island_body.fixed() && island_of_[island_body.id] == island_body.id) resolve_island(island_body.id);
  }
}

/// An impact of the pair at one contact point.
void Loop::impact_in_island(const ImpactCandidate& found) {
  if (!makes_progress({now_, found.a, found.b})) return;
  const BodyMotion &a = bodies_[found.a], &b = bodies_[found.b];
  const Coefficients c = coefficients(a, b, scene_->motion->law);
  const PairEvent pair{now_, found.a, found.b};
  apply_impulse(Event::Kind::impact, pair, found.touch, impact(a, state(found.a), b, state(found.b), found.touch, c));
}

/// The body has no contact left and moves ballistically. If the other body of the released pair stays in contact with
/// others, its contact events are emitted again.
void Loop::release_from_island(const IslandBody& island_body, const std::vector<ContactPair>& released) {
  const auto contact_pair = std::ranges::find_if(
      released, [&](const ContactPair& j) { return j.a == island_body.id || j.b == island_body.id; });
  set_trajectory(island_body.id, island_body.step_body.state);
  if (contact_pair != released.end()) {
    emit(Event::Kind::release, *contact_pair);
    const BodyId other = contact_pair->a == island_body.id ? contact_pair->b : contact_pair->a;
    if (Island* island = island_of(other)) island->emit_again(other);
  }
  schedule_all(island_body.id, island_body.id);
}

/// Continues an island whose contacts persist: by an impact at its fastest contact point, in closed form, asleep, or by
/// a step. After too many impacts at one time the approach at all contact points is removed at once, without
/// restitution.
void Loop::resolve_island(BodyId key) {
  Island& island = islands_.at(key);
  const std::optional<ImpactCandidate> found = island.fastest_approach();
  const bool collides = found && found->u_n < -collides_above * rebound_speed(found->a, found->b);
  if (collides && island.allows_impact()) return impact_in_island(*found);
  if (try_closed_form(island)) return;
  const double before = island.energy();
  const bool begins = collides || std::ranges::any_of(island.contact_pairs(), [](const ContactPair& contact_pair) {
                        return !contact_pair.emitted && !contact_pair.contact_points.empty();
                      });
  if (begins) island.remove_approach();
  if (island.rest_test(rests_below * least_rebound_speed(island))) {
    island.until = never;
    island.margin = 0;
  } else {
    take_step(island);
  }
  done_.statistics.contact_loss += before - island.energy();
  island.waits = false;
  for (ContactPair& contact_pair : island.contact_pairs()) {
    if (contact_pair.emitted || contact_pair.contact_points.empty()) continue;
    emit(Event::Kind::contact, contact_pair);
    contact_pair.emitted = true;
  }
  set_trajectories(island);
}

/// Turns an island of one body on a fixed one into a resting contact, if that has a closed form.
bool Loop::try_closed_form(Island& island) {
  if (island.bodies().size() != 2) return false;
  const IslandBody &first = island.bodies()[0], &second = island.bodies()[1];
  if (!first.fixed() && !second.fixed()) return false;
  const IslandBody &body = first.fixed() ? second : first, &on = first.fixed() ? first : second;
  const Vec3 n = island.contact_pairs().front().nhat_BA_W;
  const Vec3 towards = body.id == island.contact_pairs().front().a ? n : Vec3(-n);
  const RestCandidate candidate{body.id, on.id, towards, without_normal(*on.body, body.step_body.state, towards)};
  const Vec3 v_before = body.step_body.state.velocity.v_WBcm;
  bodies_[body.id].restart(now_, candidate.state, acceleration_[body.id]);
  if (!closed_form_rest(candidate, 1)) return false;
  islands_.erase(*island_of_[candidate.id]);
  island_of_[candidate.id].reset();
  start_rest(candidate, {}, now_);
  record_contact(Event::Kind::contact, candidate.id, v_before, now_);
  return true;
}

void Loop::take_step(Island& island) {
  const double step_length = island.step_length(options_.contact_steps, end_);
  const double h = std::clamp(island.longest, shortest_step * step_length, step_length);
  island.link_parts(h);
  island.until = std::max(now_ + island.plan((now_ + h) - now_), std::nextafter(now_, never));
  island.margin = island.deviation();
  if (++done_.statistics.contact_steps > options_.most_contact_steps) {
    stop({now_, island.contact_pairs().front().a, island.contact_pairs().front().b},
         "contacts that take more steps than allowed");
  }
  done_.statistics.deepest = std::max(done_.statistics.deepest, island.deepest());
}

/// Sets the trajectories of its bodies for the step and schedules their possible contacts.
void Loop::set_trajectories(Island& island) {
  const bool sleeps = island.until == never;
  for (std::size_t i = 0; i < island.bodies().size(); ++i) {
    const IslandBody& island_body = island.bodies()[i];
    if (island_body.fixed()) continue;
    const State& now = island_body.step_body.state;
    const Vec3 gained =
        sleeps ? Vec3::Zero() : Vec3(island.planned_step().after[i].velocity.v_WBcm - now.velocity.v_WBcm);
    bodies_[island_body.id].follow_step(now_, now, sleeps ? Vec3(Vec3::Zero()) : Vec3(gained / (island.until - now_)),
                                        sleeps ? Vec3(Vec3::Zero()) : island.planned_step().mean[i].w);
    queue_.drop(island_body.id);
    update_proxy(island_body.id);
  }
  for (const IslandBody& island_body : island.bodies()) {
    if (!island_body.fixed()) schedule_all(island_body.id, island_body.id);
  }
}

void Loop::emit(Event::Kind kind, const ContactPair& contact_pair) {
  record({kind, now_, static_cast<int>(contact_pair.a), static_cast<int>(contact_pair.b), contact_pair.p_WC,
          contact_pair.nhat_BA_W, Vec3::Zero(), state(contact_pair.a), state(contact_pair.b)});
}

}  // namespace touchstone::fast::world
