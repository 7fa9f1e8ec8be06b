#include "fast/simulation/island/island_event.h"

#include <algorithm>

#include "fast/mark.h"
#include "fast/simulation/impact_event.h"
#include "fast/simulation/island/island_rest.h"
#include "fast/simulation/response.h"
#include "fast/simulation/rest/rest_event.h"
#include "fast/simulation/simultaneous_impact.h"
#include "fast/simulation/trajectory.h"

namespace touchstone::fast::simulation {
namespace {

constexpr double contact_envelopes = 1 + 0x1p-6;  // envelopes: ballistic motion ends within one, up to rounding
constexpr double collides_above = 2;              // rebound speeds: a slower approach is not an impact
constexpr double releases_above = 64;             // rebound speeds: a contact that separates faster has had an impact
constexpr double rests_below = 4;                 // rebound speeds: a slower body may sleep; as for one body on a face

IslandBody island_body(const Run& run, BodyId id) {
  const BodyMotion& body = run.world.body(id);
  const Vec3 acceleration = body.fixed() ? Vec3(Vec3::Zero()) : run.world.acceleration(id);
  return {id, &body, {&body.model(), run.islands.state(id), acceleration}};
}

/// The contact pairs of two bodies whose parts are within the envelope, as they come together.
ContactGraph graph_of_pair(const Run& run, BodyId a, BodyId b) {
  ContactGraph pair(run.world.envelope(), run.world.envelope());
  pair.add(island_body(run, a));
  pair.add(island_body(run, b));
  pair.link(a, b);
  for (ContactPair& parts : pair.contact_pairs())
    choose_normal_of_approach(parts, pair.bodies()[0], pair.bodies()[1], pair.near());
  return pair;
}

double rebound_speed(const Run& run, BodyId a, BodyId b) { return rebound_speed(run.world, run.islands, a, b); }

double least_rebound_speed(const Run& run, const ContactGraph& graph) {
  double least = never;
  for (const ContactPair& pair : graph.contact_pairs()) least = std::min(least, rebound_speed(run, pair.a, pair.b));
  return least;
}

void record_pair(Run& run, Event::Kind kind, const ContactPair& pair) {
  run.recorder.record({kind, run.world.now(), static_cast<int>(pair.a), static_cast<int>(pair.b), pair.p_WC,
                       pair.nhat_BA_W, Vec3::Zero(), run.islands.state(pair.a), run.islands.state(pair.b)});
}

/// Of the released pairs of a body the one that is least apart: others may have let go at the start of the step.
const ContactPair* last_to_let_go(const ContactGraph& graph, BodyId id, const std::vector<ContactPair>& released) {
  const ContactPair* last = nullptr;
  double least = never;
  for (const ContactPair& pair : released) {
    if (!pair.has(id)) continue;
    const IslandBody &A = graph.bodies()[graph.index(pair.a)], &B = graph.bodies()[graph.index(pair.b)];
    const double apart = distance(pair, A, A.state(), B, B.state());
    if (!last || apart < least) last = &pair, least = apart;
  }
  return last;
}

/// The body has no contact left and moves ballistically. If the other body of the released pair stays in contact with
/// others, its contact events are emitted again.
void release_from_island(Run& run, const ContactGraph& graph, const IslandBody& island_body,
                         const std::vector<ContactPair>& released) {
  const BodyId id = island_body.id;
  const ContactPair* pair = last_to_let_go(graph, id, released);
  set_trajectory(run, id, island_body.state());
  if (pair) {
    record_pair(run, Event::Kind::release, *pair);
    const BodyId other = pair->a == id ? pair->b : pair->a;
    if (Island* island = run.islands.of(other)) island->graph().emit_again(other);
  }
  run.schedule.predict_all(id);
}

/// One round of impacts: of the contact pairs that approach faster than an impact must.
void impacts_in_island(Run& run, const std::vector<PairPoints>& contacts, const ImpactCandidate& fastest) {
  if (!run.guard.makes_progress(run.world.now(), fastest.a, fastest.b)) return;
  resolve_impacts(run, acting(contacts, [&](BodyId a, BodyId b) { return collides_above * rebound_speed(run, a, b); }));
}

/// Turns an island of one body on a fixed one into a resting contact, if that has a closed form.
bool try_closed_form(Run& run, const ContactGraph& graph) {
  if (graph.bodies().size() != 2) return false;
  const IslandBody &first = graph.bodies()[0], &second = graph.bodies()[1];
  if (!first.fixed() && !second.fixed()) return false;
  const IslandBody &body = first.fixed() ? second : first, &on = first.fixed() ? first : second;
  const ContactPair& pair = graph.contact_pairs().front();
  const Vec3 towards = body.id == pair.a ? pair.nhat_BA_W : Vec3(-pair.nhat_BA_W);
  const RestCandidate candidate{body.id, on.id, towards, without_normal(*on.body, body.state(), towards)};
  World& world = run.world;
  world.body(candidate.id).restart(world.now(), candidate.state, world.acceleration(candidate.id));
  const std::optional<RestingContact> rest = closed_form_rest(world, candidate, 1);
  if (!rest) return false;
  run.islands.take(candidate.id);
  // No impulse: contacts of islands report none, so there is none since the body's last event to which this would add.
  start_rest(run, candidate, *rest, rest->start.velocity.v_WBcm);
  return true;
}

void take_step(Run& run, Island& island) {
  island.begin_step(run.options.contact_steps, run.world.end());
  Statistics& statistics = run.recorder.statistics();
  ++statistics.contact_steps;
  const ContactPair& first = island.graph().contact_pairs().front();
  run.guard.check_steps(statistics, run.world.now(), first.a, first.b);
  statistics.deepest = std::max(statistics.deepest, deepest(island.graph(), island.plan()));
}

/// Counts the residual of a step that was taken. Stops the run if the solver, and not the step, determines the error.
void count_residual(Run& run, const ContactGraph& graph, double residual) {
  Statistics& statistics = run.recorder.statistics();
  statistics.residual = std::max(statistics.residual, residual);
  if (residual > accuracy(graph)) ++statistics.unconverged;
  const ContactPair& first = graph.contact_pairs().front();
  run.guard.check_residual(residual, residual_bound(graph, run.options.contact_steps), run.world.now(), first.a,
                           first.b);
}

/// Sets the trajectories that represent the island's step, and predicts the contacts of its bodies.
void set_trajectories(Run& run, const Island& island) {
  const double now = run.world.now();
  const std::vector<IslandBody>& bodies = island.graph().bodies();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].fixed()) continue;
    const State& state = bodies[i].state();
    Vec3 acceleration = Vec3::Zero(), spin = Vec3::Zero();
    if (!island.sleeps()) {
      const contact::Stepped& step = island.plan().stepped;
      const Vec3 gained = step.after[i].velocity.v_WBcm - state.velocity.v_WBcm;
      acceleration = gained / (island.until() - now);
      spin = step.mean[i].w;
    }
    run.world.body(bodies[i].id).follow_step(now, state, acceleration, spin);
    run.schedule.trajectory_changed(bodies[i].id);
  }
  for (const IslandBody& island_body : bodies) {
    if (!island_body.fixed()) run.schedule.predict_all(island_body.id);
  }
}

/// After too many impacts at one time the approach at all contact points is removed at once, without restitution.
void resolve_island(Run& run, Island& island) {
  ContactGraph& graph = island.graph();
  const std::vector<PairPoints> contacts = graph.points();
  const std::optional<ImpactCandidate> found = fastest_approach(contacts);
  const bool collides = found && found->u_n < -collides_above * rebound_speed(run, found->a, found->b);
  if (collides && island.allows_impact()) return impacts_in_island(run, contacts, *found);
  if (try_closed_form(run, graph)) return;
  const double before = energy(graph);
  const bool begins = collides || std::ranges::any_of(graph.contact_pairs(), [](const ContactPair& pair) {
                        return !pair.emitted && !pair.contact_points.empty();
                      });
  if (begins) remove_approach(graph);
  if (rest_test(graph, rests_below * least_rebound_speed(run, graph))) {
    island.sleep();
  } else {
    take_step(run, island);
  }
  run.recorder.statistics().contact_loss += before - energy(graph);
  for (ContactPair& pair : graph.contact_pairs()) {
    if (pair.emitted || pair.contact_points.empty()) continue;
    record_pair(run, Event::Kind::contact, pair);
    pair.emitted = true;
  }
  set_trajectories(run, island);
}

}  // namespace

std::vector<PairPoints> contact_points_of(const Run& run, BodyId a, BodyId b) {
  return graph_of_pair(run, a, b).points();
}

bool merge_islands(Run& run, BodyId a, BodyId b, double touching) {
  const double near = contact_envelopes * std::max(run.world.envelope(), touching);
  Island merged(ContactGraph(near, std::max(run.world.reach(), near)), run.world.now());
  ContactGraph& graph = merged.graph();
  std::vector<BodyPair> links{{a, b}};
  const auto add = [&](BodyId id) {
    if (graph.has(id)) return;
    if (const Island* island = run.islands.of(id)) {
      merged.absorb(*island);
    } else {
      graph.add(island_body(run, id));
    }
    if (const RestingContact* rest = run.rests.of(id))
      links.push_back({std::min(id, rest->on), std::max(id, rest->on)});
  };
  add(a);
  add(b);
  for (std::size_t i = 1; i < links.size(); ++i) {
    add(links[i].a);
    add(links[i].b);
  }
  for (const BodyPair& link : links) {
    if (!graph.link(link.a, link.b) && link.a == a && link.b == b) return false;
  }
  for (const IslandBody& island_body : graph.bodies()) {
    if (island_body.fixed()) continue;
    if (run.islands.of(island_body.id)) run.islands.take(island_body.id);
    sum_up_bounces(run, island_body.id);
    run.rests.erase(island_body.id);
  }
  run.islands.insert(std::move(merged));
  mark(Mark::island_merge);
  return true;
}

void cut_step(Run& run, BodyId id) {
  Island* island = run.islands.of(id);
  if (!island) return;
  const double before = energy(island->graph());
  const std::optional<double> residual = island->end_step(run.world.now());
  run.recorder.statistics().contact_loss += before - energy(island->graph());
  if (residual) count_residual(run, island->graph(), *residual);
}

void finish_step(Run& run, BodyId id) {
  cut_step(run, id);
  run.islands.of(id)->bound().lengthen();
}

void begin_step(Run& run, BodyId id) {
  const std::vector<ContactPair> released = run.islands.of(id)->graph().take_out_separating(
      [&](BodyId a, BodyId b) { return releases_above * rebound_speed(run, a, b); });
  const Island whole = run.islands.take(id);
  for (Island& part : whole.components()) run.islands.insert(std::move(part));
  for (const IslandBody& island_body : whole.graph().bodies()) {
    if (!island_body.fixed() && !run.islands.of(island_body.id))
      release_from_island(run, whole.graph(), island_body, released);
  }
  for (const IslandBody& island_body : whole.graph().bodies()) {
    Island* const island = island_body.fixed() ? nullptr : run.islands.of(island_body.id);
    if (island && island->graph().key() == island_body.id) resolve_island(run, *island);
  }
}

}  // namespace touchstone::fast::simulation
