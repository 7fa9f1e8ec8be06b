#include "fast/simulation/contact_event.h"

#include <algorithm>

#include "fast/mark.h"
#include "fast/simulation/impact_event.h"
#include "fast/simulation/island/island_event.h"
#include "fast/simulation/later.h"
#include "fast/simulation/range.h"
#include "fast/simulation/response.h"
#include "fast/simulation/rest/rest_event.h"
#include "fast/simulation/simultaneous_impact.h"

namespace touchstone::fast::simulation {
namespace {

/// Two bodies that touch.
struct PairContact {
  Touch touch;                     ///< of the contact point that approaches fastest
  std::vector<PairPoints> points;  ///< all contact points; empty if `touch` is the only one
  double touching = 0;             ///< m; the distance up to which rounding cannot tell that the two do not touch, if
                                   ///< the envelope is less and they have no contact points within it
};

/// None if the two have no contact points within the envelope.
std::optional<PairContact> with_all_points(const Run& run, const PairEvent& pair) {
  std::vector<PairPoints> points = contact_points_of(run, pair.a, pair.b);
  const std::optional<ImpactCandidate> fastest = fastest_approach(points);
  if (!fastest) return {};
  return PairContact{fastest->touch, std::move(points)};
}

/// The contact of two bodies in ballistic motion or at rest in closed form; none if they are farther apart than
/// predicted.
std::optional<PairContact> contact_of(Run& run, const PairEvent& pair) {
  const World& world = run.world;
  const BodyMotion &a = world.body(pair.a), &b = world.body(pair.b);
  const Touch nearest = run.schedule.nearest_points(pair.a, pair.b, world.now());
  const double unresolved = 2 * clearance(a, b, world.now(), never);
  if (nearest.gap > world.envelope() && nearest.gap > unresolved) return {};
  if (has_closed_form(a, b)) return PairContact{nearest, {}};
  return with_all_points(run, pair).value_or(PairContact{nearest, {}, unresolved});
}

/// A body that may start to rest now, and its closed form, if there is one.
struct Resting {
  std::optional<RestCandidate> candidate;
  std::optional<RestingContact> contact;
};

Resting resting(const World& world, const PairEvent& pair, const Touch& touch) {
  const std::optional<RestCandidate> candidate = rest_candidate(world, pair.a, pair.b, touch);
  return {candidate, candidate ? closed_form_rest(world, *candidate, 1) : std::nullopt};
}

/// Micro-bounces after an impact that would all stay within the envelope are completed at once. The first has the speed
/// `rebound`; under the acceleration `presses` they end 2 rebound/(presses (1 − e)) later.
void complete_bounces(Run& run, const PairEvent& pair, const Touch& touch, double rebound, double presses,
                      double restitution) {
  const World& world = run.world;
  const std::optional<RestCandidate> candidate = rest_candidate(world, pair.a, pair.b, touch);
  if (!candidate) return;
  mark(Mark::micro_bounces);
  try_rest(run, *candidate, world.body(candidate->id).path().velocity(world.now()), {rebound, (1 + restitution) / 2},
           world.now() + 2 * rebound / (presses * (1 - restitution)));
}

void respond(Run& run, const PairEvent& pair, const PairContact& contact) {
  const Touch& touch = contact.touch;
  const World& world = run.world;
  const BodyMotion &a = world.body(pair.a), &b = world.body(pair.b);
  const State at_a = run.islands.state(pair.a), at_b = run.islands.state(pair.b);
  const Coefficients c = world.coefficients(pair.a, pair.b);
  const bool in_contact = run.is_in_contact(pair.a) || run.is_in_contact(pair.b) || world.had_impact_now(pair.a) ||
                          world.had_impact_now(pair.b);
  const ContactSpeeds speeds =
      contact_speeds(world, run.islands, pair.a, pair.b, touch, normal_velocity(a, at_a, b, at_b, touch), in_contact);
  const Resting rest = speeds.is_slow() && !in_contact ? resting(world, pair, touch) : Resting{};
  switch (classify(speeds, rest.contact.has_value(), run.options.micro_collisions)) {
    case Response::later:
      return schedule_later(run, pair.a, pair.b, touch);
    case Response::rest:
      return start_rest(run, *rest.candidate, *rest.contact,
                        world.body(rest.candidate->id).path().velocity(world.now()));
    case Response::join_island:
      return merge_islands(run, pair.a, pair.b, contact.touching) ? void() : schedule_later(run, pair.a, pair.b, touch);
    case Response::micro_collision:
      return apply_impulse(run, Event::Kind::micro_collision, pair.a, pair.b, touch,
                           micro_collision(a, at_a, b, at_b, touch, c, speeds.bounce_speed));
    case Response::impact:
      break;
  }
  if (c.restitution < 1 && collides_endlessly(run, pair.a, pair.b, speeds.u_n) &&
      merge_islands(run, pair.a, pair.b, contact.touching))
    return;
  const double rebound = c.restitution * -speeds.u_n, presses = pressing_acceleration(a, b, touch);
  bool is_alone = acts_alone(run, pair.a, pair.b, speeds.u_n);
  if (is_alone) {
    apply_impulse(run, Event::Kind::impact, pair.a, pair.b, touch, impact(a, at_a, b, at_b, touch, c));
  } else {
    const std::vector<PairPoints> together = acting_with(run, pair.a, pair.b, touch, contact.points);
    is_alone = together.size() == 1;
    resolve_impacts(run, together);
  }
  if (!in_contact && is_alone && rebound <= speeds.bounce_speed && c.restitution < 1)
    complete_bounces(run, pair, touch, rebound, presses, c.restitution);
}

/// With at least one body in an island. The steps lead near the predicted contact but not exactly there, so the contact
/// is tested again. If both are in islands or fixed, they take their steps together before they touch: steps of the
/// merged island end where they do. A ball likewise, since steps without contact follow its motion exactly.
void resolve_island_contact(Run& run, const PairEvent& pair) {
  cut_step(run, pair.a);
  cut_step(run, pair.b);
  if (run.islands.follows_steps(pair.a) && run.islands.follows_steps(pair.b))
    return merge_islands(run, pair.a, pair.b) ? void() : recheck(run, pair.a, pair.b);
  const std::optional<PairContact> contact = with_all_points(run, pair);
  const bool is_exact_in_steps = has_closed_form(run.world.body(pair.a), run.world.body(pair.b));
  if (!contact) return is_exact_in_steps && merge_islands(run, pair.a, pair.b) ? void() : recheck(run, pair.a, pair.b);
  for (const BodyId id : {pair.a, pair.b}) {
    if (Island* island = run.islands.of(id)) island->bound().lift();
  }
  respond(run, pair, *contact);
  run.guard.check_events(run.recorder.statistics(), run.world.now(), pair.a, pair.b);
}

}  // namespace

void resolve_contact(Run& run, const PairEvent& pair) {
  const World& world = run.world;
  if (!run.guard.makes_progress(world.now(), pair.a, pair.b)) return;
  if (run.rests.rests_on(pair.a, pair.b)) return end_rest_phase(run, pair.a);
  if (run.rests.rests_on(pair.b, pair.a)) return end_rest_phase(run, pair.b);
  if (run.schedule.was_cut_off(pair.a, pair.b))
    return run.guard.stop(world.now(), pair.a, pair.b, "a first contact takes more separation queries than allowed");
  if (run.islands.of(pair.a) || run.islands.of(pair.b)) return resolve_island_contact(run, pair);
  const BodyMotion &a = world.body(pair.a), &b = world.body(pair.b);
  if (!positions_resolved(a, b, clearance(a, b, world.now(), never)))
    return run.stop_before_now(pair.a, pair.b, "rounding moves the two by more than a thousandth of the smaller one");
  const std::optional<PairContact> contact = contact_of(run, pair);
  if (!contact) return recheck(run, pair.a, pair.b);
  respond(run, pair, *contact);
  run.guard.check_events(run.recorder.statistics(), world.now(), pair.a, pair.b);
}

}  // namespace touchstone::fast::simulation
