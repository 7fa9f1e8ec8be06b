#include "fast/simulation/impact_event.h"

#include "fast/simulation/response.h"
#include "fast/simulation/rest/rest_event.h"
#include "fast/simulation/trajectory.h"

namespace touchstone::fast::simulation {
namespace {

// Impacts of one pair in one place. After that many, corners that collide in turn are slower by 2^32, or separate.
constexpr int most_impacts_in_place = 32;

}  // namespace

void apply_impulse(Run& run, Event::Kind kind, BodyId id_a, BodyId id_b, const Touch& touch, ImpactResult result) {
  World& world = run.world;
  if (run.exact_momentum) run.exact_momentum->apply(id_a, id_b, result);
  for (const BodyId id : {id_a, id_b}) sum_up_bounces(run, id);
  const State before_a = run.islands.state(id_a), before_b = run.islands.state(id_b);
  const State a{before_a.X_WB, result.after_a}, b{before_b.X_WB, result.after_b};
  Statistics& statistics = run.recorder.statistics();
  statistics.loss += result.loss;
  if (world.body(id_a).fixed()) statistics.to_fixed += result.P_A_W;
  if (world.body(id_b).fixed()) statistics.to_fixed -= result.P_A_W;
  run.recorder.record({kind, world.now(), static_cast<int>(id_a), static_cast<int>(id_b), touch.p_WC, touch.nhat_BA_W,
                       result.P_A_W, a, b});
  for (const BodyId id : {id_a, id_b}) {
    if (run.rests.of(id)) release_rest(run, id, id == id_a ? a : b);
    const BodyMotion& body = world.body(id);
    if (!body.fixed()) world.count_impact(id, speed_bound(body, (id == id_a ? before_a : before_b).velocity));
  }
  set_trajectory(run, id_a, a);
  set_trajectory(run, id_b, b);
  if (!world.body(id_a).fixed()) run.schedule.predict_all(id_a);
  if (!world.body(id_b).fixed()) run.schedule.predict_all(id_b, world.body(id_a).fixed() ? id_b : id_a);
}

bool collides_endlessly(Run& run, BodyId a, BodyId b, double u_n) {
  if (has_closed_form(run.world.body(a), run.world.body(b))) return false;
  PairMemory& memory = run.schedule.memory(a, b);
  const double now = run.world.now();
  const bool again = (now - memory.last_impact) * -u_n <= run.world.envelope();
  memory.impacts_in_place = again ? memory.impacts_in_place + 1 : 1;
  memory.last_impact = now;
  return memory.impacts_in_place > most_impacts_in_place;
}

}  // namespace touchstone::fast::simulation
