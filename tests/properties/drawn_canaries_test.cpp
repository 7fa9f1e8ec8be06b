// Canaries about simulations and constraints are detected on scenes that a quick trial draws, not only on scenes made
// by hand.
#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "oracle/judge/grade.h"
#include "oracle/subjects/canaries/canaries.h"
#include "oracle/subjects/touchstone/fast.h"
#include "properties/property.h"
#include "properties/scenes/domain.h"
#include "tests/catch.h"
#include "tests/properties/kills.h"

using namespace touchstone;

namespace {

/// A canary, a property that detects it, and a scene drawn with seed 1 on which it does. Of the many such scenes this
/// is a cheap one.
struct Caught {
  const char* canary;
  const char* property;
  const char* family;
  std::uint64_t index;
};

/// The scenes of a query that a quick trial of one subject draws, from its families in turn.
std::uint64_t quick_runs(const std::string& query) { return query == "simulation" ? 320 : 68; }

const std::vector<Caught> caught = {
    {"canary.not_keyed_again", "simulation.flights", "runs.cradle", 0},
    {"canary.ghosts", "simulation.bounces", "runs.bouncing", 0},
    {"canary.far_ones_pass", "simulation.one_meeting", "runs.far_apart", 1},
    {"canary.stale_event", "simulation.event_states", "runs.on_a_table", 0},
    {"canary.unstable_tie", "simulation.survives", "runs.ties", 0},
    {"canary.gyroscopic_term_dropped", "simulation.impulses", "runs.solids", 0},
    {"canary.apex_ignored", "simulation.bounces", "runs.bouncing", 0},
    {"canary.greater_coefficients", "simulation.bounces", "runs.bouncing", 0},
    {"canary.pushes_ignored", "simulation.survives", "runs.pushed", 0},
    {"canary.impulse_at_two_points", "simulation.impulses", "runs.solids", 0},
    {"canary.impact_gains", "simulation.elastic_energy", "runs.cradle", 0},
    {"canary.impact_moves", "simulation.angular_momentum", "runs.balls", 0},
    {"canary.overdue", "simulation.lockstep", "runs.one_impact", 0},
    {"canary.lower_end", "simulation.lockstep", "runs.one_impact", 0},
    {"canary.contact_elsewhere", "simulation.contacts", "runs.cradle", 0},
    {"canary.crowded", "simulation.bystanders", "runs.on_a_table", 0},
    {"canary.explicit_steps", "simulation.bounces", "runs.bouncing", 0},
    {"canary.coarse_steps", "simulation.alone", "runs.on_a_table", 4},
    {"canary.sinks_slowly", "simulation.bounces", "runs.bouncing", 0},
    {"canary.creeps", "simulation.angular_momentum", "runs.one_impact", 0},
    {"canary.warms", "simulation.elastic_energy", "runs.one_impact", 0},
    {"canary.cools", "simulation.elastic_energy", "runs.one_impact", 0},
    {"canary.first_body_drags", "simulation.elastic_energy", "runs.one_impact", 0},
    {"canary.winds_down", "simulation.elastic_energy", "runs.elastic_balls", 0},
    {"canary.stops_early", "simulation.whole", "runs.solids", 0},
    {"canary.look_missing", "simulation.ordered", "runs.on_a_table", 0},
    {"canary.world_grid", "simulation.bystanders", "runs.one_impact", 0},
    {"canary.left_before_right", "simulation.mirrored", "runs.cradle", 0},
    {"canary.foresees", "simulation.no_foresight", "runs.pushed", 0},
    {"canary.half_a_twist", "simulation.impulses_apply", "runs.solids", 0},
    {"canary.top_leads", "simulation.flights", "runs.tops", 0},
    {"canary.adds_angles", "simulation.turns", "runs.spins", 0},
    {"canary.starts_anew", "simulation.resumed", "runs.apart", 0},
    {"canary.slippery", "simulation.slides", "runs.skims", 0},
    {"canary.grips", "simulation.face_impulse", "runs.on_a_table", 1},
    {"canary.trips", "simulation.slides", "tables.tiles", 0},
    {"canary.clings", "simulation.supported", "tables.overhangs", 0},
    {"canary.last_sample", "simulation.flights", "runs.ties", 0},
    {"canary.one_corner", "simulation.bounces", "runs.falls_flat", 0},
    {"canary.one_pair_first", "simulation.together_renumbered", "runs.together", 1},
    {"canary.leans", "simulation.together_mirrored", "runs.together", 1},
    {"canary.sticky_together", "simulation.together_pushes", "runs.together", 0},
    {"canary.damped_together", "simulation.together_energy", "runs.cradle", 0},
    {"canary.kicks_together", "simulation.together_energy", "runs.together", 0},
    {"canary.sums_up_the_last", "simulation.impulses_add_up", "runs.bouncing", 0},
    {"canary.ends_bounces_early", "simulation.bounces_end", "runs.bouncing", 0},
    {"canary.nanometre", "simulation.scaled", "runs.ties", 0},
    {"canary.carries_air", "simulation.heavier", "runs.solids", 0},
    {"canary.rounded_by_samples", "simulation.sampled", "runs.ties", 0},
    {"canary.endless_table", "constraint.contacts", "tables.falls", 0},
    {"canary.hollow_ball", "constraint.velocity", "tables.slope", 0},
    {"canary.frictionless_table", "constraint.velocity", "tables.slides", 0},
    {"canary.rubber", "constraint.face_impulse", "tables.slides", 0},
    {"canary.no_bounce", "constraint.contacts", "tables.drops", 1},
    {"canary.obstacle_forgotten", "constraint.fixed", "tables.obstacle", 0},
    {"canary.gravity_along_z", "constraint.turned", "tables.drops", 0},
    {"canary.half_gravity", "constraint.velocity", "tables.falls", 0},
    {"canary.releases_forgotten", "constraint.contacts", "tables.obstacle", 0},
    {"canary.last_look_missing", "constraint.survives", "tables.drops", 0},
    {"canary.sinks", "constraint.turned", "tables.barely_flies", 0},
    {"canary.far_is_elsewhere", "constraint.fixed", "tables.slope", 0},
    {"canary.speeds_up", "constraint.velocity", "tables.falls", 0},
    {"canary.veers", "constraint.mirrored", "tables.slides", 0},
    {"canary.last_ball_lags", "constraint.renumbered", "tables.slides", 0},
    {"canary.spin_forgotten", "constraint.velocity", "tables.barely_flies", 0},
    {"canary.fixed_body_creeps", "constraint.fixed", "tables.falls", 0},
    {"canary.second_wind", "constraint.energy", "tables.obstacle", 0},
    {"canary.early_events", "constraint.event_states", "tables.drops", 0},
    {"canary.point_at_centre", "constraint.event_points", "tables.obstacle", 0},
    {"canary.contacts_pull", "constraint.cone", "tables.drops", 0},
    {"canary.triple_friction", "constraint.cone", "tables.drops", 0},
};

const properties::Family& family(const std::string& id) {
  return *std::ranges::find(properties::families(), id, &properties::Family::id);
}

std::uint64_t families_of(const std::string& query) {
  return static_cast<std::uint64_t>(std::ranges::count_if(properties::families(), [&](const properties::Family& f) {
    return std::ranges::find(f.queries, query) != f.queries.end();
  }));
}

bool is_about_runs(const oracle::subjects::Canary& canary) {
  const auto lies_about = [&](const char* query) {
    return std::ranges::find(canary.lies_about, query) != canary.lies_about.end();
  };
  return canary.lies_about.size() == 1 && (lies_about("simulation") || lies_about("constraint"));
}

}  // namespace

TEST_CASE("each canary about simulations and constraints is caught on a drawn scene of a quick trial") {
  std::set<std::string> names;
  for (const Caught& row : caught) {
    INFO(row.canary << " by " << row.property << " on " << row.family << ' ' << row.index);
    const properties::Property& property = properties::find(row.property);
    CHECK(row.index < quick_runs(property.query) / families_of(property.query));
    const auto subject = oracle::subjects::canary(row.canary).make(tests::truthful());
    const oracle::Outcome outcome = property.check(draw(family(row.family), 1, row.index), *subject).outcome;
    CHECK(outcome == oracle::Outcome::fails);
    names.insert(row.canary);
  }
  for (const oracle::subjects::Canary& canary : oracle::subjects::canaries()) {
    INFO(canary.id);
    CHECK((!is_about_runs(canary) || names.contains(canary.id)));
  }
}

TEST_CASE("simulation.bounces_end: fast keeps it on a drawn scene whose bounces it completes") {
  const auto fast = oracle::subjects::make_fast();
  const properties::Property& property = properties::find("simulation.bounces_end");
  CHECK(property.check(draw(family("runs.bouncing"), 1, 3), *fast).outcome == oracle::Outcome::holds);
}

// The canary moves a body by 10⁻¹² m: a difference of rounding is not graded as one of a metre.
TEST_CASE("simulation.bystanders: the error is how far a body is moved") {
  const auto subject = oracle::subjects::canary("canary.crowded").make(tests::truthful());
  const Scene scene = draw(family("runs.on_a_table"), 1, 0);
  const oracle::Finding finding = properties::find("simulation.bystanders").check(scene, *subject);
  CHECK(finding.error > 0);
  CHECK(oracle::grade(finding) < oracle::Grade::D);
}
