// The scenes that are drawn reach the code that they are for, on generic scenes what is slow runs seldom, and nothing
// runs more or less often than it did.
#include <algorithm>
#include <string>

#include "fast/mark.h"
#include "oracle/subject.h"
#include "oracle/subjects/touchstone/fast.h"
#include "properties/scenes/domain.h"
#include "tests/catch.h"
#include "tests/properties/generated_page.h"

using namespace touchstone;
using fast::Mark;
using fast::MarkCounts;

namespace {

void ask(oracle::Subject& subject, const std::string& query, const Scene& scene) {
  if (query == "broad_phase") subject.pair_history(scene);
  if (query == "distance") subject.distance(scene);
  if (query == "penetration") subject.penetration(scene);
  if (query == "impulse") subject.impulse(scene);
  if (query == "pixel") subject.pixel(scene);
  if (query == "time_of_impact") subject.time_of_impact(scene);
  if (query == "constraint") subject.constraint(scene);
  if (query == "simulation") subject.simulation(scene);
}

/// How often each mark was reached while fast answered about the first scenes of a family.
MarkCounts counts(const std::string& query, const std::string& family, std::uint64_t scenes) {
  const auto subject = oracle::subjects::make_fast();
  const MarkCounts before = fast::mark_counts;
  for (std::uint64_t i = 0; i < scenes; ++i) {
    ask(*subject, query, properties::draw(properties::find_family(family), 1, i));
  }
  return fast::marks_since(before);
}

std::uint64_t of(const MarkCounts& reached, Mark mark) { return reached[static_cast<std::size_t>(mark)]; }

struct Reach {
  Mark mark;
  const char* query;
  const char* family;
};

const std::vector<Reach> reaches = {
    {Mark::balance_step, "simulation", "tables.stack"},
    {Mark::centre_step, "simulation", "runs.on_a_table"},
    {Mark::climb, "broad_phase", "films.round_solids"},
    {Mark::climb_exact, "broad_phase", "films.round_solids"},
    {Mark::climb_step, "broad_phase", "films.round_solids"},
    {Mark::contact_newton, "simulation", "runs.on_ice"},
    {Mark::contact_round, "simulation", "runs.carried"},
    {Mark::contact_row, "simulation", "runs.carried"},
    {Mark::contact_sweep, "simulation", "runs.carried"},
    {Mark::depth, "penetration", "hulls.generic"},
    {Mark::depth_exact, "penetration", "touching.ulps"},
    {Mark::depth_step, "penetration", "hulls.generic"},
    {Mark::descent, "distance", "hulls.generic"},
    {Mark::descent_step, "distance", "hulls.generic"},
    {Mark::exact_proximity, "distance", "touching.exact"},
    {Mark::exact_step, "constraint", "tables.stack"},
    {Mark::face_scan, "time_of_impact", "flights.generic"},
    {Mark::friction_step, "simulation", "runs.parts_land"},
    {Mark::friction_turn, "simulation", "runs.parts_land"},
    {Mark::grid_chain, "broad_phase", "films.many"},
    {Mark::grid_layout, "broad_phase", "films.growing"},
    {Mark::grid_long_body, "broad_phase", "films.many_sizes"},
    {Mark::grid_rebuild, "broad_phase", "films.growing"},
    {Mark::grid_unchain, "broad_phase", "films.back_and_forth"},
    {Mark::grid_update, "broad_phase", "films.back_and_forth"},
    {Mark::impact_tied, "simulation", "runs.edge_on_edge"},
    {Mark::impact_together, "simulation", "runs.together"},
    {Mark::impulse_again, "impulse", "contact.jamming"},
    {Mark::impulse_curve, "impulse", "contact.boxes"},
    {Mark::impulse_phase, "impulse", "contact.boxes"},
    {Mark::impulse_scaled, "impulse", "contact.times_powers"},
    {Mark::impulse_series, "impulse", "contact.boxes"},
    {Mark::impulse_slide_off, "impulse", "contact.zero_slip"},
    {Mark::island_merge, "simulation", "tables.stack"},
    {Mark::micro_bounces, "simulation", "runs.bouncing"},
    {Mark::pixel_exact, "pixel", "pixels.lattice_boxes"},
    {Mark::pixel_seen, "pixel", "pixels.lattice_boxes"},
    {Mark::plane_step, "simulation", "runs.bouncing"},
    {Mark::proxy_candidate, "simulation", "runs.balls"},
    {Mark::proxy_query, "simulation", "runs.balls"},
    {Mark::rest_phase, "simulation", "tables.slides"},
    {Mark::shared_normal, "simulation", "tables.tiles"},
    {Mark::step_bounce, "constraint", "tables.drops"},
    {Mark::step_force, "constraint", "tables.pushed"},
    {Mark::step_long, "constraint", "tables.slides"},
    {Mark::step_shift, "constraint", "tables.falls"},
    {Mark::toi_all_normals, "time_of_impact", "flights.touching"},
    {Mark::toi_balls, "time_of_impact", "flights.from_afar"},
    {Mark::toi_doubt, "time_of_impact", "flights.tangent"},
    {Mark::toi_parting, "time_of_impact", "flights.touching"},
    {Mark::toi_query, "time_of_impact", "flights.generic"},
    {Mark::toi_search, "time_of_impact", "flights.generic"},
    {Mark::toi_wait, "time_of_impact", "flights.tangent"},
    {Mark::tumble_step, "simulation", "runs.tops"},
    {Mark::vertex_scan, "simulation", "runs.carried"},
    {Mark::walk, "time_of_impact", "flights.generic"},
    {Mark::walk_in_doubles, "time_of_impact", "flights.touching"},
    {Mark::walk_inside, "time_of_impact", "flights.generic"},
    {Mark::walk_restart, "time_of_impact", "flights.generic"},
    {Mark::walk_step, "time_of_impact", "flights.generic"},
};

/// A quick run draws so many scenes of each family of a query, or one more (app/trial/effort.h).
std::uint64_t quick_scenes(const std::string& query) {
  const std::int64_t cases = query == "simulation" || query == "constraint" ? 68 : 300;
  const std::int64_t families = std::ranges::count_if(properties::families(), [&](const properties::Family& family) {
    return std::ranges::count(family.queries, query) > 0;
  });
  return static_cast<std::uint64_t>(cases / families);
}

}  // namespace

TEST_CASE("marks: each is reached by the scenes of a family in a quick run") {
  for (const Reach& row : reaches) {
    INFO("mark " << static_cast<int>(row.mark) << " by " << row.query << " of " << row.family);
    CHECK(of(counts(row.query, row.family, quick_scenes(row.query)), row.mark) > 0);
  }
  for (std::size_t i = 0; i < fast::mark_counts.size(); ++i) {
    INFO("mark " << i);
    CHECK(std::ranges::count(reaches, static_cast<Mark>(i), &Reach::mark) == 1);
  }
}

// Exact arithmetic repairs what a fault did to a walk or a descent, and a grid that is built anew in every frame finds
// the same pairs: such faults change no answer. The limits are regression pins, a quarter to a half above what was
// counted.
TEST_CASE("marks: on generic scenes what is slow runs seldom") {
  const MarkCounts distance = counts("distance", "hulls.generic", 200);
  CHECK(100 * of(distance, Mark::exact_proximity) <= of(distance, Mark::descent));
  CHECK(of(distance, Mark::descent_step) <= 4 * of(distance, Mark::descent));

  const MarkCounts depth = counts("penetration", "hulls.generic", 200);
  CHECK(of(depth, Mark::depth_exact) == 0);
  CHECK(of(depth, Mark::depth_step) <= 24 * of(depth, Mark::depth));

  const MarkCounts motion = counts("time_of_impact", "flights.generic", 100);
  CHECK(100 * of(motion, Mark::exact_proximity) <= of(motion, Mark::toi_search));
  CHECK(of(motion, Mark::toi_query) <= 8 * of(motion, Mark::toi_search));
  CHECK(of(motion, Mark::walk_step) <= of(motion, Mark::walk));
  CHECK(of(motion, Mark::toi_doubt) == 0);

  const MarkCounts lattice = counts("broad_phase", "films.many", 50);
  CHECK(of(lattice, Mark::grid_update) >= 2 * of(lattice, Mark::grid_rebuild));
  CHECK(of(lattice, Mark::grid_long_body) == 0);
  const MarkCounts swings = counts("broad_phase", "films.back_and_forth", 50);
  CHECK(of(swings, Mark::grid_update) >= 4 * of(swings, Mark::grid_rebuild));
  CHECK(of(swings, Mark::grid_layout) <= 75);

  const MarkCounts turning = counts("broad_phase", "films.round_solids", 50);
  CHECK(of(turning, Mark::climb_step) <= 24 * of(turning, Mark::climb));
  CHECK(of(turning, Mark::climb_exact) <= 2 * of(turning, Mark::climb));

  const MarkCounts turned = counts("pixel", "pixels.turned", 20);
  CHECK(of(turned, Mark::pixel_exact) <= 2 * of(turned, Mark::pixel_seen));

  const MarkCounts impulse = counts("impulse", "contact.boxes", 200);
  CHECK(of(impulse, Mark::impulse_phase) <= 8 * of(impulse, Mark::impulse_curve));
  CHECK(of(impulse, Mark::impulse_scaled) == 0);
}

namespace {

/// What fast took to solve contacts in steps, over the first scenes of a family.
struct Solved {
  std::int64_t steps = 0, unconverged = 0;
};

Solved contact_steps(const std::string& family, std::uint64_t scenes) {
  const auto subject = oracle::subjects::make_fast();
  Solved sum;
  for (std::uint64_t i = 0; i < scenes; ++i) {
    const Scene scene = properties::draw(properties::find_family(family), 1, i);
    const auto answer = subject->simulation(scene);
    const auto* said = std::get_if<Trajectory>(&answer);
    REQUIRE(said != nullptr);
    if (!said->contact_solver) continue;
    sum.steps += said->contact_solver->steps;
    sum.unconverged += said->contact_solver->unconverged;
  }
  return sum;
}

}  // namespace

// A step that is shorter than it could be, or that is solved again and again, changes no answer either. The limits are
// regression pins, a quarter to a half above what was counted.
TEST_CASE("marks: contacts are solved in no more steps than the motion needs, and what rests takes none") {
  const Solved carried = contact_steps("runs.carried", 12), on_ice = contact_steps("runs.on_ice", 12);
  CHECK(carried.steps <= 3400);
  CHECK(carried.unconverged <= 4);
  CHECK(on_ice.steps <= 3900);
  CHECK(on_ice.unconverged <= 18);
  const Solved over_edges = contact_steps("tables.overhangs", 12);
  CHECK(over_edges.steps <= 2700);
  CHECK(over_edges.unconverged == 0);
  CHECK(contact_steps("tables.stack", 12).steps == 0);
  CHECK(contact_steps("runs.at_rest", 12).steps == 0);
}

namespace {

/// Scenes on which the counts are pinned: between them they reach each mark.
struct Pinned {
  const char* query;
  const char* family;
  std::uint64_t scenes;
};

const std::vector<Pinned> pinned = {
    {"broad_phase", "films.back_and_forth", 2},
    {"broad_phase", "films.growing", 2},
    {"broad_phase", "films.many", 2},
    {"broad_phase", "films.many_sizes", 2},
    {"broad_phase", "films.round_solids", 2},
    {"constraint", "tables.drops", 2},
    {"constraint", "tables.falls", 2},
    {"constraint", "tables.pushed", 2},
    {"distance", "hulls.generic", 20},
    {"distance", "mixed.compounds", 10},
    {"distance", "parallel.nearly_faces", 10},
    {"distance", "touching.exact", 5},
    {"impulse", "contact.boxes", 40},
    {"impulse", "contact.jamming", 20},
    {"impulse", "contact.times_powers", 10},
    {"impulse", "contact.zero_slip", 20},
    {"penetration", "contained.pushed_in", 10},
    {"penetration", "hulls.generic", 20},
    {"penetration", "round.lattice_spheres", 5},
    {"penetration", "touching.ulps", 5},
    {"pixel", "pixels.lattice_boxes", 2},
    {"pixel", "pixels.turned", 2},
    {"simulation", "runs.balls", 4},
    {"simulation", "runs.bouncing", 4},
    {"simulation", "runs.carried", 2},
    {"simulation", "runs.edge_on_edge", 4},
    {"simulation", "runs.on_a_table", 4},
    {"simulation", "runs.on_ice", 2},
    {"simulation", "runs.piles", 2},
    {"simulation", "runs.solids", 4},
    {"simulation", "runs.together", 4},
    {"simulation", "runs.tops", 4},
    {"simulation", "tables.overhangs", 2},
    {"simulation", "tables.slides", 4},
    {"simulation", "tables.stack", 2},
    {"time_of_impact", "flights.from_afar", 10},
    {"time_of_impact", "flights.generic", 20},
    {"time_of_impact", "flights.tangent", 5},
    {"time_of_impact", "flights.touching", 10},
};

/// One line a row of `pinned`, with the marks that its scenes reach.
std::string all_counts() {
  std::string page;
  for (const Pinned& row : pinned) {
    const MarkCounts reached = counts(row.query, row.family, row.scenes);
    page += std::string(row.query) + ' ' + row.family + ", " + std::to_string(row.scenes) + " scenes:";
    for (const Reach& mark : reaches) {
      if (of(reached, mark.mark) > 0)
        page += ' ' + std::string(fast::mark_names[static_cast<std::size_t>(mark.mark)]) + ' ' +
                std::to_string(of(reached, mark.mark));
    }
    page += '\n';
  }
  return page;
}

}  // namespace

// A fault that another part repairs, or that makes a margin wider than it need be, changes how often some code runs and
// no answer. The counts are a regression pin, and the same from every build, as all of fast's bits are. A change of
// fast that changes them needs a reason. To make them anew: TOUCHSTONE_UPDATE=1 ./touchstone test -R "counts are
// pinned".
TEST_CASE("marks: the counts are pinned") {
  const std::string path = TOUCHSTONE_SOURCE_DIR "/tests/properties/scenes/mark_counts.txt", now = all_counts();
  CHECK(tests::committed_text(path, now) == now);
}
