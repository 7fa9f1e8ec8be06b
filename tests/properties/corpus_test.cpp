// The corpus can be read and names existing properties, and its truths are those found by hand.
#include <algorithm>
#include <filesystem>
#include <map>

#include "oracle/case.h"
#include "oracle/subject.h"
#include "oracle/subjects/touchstone/fast.h"
#include "oracle/subjects/touchstone/reference.h"
#include "oracle/truth/truth.h"
#include "properties/property.h"
#include "tests/catch.h"

namespace touchstone::properties {
namespace {

namespace fs = std::filesystem;
using oracle::Case;
using reference::Rational;

const fs::path corpus = fs::path(TOUCHSTONE_SOURCE_DIR) / "properties" / "corpus";

Scene scene_of(const std::string& name) { return oracle::read_case((corpus / (name + ".json")).string()).scene; }

TEST_CASE("Every case of the corpus is whole: read, complete, under a property of its folder's query") {
  std::map<std::string, int> count;
  for (const auto& entry : fs::recursive_directory_iterator(corpus)) {
    if (entry.path().extension() != ".json") continue;
    INFO(entry.path().string());
    const Case a_case = oracle::read_case(entry.path().string());
    CHECK(oracle::truth::completed(a_case.scene) == a_case.scene);
    CHECK(find(a_case.property).query == fs::relative(entry.path(), corpus).begin()->string());
    CHECK(a_case.subject.empty());
    CHECK(!a_case.note.empty());
    ++count[find(a_case.property).query];
  }
  for (const char* query : {"mass", "bounds", "broad_phase", "distance", "penetration", "time_of_impact", "simulation"})
    CHECK(count[query] >= 3);
}

// The slope by a Runge-Kutta method of fourth order with steps of 10⁻³ and 5·10⁻⁴ N s, which agree to 2·10⁻¹⁰ of it.
TEST_CASE("corpus: a compression ends where the normal velocity is nearly flat") {
  const Scene scene = scene_of("impulse/nearly_flat_at_the_end_of_compression");
  CHECK(oracle::truth::impulse(scene).flattest == Approx(0.001984547865).epsilon(1e-9));
  const auto subject = oracle::subjects::make_fast();
  for (const char* property : {"impulse.agrees", "impulse.error_bound"})
    CHECK(properties::find(property).check(scene, *subject).outcome == oracle::Outcome::holds);
}

TEST_CASE("An impact of the corpus goes on through restitution, though slip jams in it") {
  const reference::ImpulseTruth& truth = oracle::truth::impulse(scene_of("impulse/stronge_jams_in_restitution"));
  CHECK(truth.p_f > truth.p_c);
  CHECK(truth.modes.slip_stops_in_restitution);
}

TEST_CASE("Distances of the corpus by hand") {
  const auto verdict = [](const std::string& name) {
    return oracle::truth::distance(scene_of("distance/" + name)).verdict;
  };
  CHECK(oracle::truth::distance(scene_of("distance/equal_cubes_apart_in_y")).core_squared == Rational(1));
  CHECK(oracle::truth::distance(scene_of("distance/crossed_edges_2_40_apart")).core_squared == Rational(0x1p-80));
  CHECK(verdict("vertex_on_face_turned") == Verdict::touching);
  CHECK(verdict("parallel_edges_share_a_point") == Verdict::touching);
  CHECK(verdict("coplanar_faces_meet_in_a_corner") == Verdict::touching);
}

TEST_CASE("Depths of the corpus by hand") {
  const auto depth = [](const std::string& name) {
    return oracle::truth::penetration(scene_of("penetration/" + name)).depth;
  };
  CHECK(depth("concentric_cubes") == Interval{2, 2});
  CHECK(depth("sliver_2_30") == Interval{0x1p-30, 0x1p-30});
  CHECK(depth("sphere_about_cube") == Interval{4, 4});
  CHECK(depth("faces_touch") == Interval{0, 0});
}

TEST_CASE("Meetings of the corpus by hand") {
  const auto met = [](const std::string& name) {
    return oracle::truth::time_of_impact(scene_of("time_of_impact/" + name));
  };
  for (const char* name : {"corner_into_an_edge", "corner_slides_along_a_face_inwards", "hinged_faces_fold"}) {
    CHECK(met(name).status == TimeOfImpact::Status::hit);
    CHECK(met(name).at_start);
  }
  const Interval back = met("crossed_edges_part_and_come_back").time;
  CHECK(back.lo <= 0.5);
  CHECK(back.hi >= 0.5);
  CHECK(back.hi - back.lo < 1e-14);
  // The edge from (1, 0, 0) to (2, 1, 1) meets the one of x/2 + y/8 = 1 at (1.8, 0.8, 1), at 8 m/s after 0.2 m.
  CHECK(met("compound_that_hardly_turns").time.lo == Approx(0.025).epsilon(1e-11));
  // By Runge-Kutta steps of Euler's equations, and the separating axes of the two boxes.
  CHECK(met("flat_body_tumbles_for_many_periods").time.lo == Approx(8.65629195124).epsilon(1e-11));
}

// Each bar has m = 4 and I_x = 4 (2 + 4)/12 = 2. By symmetry the impulse is along z, at y = 1/2, half a metre from both
// centres: K = 2/4 + 2 (1/2)²/2 = 3/4, P = 2 · 4/K = 32/3.
TEST_CASE("Impacts of the corpus by hand") {
  const auto fast = oracle::subjects::make_fast(), exact = oracle::subjects::make_reference();
  for (const char* name : {"edge_on_edge", "edge_on_edge_at_the_start"}) {
    for (oracle::Subject* subject : {fast.get(), exact.get()}) {
      INFO(name << " of " << subject->card().name);
      const auto answer = subject->simulation(scene_of(std::string("simulation/") + name));
      const auto* said = std::get_if<Trajectory>(&answer);
      REQUIRE(said != nullptr);
      const std::vector<State>& after = said->states.back();
      CHECK((after[0].velocity.v_WBcm - Vec3(0, 0, -8.0 / 3)).norm() < 1e-12);
      CHECK((after[1].velocity.v_WBcm - Vec3(0, 0, -4.0 / 3)).norm() < 1e-12);
      for (const State& state : after) CHECK((state.velocity.w_WB - Vec3(-8.0 / 3, 0, 0)).norm() < 1e-12);
    }
  }
}

// cond(K) is 2e7 and more, and the law is computed in long double.
TEST_CASE("The judge does not blame its own rounding on an exact answer") {
  const auto exact = oracle::subjects::make_reference();
  for (const char* name : {"rod_without_friction", "rod_loses_all_it_can", "struck_at_the_centre_of_mass"}) {
    const Case a_case = oracle::read_case((corpus / "impulse" / (std::string(name) + ".json")).string());
    INFO(name);
    CHECK(find(a_case.property).check(a_case.scene, *exact).outcome == oracle::Outcome::holds);
  }
}

TEST_CASE("Pairs, boxes and masses of the corpus by hand") {
  CHECK(oracle::truth::broad_phase(scene_of("broad_phase/corner_neighbours")) == PairSet{{0, 1}, {1, 2}});
  CHECK(oracle::truth::broad_phase(scene_of("broad_phase/equal_end_points")) == PairSet{{0, 1}, {0, 2}, {1, 2}});
  CHECK(oracle::truth::broad_phase(scene_of("broad_phase/speck_in_giant")) == PairSet{{0, 1}});
  CHECK(oracle::truth::broad_phase(scene_of("broad_phase/balls_in_one_cell")) == PairSet{{0, 1}});
  const auto box = oracle::truth::bounds(scene_of("bounds/three_four_five"))[0];
  CHECK(box.hi[0] == Rational("7/5"));
  CHECK(box.lo[1] == Rational("-7/5"));
  CHECK(box.hi[2] == Rational(1));
  CHECK(oracle::truth::mass(scene_of("mass/two_cubes"))[0]->mass == Interval{16, 16});
  const Interval sixth = oracle::truth::mass(scene_of("mass/far_tetrahedron"))[0]->mass;
  CHECK(Rational(sixth.lo) <= Rational("1/6"));
  CHECK(Rational(sixth.hi) >= Rational("1/6"));
  CHECK(sixth.hi - sixth.lo < 1e-15);
}

}  // namespace
}  // namespace touchstone::properties
