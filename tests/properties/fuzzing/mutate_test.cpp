// Whatever is drawn, a mutation makes a valid scene, and most of them make another one.
#include "properties/fuzzing/mutate.h"

#include <fmt/ranges.h>

#include <map>
#include <set>
#include <string>

#include "oracle/truth/truth.h"
#include "properties/property.h"
#include "properties/scenes/domain.h"
#include "tests/catch.h"

namespace touchstone::properties::fuzzing {
namespace {

bool has_parts(const Scene& scene, const oracle::Query& query) {
  const std::map<oracle::ScenePart, bool> has = {{oracle::ScenePart::none, true},
                                                 {oracle::ScenePart::contact, scene.contact.has_value()},
                                                 {oracle::ScenePart::raster, scene.raster.has_value()},
                                                 {oracle::ScenePart::motion, scene.motion.has_value()}};
  return has.at(query.needs) && (!query.about_two_bodies || scene.bodies.size() >= 2);
}

TEST_CASE("Every mutated scene of every query is valid, complete, and has the parts that the query needs") {
  for (const std::string& name : tested_queries()) {
    const oracle::Query& query = *oracle::find_query(name);
    const std::vector<const Family*> all = for_query(families(), name);
    int changed = 0;
    constexpr int rounds = 8;
    for (std::size_t f = 0; f < all.size(); ++f) {
      INFO(name << ' ' << all[f]->id);
      Scene scene = draw(*all[f], 1, 0);
      const Scene other = draw(*all[(f + 1) % all.size()], 1, 1);
      Random random(1, name, f);
      for (int round = 0; round < rounds; ++round) {
        const Scene before = scene;
        scene = mutated(scene, other, query, random);
        CHECK(oracle::truth::completed(scene) == scene);
        CHECK(has_parts(scene, query));
        changed += !(scene == before);
      }
    }
    INFO(name);
    CHECK(changed > 9 * rounds * static_cast<int>(all.size()) / 10);
  }
}

TEST_CASE("The same draws make the same scene") {
  const oracle::Query& query = *oracle::find_query("distance");
  const Scene scene = draw(find_family("boxes.dyadic_gap"), 1, 0);
  const Scene other = draw(find_family("touching.exact"), 1, 0);
  Random one(5), two(5);
  for (int round = 0; round < 50; ++round) {
    CHECK(mutated(scene, other, query, one) == mutated(scene, other, query, two));
  }
}

TEST_CASE("Mutations make bodies touch exactly that were apart") {
  const oracle::Query& query = *oracle::find_query("distance");
  Scene scene;
  for (const double x : {0.0, 5.0}) {
    Body body;
    body.shape = Box{Vec3(1, 1, 1)};
    body.X_WB.p_WB.x() = x;
    scene.bodies.push_back(body);
  }
  int touching = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    Random random(seed);
    touching += oracle::truth::distance(mutated(scene, scene, query, random)).verdict == Verdict::touching;
  }
  CHECK(touching >= 5);  // expected: 1000 × 1/18 of the mutations × 1/2 of two bodies × 1/2 without a further step = 14
}

TEST_CASE("A scene without bodies only gets one") {
  const oracle::Query& query = *oracle::find_query("broad_phase");
  const Scene other = draw(find_family("boxes.dyadic_gap"), 1, 0);
  int grown = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Random random(seed);
    const std::size_t bodies = mutated({}, other, query, random).bodies.size();
    CHECK(bodies <= 1);
    grown += bodies == 1;
  }
  CHECK(grown > 0);
}

/// What a scene has that one box, or two at rest, have not.
std::set<std::string> things_in(const Scene& scene) {
  std::set<std::string> things;
  for (const Body& body : scene.bodies) {
    if (std::holds_alternative<Compound>(body.shape)) things.insert("compound");
    if (std::holds_alternative<Sphere>(body.shape)) things.insert("sphere");
    if (std::holds_alternative<Box>(body.shape)) things.insert("box");
    if (const auto* polytope = std::get_if<Polytope>(&body.shape)) {
      things.insert(polytope->vertices.size() < 24 ? "polytope" : "large polytope");
    }
    if (std::holds_alternative<Density>(body.mass)) things.insert("density");
    if (std::holds_alternative<MassProperties>(body.mass)) things.insert("given mass");
    if (is_fixed(body)) things.insert("fixed");
    if (!body.velocity.v_WBcm.isZero(0)) things.insert("moves");
    if (!body.velocity.w_WB.isZero(0)) things.insert("turns");
  }
  if (scene.bodies.size() > 2) things.insert("three bodies");
  for (const SequenceFrame& frame : scene.frames) {
    for (const Placement& placement : frame) things.insert(placement.X_WB ? "placed" : "removed");
  }
  if (scene.motion) {
    if (!scene.motion->forces.empty()) things.insert("force");
    if (!scene.motion->start_times.empty()) things.insert("start times");
    if (scene.motion->envelope) things.insert("envelope");
    if (scene.motion->sample_times.size() > 1) things.insert("samples");
  }
  return things;
}

TEST_CASE("From the first scene of its first family alone, mutations of a query come to all that its scenes may have") {
  const std::set<std::string> solids{"sphere", "box", "polytope", "large polytope"};
  const std::set<std::string> masses{"density", "given mass", "fixed"};
  const auto all_of = [](std::initializer_list<std::set<std::string>> sets) {
    std::set<std::string> all;
    for (const auto& set : sets) all.insert(set.begin(), set.end());
    return all;
  };
  const std::set<std::string> compound{"compound"}, motion{"moves", "turns", "start times", "envelope", "samples"};
  const std::map<std::string, std::set<std::string>> expected{
      {"mass", all_of({solids, compound, masses})},
      {"bounds", all_of({solids, compound})},
      {"broad_phase", all_of({solids, compound, {"three bodies", "placed", "removed"}})},
      {"distance", all_of({solids, compound})},
      {"penetration", solids},
      {"pixel", all_of({solids, compound})},
      {"impulse", all_of({solids, compound, masses, {"moves", "turns"}})},
      {"time_of_impact", all_of({solids, compound, masses, motion, {"force"}})},
      {"simulation", all_of({solids, compound, masses, motion, {"force", "three bodies"}})},
      {"constraint", all_of({solids, masses, motion, {"force", "three bodies"}})}};
  for (const std::string& name : tested_queries()) {
    const Scene first = draw(*for_query(families(), name).front(), 1, 0);
    std::set<std::string> missing = expected.at(name);
    for (std::uint64_t seed = 0; seed < 500 && !missing.empty(); ++seed) {
      Random random(seed, name, 0);
      Scene scene = first;
      for (int step = 0; step < 12; ++step) {
        scene = mutated(scene, first, *oracle::find_query(name), random);
        for (const std::string& thing : things_in(scene)) missing.erase(thing);
      }
    }
    INFO(name << " lacks " << fmt::format("{}", fmt::join(missing, ", ")));
    CHECK(missing.empty());
  }
}

}  // namespace
}  // namespace touchstone::properties::fuzzing
