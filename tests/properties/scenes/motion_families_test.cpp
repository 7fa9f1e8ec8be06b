// The families of motions reach what they are for: counted from the reference's answers and from the drawn numbers.
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "model/limits.h"
#include "oracle/subject.h"
#include "oracle/subjects/touchstone/fast.h"
#include "oracle/truth/truth.h"
#include "properties/property.h"
#include "tests/catch.h"
#include "tests/properties/scenes/drawn.h"

using namespace touchstone;
using tests::count;
using tests::drawn;

namespace {

using Status = TimeOfImpact::Status;

constexpr int draws = 60;

const reference::TimeOfImpactTruth& truth(const Scene& scene) { return oracle::truth::time_of_impact(scene); }

bool comes_within(const Scene& scene, double apart) {
  return oracle::truth::time_of_distance(scene, apart).status != Status::miss;
}

/// Motions of these families end at twice the time at which they are tangent to a contact.
double tangent_at(const Scene& scene) { return scene.motion->sample_times.back() / 2; }

/// Of a torque-free ω with three different moments (s): 4 K(k)/p, with K by the arithmetic-geometric mean.
double period(const Body& body) {
  const Vec3& w = body.velocity.w_WB;
  const auto& given = std::get<MassProperties>(body.mass);
  const Eigen::Quaterniond q(body.X_WB.q_WB.w, body.X_WB.q_WB.x, body.X_WB.q_WB.y, body.X_WB.q_WB.z);
  const Vec3 w_B = q.normalized().conjugate() * w, I = given.I_BBcm_B.diagonal();
  const double twice_T = w_B.dot(I.cwiseProduct(w_B)), L2 = I.cwiseProduct(w_B).squaredNorm();
  std::array<double, 3> m = {I.x(), I.y(), I.z()};
  std::ranges::sort(m);
  const double about_3 = (m[2] - m[1]) * (L2 - twice_T * m[0]), about_1 = (m[1] - m[0]) * (twice_T * m[2] - L2);
  const auto [low, high] = std::minmax(about_1, about_3);
  double a = 1, b = std::sqrt(1 - low / high);
  for (int i = 0; i < 8; ++i) {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  return 4 * (std::numbers::pi / (2 * a)) / std::sqrt(high / (m[0] * m[1] * m[2]));
}

/// On how many scenes the property holds; it fails on none.
int held(const char* property, const std::vector<Scene>& scenes, oracle::Subject& subject) {
  const properties::Property& law = properties::find(property);
  return count(scenes, [&](const Scene& scene) {
    const oracle::Outcome outcome = law.check(scene, subject).outcome;
    CHECK(outcome != oracle::Outcome::fails);
    return outcome == oracle::Outcome::holds;
  });
}

bool is_tumbling(const Body& body) {
  const auto* given = std::get_if<MassProperties>(&body.mass);
  return given != nullptr && given->I_BBcm_B(0, 0) != given->I_BBcm_B(1, 1);
}

}  // namespace

TEST_CASE("drawn motions: flights.tangent touches exactly, by next to nothing, or just does not") {
  const std::vector<Scene> scenes = drawn("flights.tangent", draws);
  for (const Scene& scene : scenes) {
    REQUIRE(comes_within(scene, 0x1p-27));
    if (truth(scene).status == Status::miss) continue;
    CHECK(std::abs(truth(scene).time.lo - tangent_at(scene)) < 0x1p-10);
  }
  // Exactly, in an edge or a point, at a time that is a double; a contact that is proved by overlap has an interval.
  const auto exactly = [](const Scene& s) {
    return truth(s).status == Status::hit && truth(s).time.lo == truth(s).time.hi;
  };
  CHECK(count(scenes, exactly) >= 8);
  CHECK(count(scenes, [](const Scene& s) { return truth(s).status == Status::hit; }) >= 12);
  CHECK(count(scenes, [](const Scene& s) { return truth(s).status == Status::miss; }) >= 12);
}

TEST_CASE("drawn motions: flights.tangent has two balls or two boxes") {
  CHECK(count(drawn("flights.tangent", draws), [](const Scene& scene) {
          return scene.bodies[0].shape.index() == scene.bodies[1].shape.index();
        }) == draws);
}

// From the plate's middle: its centre lies h below the middle of the face, and the ball's centre r above the face.
TEST_CASE("drawn motions: tables.slope has a ball that touches the tilted face, also beside its middle") {
  int beside = 0;
  const int touching = count(drawn("tables.slope", draws), [&](const Scene& scene) {
    const Body &ball = scene.bodies[0], &plate = scene.bodies[1];
    const Eigen::Quaterniond q(plate.X_WB.q_WB.w, plate.X_WB.q_WB.x, plate.X_WB.q_WB.y, plate.X_WB.q_WB.z);
    const Vec3 p_B = q.normalized().conjugate() * (ball.X_WB.p_WB - plate.X_WB.p_WB);
    if (std::abs(p_B.x()) > 1e-12) ++beside;
    const double height = std::get<Box>(plate.shape).half_extents.z() + std::get<Sphere>(ball.shape).radius;
    return std::abs(p_B.z() - height) < 1e-12;
  });
  CHECK(touching == draws);
  CHECK(beside > draws / 4);
}

TEST_CASE("drawn motions: flights.turning_points are in contact at the turn, just before it and just after") {
  const std::vector<Scene> scenes = drawn("flights.turning_points", draws);
  constexpr double at_once = 0x1p-45;  // s
  // The first contact, or where the reference leaves it undecided: most of these touch exactly.
  const auto after_turn = [&](const Scene& s) { return truth(s).time.lo - tangent_at(s); };
  const auto touches = [](const Scene& s) { return truth(s).status != Status::miss; };
  for (const Scene& scene : scenes) CHECK((!touches(scene) || std::abs(after_turn(scene)) <= 0.25));
  CHECK(count(scenes, [&](const Scene& s) { return touches(s) && std::abs(after_turn(s)) <= at_once; }) >= 6);
  CHECK(count(scenes, [&](const Scene& s) { return touches(s) && after_turn(s) < -at_once; }) >= 10);
  CHECK(count(scenes, [&](const Scene& s) { return touches(s) && after_turn(s) > at_once; }) >= 6);
  CHECK(count(scenes, [](const Scene& s) { return truth(s).status == Status::hit; }) >= 10);
  CHECK(count(scenes, [](const Scene& s) { return truth(s).status == Status::miss; }) >= 6);
}

TEST_CASE("drawn motions: flights.late_starts are next to each other when the later one starts, and differ in start") {
  const std::vector<Scene> scenes = drawn("flights.late_starts", draws);
  const auto start = [](const Scene& s) { return std::max(s.motion->start_times[0], s.motion->start_times[1]); };
  for (const Scene& scene : scenes) {
    REQUIRE(scene.motion->start_times[0] != scene.motion->start_times[1]);
    CHECK(oracle::truth::time_of_distance(scene, 0.125).time.lo == start(scene));
  }
  const auto touches = [&](const Scene& s) { return oracle::truth::time_of_distance(s, 0).time.hi == start(s); };
  CHECK(count(scenes, touches) >= 4);
  CHECK(count(scenes, [&](const Scene& s) { return truth(s).status == Status::hit; }) >= 12);
  CHECK(count(scenes, [&](const Scene& s) { return truth(s).status == Status::miss; }) >= 12);
}

TEST_CASE("drawn motions: flights.compounds come into contact") {
  const std::vector<Scene> scenes = drawn("flights.compounds", draws);
  const auto parts = [](const Body& body) {
    const auto* compound = std::get_if<Compound>(&body.shape);
    return compound == nullptr ? 0 : static_cast<int>(compound->parts.size());
  };
  for (const Scene& scene : scenes) CHECK(std::max(parts(scene.bodies[0]), parts(scene.bodies[1])) >= 2);
  CHECK(count(scenes, [&](const Scene& s) { return parts(s.bodies[0]) > 0 && parts(s.bodies[1]) > 0; }) >= 10);
  CHECK(count(scenes, [](const Scene& s) { return truth(s).status == Status::hit; }) >= 30);
}

TEST_CASE("drawn motions: flights.many_periods tumble for more than 8 periods before the contact") {
  const std::vector<Scene> scenes = drawn("flights.many_periods", draws);
  for (const Scene& scene : scenes) {
    const double until = truth(scene).time.lo;
    CHECK(std::ranges::any_of(scene.bodies, is_tumbling));
    for (const Body& body : scene.bodies) CHECK((!is_tumbling(body) || until > 8 * period(body)));
  }
  CHECK(count(scenes, [](const Scene& s) { return truth(s).status == Status::hit; }) >= 50);
}

TEST_CASE("drawn motions: flights.from_afar are up to 2^60 sizes apart, and many touch") {
  const std::vector<Scene> scenes = drawn("flights.from_afar", draws);
  const auto ratio = [](const Scene& s) {
    return (s.bodies[0].X_WB.p_WB - s.bodies[1].X_WB.p_WB).norm() /
           std::max(size(s.bodies[0].shape), size(s.bodies[1].shape));
  };
  CHECK(count(scenes, [&](const Scene& s) { return ratio(s) > 0x1p40; }) >= 12);
  CHECK(count(scenes, [&](const Scene& s) { return ratio(s) > 0x1p56; }) >= 1);
  CHECK(count(scenes, [&](const Scene& s) { return ratio(s) < 0x1p40 && truth(s).status == Status::hit; }) >= 12);
}

TEST_CASE("drawn motions: runs.on_ice has bodies that rest or slide on each other, and such that collide") {
  const std::vector<Scene> scenes = drawn("runs.on_ice", draws);
  const auto subject = oracle::subjects::make_fast();
  const auto has = [&](const Scene& scene, Event::Kind kind, bool with_table) {
    const auto answer = subject->simulation(scene);
    const auto* said = std::get_if<Trajectory>(&answer);
    return said != nullptr && std::ranges::any_of(*said->events, [&](const Event& event) {
             const bool on_table =
                 is_fixed(scene.bodies[static_cast<std::size_t>(event.b)]);  // the table is the last body
             return event.kind == kind && on_table == with_table;
           });
  };
  const auto scenes_with = [&](Event::Kind kind, bool with_table) {
    return count(scenes, [&](const Scene& scene) { return has(scene, kind, with_table); });
  };
  CHECK(scenes_with(Event::Kind::contact, false) >= 12);
  CHECK(scenes_with(Event::Kind::impact, false) >= 12);
  CHECK(scenes_with(Event::Kind::contact, true) >= 30);
  CHECK(scenes_with(Event::Kind::impact, true) >= 6);
}

TEST_CASE("drawn motions: runs.carried has bodies that slip until they stick, on boxes that move, fixed or on ice") {
  const std::vector<Scene> scenes = drawn("runs.carried", draws);
  const auto subject = oracle::subjects::make_fast();
  const properties::Property& law = properties::find("simulation.carried");
  const auto judged = [&](const Scene& scene) { return law.check(scene, *subject).outcome == oracle::Outcome::holds; };
  const auto has_free_box = [](const Scene& scene) { return scene.bodies.size() == 3; };
  CHECK(count(scenes, [&](const Scene& s) { return has_free_box(s) && judged(s); }) >= 30);
  CHECK(count(scenes, [&](const Scene& s) { return !has_free_box(s) && judged(s); }) >= 15);
}

TEST_CASE("drawn motions: runs.edge_on_edge has bars whose edges meet, and the order of their vertices is judged") {
  const std::vector<Scene> scenes = drawn("runs.edge_on_edge", draws);
  const auto subject = oracle::subjects::make_fast();
  for (const char* id : {"simulation.together_relabelled", "simulation.together_renumbered"}) {
    CHECK(held(id, scenes, *subject) >= 30);
  }
}

TEST_CASE("drawn motions: runs.hardly_parallel has edges that touch where they cross") {
  const auto subject = oracle::subjects::make_fast();
  const std::vector<Scene> scenes = drawn("runs.hardly_parallel", draws);
  for (const char* id : {"simulation.contacts", "simulation.impulses", "simulation.none_missed"}) {
    CHECK(held(id, scenes, *subject) >= draws * 3 / 4);
  }
}

TEST_CASE("drawn motions: tables.corner has bodies that rest in a corner, and bodies that come to its wall") {
  const std::vector<Scene> scenes = drawn("tables.corner", draws);
  const auto subject = oracle::subjects::make_fast();
  const auto answered = [&](const Scene& scene) { return std::get<Trajectory>(subject->simulation(scene)); };
  const auto way = [&](const Scene& scene) {
    return (answered(scene).states.back()[0].X_WB.p_WB - scene.bodies[0].X_WB.p_WB).norm();
  };
  const auto at_wall = [&](const Scene& scene) {
    return std::ranges::any_of(*answered(scene).events, [](const Event& event) { return event.b == 2; });
  };
  CHECK(count(scenes, [&](const Scene& scene) { return at_wall(scene) && way(scene) == 0; }) >= 20);
  CHECK(count(scenes, [&](const Scene& scene) { return at_wall(scene) && way(scene) > 0.01; }) >= 6);
  for (const char* id : {"simulation.energy", "simulation.solid", "simulation.work"}) {
    const properties::Property& law = properties::find(id);
    for (const Scene& scene : scenes) CHECK(law.check(scene, *subject).outcome == oracle::Outcome::holds);
  }
}

TEST_CASE("drawn motions: flights.redundant has polytopes with vertices that no face names before some that one does") {
  const auto has_gap = [](const Body& body) {
    const auto* solid = std::get_if<Polytope>(&body.shape);
    if (solid == nullptr) return false;
    std::vector<bool> named(solid->vertices.size());
    for (const std::vector<int>& face : solid->faces) {
      for (const int v : face) named[static_cast<std::size_t>(v)] = true;
    }
    return std::ranges::find(std::ranges::find(named, false), named.end(), true) != named.end();
  };
  const std::vector<Scene> scenes = drawn("flights.redundant", draws);
  CHECK(count(scenes, [&](const Scene& scene) { return std::ranges::any_of(scene.bodies, has_gap); }) >= 40);
  CHECK(count(scenes, [&](const Scene& scene) { return truth(scene).status == Status::hit; }) >= 20);
}
