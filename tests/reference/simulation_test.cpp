#include "reference/simulation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "model/input_error.h"
#include "model/limits.h"
#include "reference/distance.h"
#include "reference/validity.h"
#include "tests/catch.h"
#include "tests/reference/moving_scenes.h"

namespace touchstone::tests {
namespace {

using reference::simulation;

Body ball(double radius, const Vec3& p, const Vec3& v, double e = 1) {
  Body b = body(Sphere{radius}, p);
  b.velocity.v_WBcm = v;
  b.material.restitution = e;
  return b;
}

Body floor() {
  Body b = body(Box{Vec3(8, 8, 1)}, Vec3(0, 0, -1));
  b.mass = Fixed{};
  b.material.restitution = 1;
  return b;
}

Scene sampled_at(std::vector<Body> bodies, std::vector<double> times) {
  Scene scene;
  scene.bodies = std::move(bodies);
  scene.motion = Motion{.sample_times = std::move(times)};
  return scene;
}

TEST_CASE("A ball that bounces: impacts at the times of its parabolas") {
  Scene scene = sampled_at({ball(0.5, Vec3(0, 0, 1.5), Vec3::Zero(), 0.5), floor()}, {0.25, 1, 1.25});
  scene.gravity = Vec3(0, 0, -8);
  const Trajectory said = simulation(scene);
  REQUIRE(!said.complete_until);
  REQUIRE(said.events->size() >= 2);
  // Falls 1 m in 1/2 s, leaves at 2 m/s, is back 1/2 s later; an envelope of 2^-31 comes that much sooner.
  CHECK((*said.events)[0].time == Approx(0.5).margin(1e-9));
  CHECK((*said.events)[0].time < 0.5);
  CHECK((*said.events)[0].after_a.velocity.v_WBcm.z() == Approx(2).margin(1e-8));
  CHECK((*said.events)[0].nhat_BA_W == Vec3(0, 0, 1));
  CHECK((*said.events)[1].time == Approx(1).margin(1e-8));
  REQUIRE(said.states.size() == 3);
  CHECK(said.states[0][0].X_WB.p_WB == Vec3(0, 0, 1.25));
  CHECK(said.states[0][0].velocity.v_WBcm == Vec3(0, 0, -2));
}

TEST_CASE("A bouncing ball piles up its impacts, and the reference says where it stops") {
  Scene scene = sampled_at({ball(0.5, Vec3(0, 0, 1.5), Vec3::Zero(), 0.5), floor()}, {1, 4});
  scene.gravity = Vec3(0, 0, -8);
  const Trajectory said = simulation(scene, {.impacts = 100});
  REQUIRE(said.complete_until);
  // 1/2 (1 + e)/(1 − e) = 3/2, and some micro-bounces within the envelope, of √(2ε/g) each.
  CHECK(*said.complete_until == Approx(1.5).margin(1e-3));
  CHECK(said.states.size() == 1);
}

TEST_CASE("Newton's cradle with gaps passes the motion on") {
  std::vector<Body> row;
  for (int i = 0; i < 5; ++i) row.push_back(ball(0.5, Vec3(1.25 * i, 0, 0), Vec3(i == 0 ? 1 : 0, 0, 0)));
  const Trajectory said = simulation(sampled_at(row, {8}));
  REQUIRE(!said.complete_until);
  CHECK(said.events->size() == 4);
  for (int i = 0; i < 5; ++i) {
    CHECK(said.states[0][static_cast<std::size_t>(i)].velocity.v_WBcm == Vec3(i == 4 ? 1 : 0, 0, 0));
  }
}

double energy(const Scene& scene, const std::vector<State>& states, const Mat3& I) {
  double sum = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (std::holds_alternative<Fixed>(scene.bodies[i].mass)) continue;
    const Velocity& v = states[i].velocity;
    sum += v.v_WBcm.squaredNorm() / 2 + v.w_WB.dot(I * v.w_WB) / 2;
  }
  return sum;
}

TEST_CASE("Hulls in a box: energy and momentum through impacts, and nobody in anybody") {
  Dice dice(6);
  Scene scene;
  for (int i = 0; i < 3; ++i) {
    const Quaternion q = random_quaternion(dice);  // first: the order of two draws in one call is the compiler's
    Body hull = body(round_hull(dice, 8), Vec3(3.0 * i, 0, 0), q);
    hull.mass = round_mass(1, 0.5);
    hull.material = {.restitution = 1, .friction = i == 1 ? 0.0 : 0.5};
    hull.velocity = {Vec3(2 - 2.0 * i, 0, 0) + 0.25 * dice.in_cube(), dice.in_cube()};
    scene.bodies.push_back(hull);
  }
  scene.motion = Motion{.sample_times = {0.5, 1, 1.5, 2, 3}};
  const Trajectory said = simulation(scene);
  REQUIRE(!said.complete_until);
  REQUIRE(said.events->size() >= 2);
  Vec3 momentum = Vec3::Zero();
  for (const Body& b : scene.bodies) momentum += b.velocity.v_WBcm;
  const Mat3 I = 0.5 * Mat3::Identity();
  const double before = energy(scene, said.states[0], I);
  for (const std::vector<State>& states : said.states) {
    CHECK(energy(scene, states, I) == Approx(before).epsilon(1e-13));
    Vec3 now = Vec3::Zero();
    Scene then = scene;
    for (std::size_t i = 0; i < states.size(); ++i) {
      now += states[i].velocity.v_WBcm;
      then.bodies[i].X_WB = states[i].X_WB;
    }
    CHECK((now - momentum).norm() < 1e-13);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        CHECK(reference::distance(pair(then.bodies[i], then.bodies[j])).verdict == Verdict::separated);
      }
    }
  }
  for (const Event& event : *said.events) {
    Body a = scene.bodies[static_cast<std::size_t>(event.a)], b = scene.bodies[static_cast<std::size_t>(event.b)];
    a.X_WB = event.after_a.X_WB;
    b.X_WB = event.after_b.X_WB;
    CHECK(reference::distance(pair(a, b)).distance.hi <= envelope(scene));
  }
}

TEST_CASE("A box that falls flat leaves flat, with e times its speed") {
  for (const double e : {0.0, 0.5, 1.0}) {
    for (const double mu : {0.0, 0.5}) {
      Body box = body(Box{Vec3(1, 1, 0.5)}, Vec3(0, 0, 1.5));
      box.material = {e, mu};
      box.velocity.v_WBcm = {0, 0, -1};
      Body table = floor();
      table.material = {1, 1};
      for (const bool first : {true, false}) {
        const Trajectory said = simulation(first ? sampled_at({box, table}, {1.5}) : sampled_at({table, box}, {1.5}));
        REQUIRE(said.events->size() == 1);
        const Event& event = said.events->front();
        const Velocity& V = (first ? event.after_a : event.after_b).velocity;
        CHECK(V.v_WBcm == Vec3(0, 0, e));
        CHECK(V.w_WB == Vec3(0, 0, 0));
      }
    }
  }
}

TEST_CASE("A compound that falls flat on several of its parts leaves flat, in any order of the parts") {
  const auto round_post = [](double x, double y) { return Part{{{x, y, 0.5}, {}}, Sphere{0.5}}; };
  const auto post = [](double x, double y) { return Part{{{x, y, 0.5}, {}}, Box{Vec3(0.25, 0.25, 0.5)}}; };
  const std::vector<std::vector<Part>> all = {{round_post(-1, 0), round_post(1, 0)},
                                              {round_post(-2, 0), round_post(2, 0), post(0, 1), post(0, -1)},
                                              {post(1, 1), post(-1, 1), post(1, -1), post(-1, -1)}};
  for (std::vector<Part> parts : all) {
    for (const bool is_reversed : {false, true}) {
      if (is_reversed) std::ranges::reverse(parts);
      for (const double mu : {0.0, 0.5}) {
        Body table = body(Compound{parts}, Vec3(0, 0, 1));
        table.material = {0.5, mu};
        table.velocity.v_WBcm = {0, 0, -1};
        table.mass = MassProperties{1, {0, 0, 0.5}, Mat3::Identity()};
        Body ground = floor();
        ground.material.friction = 1;
        const Trajectory said = simulation(sampled_at({table, ground}, {1.5}));
        INFO(said.gave_up);
        if (mu > 0) {  // the law leaves open how friction is shared among the parts
          CHECK(said.gave_up.find("friction") != std::string::npos);
          continue;
        }
        REQUIRE(!said.complete_until);
        const Velocity& V = said.states.back()[0].velocity;
        CHECK(V.v_WBcm == Vec3(0, 0, 0.5));
        CHECK(V.w_WB == Vec3(0, 0, 0));
        CHECK(said.events->back().after_a.velocity == V);
        for (const Event& event : *said.events) {  // each on a part, not in the air between them
          CHECK(std::ranges::any_of(parts, [&](const Part& part) {
            const Vec3 off = event.p_WC - part.X_BP.p_WB;
            return std::abs(off.x()) <= 0.25 && std::abs(off.y()) <= 0.25;
          }));
        }
      }
    }
  }
}

// The points of a region act as one, also those of parts that separate before the impact: so two blocks of one body
// leave as the box that spans them. Without friction, u_n = v_z - x w_y. Round 1 stops the ends at x = -5/4 and 5/4,
// and half of its impulse of 1 N s at x = 1/2 comes back; round 2 is at x = -5/4, where K = 1 + (5/4)^2 / I.
TEST_CASE("Parts of which one separates before the impact leave as one convex body with their contact points does") {
  const auto block = [](double x) { return Part{{{x, 0, 0}, {}}, Box{Vec3(0.25, 0.25, 0.25)}}; };
  const auto leaves = [](const Shape& shape, double I, double spin) {
    Body falls = body(shape, Vec3(0, 0, 0.25));
    falls.material = {0.5, 0};
    falls.velocity = {{0, 0, -1}, {0, spin, 0}};
    falls.mass = MassProperties{1, {0, 0, 0}, I * Mat3::Identity()};
    const Trajectory said = simulation(sampled_at({falls, floor()}, {0x1p-10}));
    REQUIRE(!said.complete_until);
    return said.states.back()[0].velocity;
  };
  for (const double I : {0.03125, 0.125, 0.25, 0.5}) {
    for (const double spin : {0.75, 2.0, -3.0}) {
      const Velocity one = leaves(Box{Vec3(1.25, 0.25, 0.25)}, I, spin);
      for (const std::vector<Part>& parts : {std::vector<Part>{block(-1), block(1)}, {block(1), block(-1)}}) {
        const Velocity two = leaves(Compound{parts}, I, spin);
        CHECK((two.v_WBcm - one.v_WBcm).norm() < 1e-15);
        CHECK((two.w_WB - one.w_WB).norm() < 1e-14);
      }
    }
  }
  const Velocity V = leaves(Compound{{block(-1), block(1)}}, 0.25, 2);
  CHECK(V.v_WBcm.z() == Approx(19.0 / 29).epsilon(1e-15));
  CHECK(V.w_WB.y() == Approx(-13.0 / 58).epsilon(1e-15));
}

// A ball between two walls of one body, at a right angle: it touches both at one time, and leaves as it came.
TEST_CASE("Parts that are touched at one time in two directions act together") {
  const Compound corner{{Part{{{-1, 0, 0}, {}}, Box{Vec3(1, 4, 4)}}, Part{{{0, -1, 0}, {}}, Box{Vec3(4, 1, 4)}}}};
  Body walls = body(corner, Vec3(0, 0, 0));
  walls.mass = Fixed{};
  walls.material.restitution = 1;
  Body thrown = ball(0.5, {1.5, 1.5, 0}, {-1, -1, 0});
  thrown.mass = round_mass();
  const Trajectory said = simulation(sampled_at({walls, thrown}, {1.5}));
  INFO(said.gave_up);
  REQUIRE(said.events->size() == 2);
  CHECK((said.states.back()[1].velocity.v_WBcm - Vec3(1, 1, 0)).norm() < 1e-15);
}

/// Equal balls of diameter 1 and mass 1 on the x axis, without friction. Those that start one apart have a gap of 2^-33
/// beside an envelope of 2^-31: the reference does not follow bodies that touch from the start.
Trajectory row_of(const std::vector<double>& x, const std::vector<double>& v) {
  std::vector<Body> row;
  for (std::size_t i = 0; i < x.size(); ++i) {
    row.push_back(ball(0.5, {x[i] * (1 + 0x1p-33), 0, 0}, {v[i], 0, 0}));
    row.back().mass = round_mass();
  }
  return simulation(sampled_at(std::move(row), {4}));
}

std::vector<double> speeds(const Trajectory& said) {
  INFO(said.gave_up);
  REQUIRE(said.states.size() == 1);
  std::vector<double> after;
  for (const State& state : said.states.back()) after.push_back(state.velocity.v_WBcm.x());
  return after;
}

TEST_CASE("Newton's cradle whose balls are within the envelope, hit by one, two or three, and from both sides") {
  using Row = std::vector<double>;
  CHECK(speeds(row_of({-3, -1, 0, 1, 2}, {1, 0, 0, 0, 0})) == Row{0, 0, 0, 0, 1});
  CHECK(speeds(row_of({-3, -2, 0, 1, 2}, {1, 1, 0, 0, 0})) == Row{0, 0, 0, 1, 1});
  CHECK(speeds(row_of({-4, -3, -2, 0, 1}, {1, 1, 1, 0, 0})) == Row{0, 0, 1, 1, 1});
  CHECK(speeds(row_of({-2, 0, 2}, {1, 0, -1})) == Row{-1, 0, 1});
}

// By u' = −u at each pair: 2 and 1 leave with 2/3 and 8/3, 1 and 3 with −3 and −1; then the inner two exchange theirs.
TEST_CASE("A row is hit from both ends at one time: the ends act apart, before the contact between them") {
  const double gap = 0x1p-34;
  const std::array<double, 4> x = {-3, 0, 2 + gap, 5 + gap}, v = {2, 0, 0, -2}, m = {2, 1, 1, 3};
  for (const double friction : {0.0, 0.5}) {
    std::vector<std::size_t> order = {0, 1, 2, 3};
    do {
      std::vector<Body> row;
      for (const std::size_t k : order) {
        Body& b = row.emplace_back(ball(1, {x[k], 0, 0}, {v[k], 0, 0}));
        b.mass = round_mass(m[k]);
        b.material.friction = friction;
      }
      const Trajectory said = simulation(sampled_at(row, {0.625}));
      REQUIRE(said.events->size() >= 3);
      std::array<double, 4> now = v;
      for (std::size_t i = 0; i < 3; ++i) {
        const Event& event = (*said.events)[i];
        now[order[static_cast<std::size_t>(event.a)]] = event.after_a.velocity.v_WBcm.x();
        now[order[static_cast<std::size_t>(event.b)]] = event.after_b.velocity.v_WBcm.x();
      }
      const std::array<double, 4> after = {2.0 / 3, -3, 8.0 / 3, -1};
      for (std::size_t k = 0; k < 4; ++k) CHECK(now[k] == Approx(after[k]).epsilon(1e-14));
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

/// Ball 0 hits ball 1, ball 2 touches that one and moves with it at first; the rest approach ball 2.
Trajectory beside_a_hit(const std::vector<Body>& rest, double end) {
  std::vector<Body> bodies = {ball(1, {0, -3, 0}, {0, 1, 0}), ball(1, {0, 0, 0}, {0, 0, 0}),
                              ball(1, {2 + 0x1p-34, 0, 0}, {0, 0, 0})};
  bodies.insert(bodies.end(), rest.begin(), rest.end());
  for (Body& b : bodies) b.mass = round_mass();
  for (std::size_t i = 1; i < bodies.size(); ++i) bodies[i].material.friction = 0.5;
  return simulation(sampled_at(bodies, {end}));
}

TEST_CASE("A contact that is connected to an impact acts at its own time, unless it is due with it") {
  const double near = 0.9 * 0x1p-30, x = 2 + 0x1p-34;
  const Trajectory said =
      beside_a_hit({ball(1, {x + 2 + near, 0, 0}, {-1e-10, 0, 0}), ball(1, {x, 2 + near, 0}, {0, -1e-10, 0})}, 1.5);
  CHECK(!said.complete_until);
  REQUIRE(said.events->size() == 1);
  CHECK((*said.events)[0].b == 1);
  const Trajectory longer = beside_a_hit({ball(1, {x + 2 + near, 0, 0}, {-1e-10, 0, 0})}, 8);
  REQUIRE(longer.events->size() >= 2);
  CHECK((*longer.events)[1].b == 3);
  CHECK((*longer.events)[1].time > 3);  // from 0.9 to half an envelope
}

TEST_CASE("An impact whose neighbour's outcome is open has one of its own") {
  const double x = 2 + 0x1p-34;
  const Trajectory said = beside_a_hit({ball(1, {x + 3, 0, 0}, {-1, 0, 0}), ball(1, {x, 3, 0}, {0, -1, 0})}, 1.5);
  REQUIRE(said.complete_until);
  REQUIRE(said.events->size() == 1);
  CHECK((*said.events)[0].b == 1);
  CHECK(said.gave_up.find("bodies[2]") != std::string::npos);
}

std::vector<Body> clash(double friction, double other_restitution) {
  std::vector<Body> row = {ball(0.5, {-2, 0, 0}, {1, 0, 0}), ball(0.5, {0, 0, 0}, {0, 0, 0}),
                           ball(0.5, {2, 0, 0}, {-1, 0, 0})};
  for (Body& b : row) b.material.friction = friction;
  row.back().material.restitution = other_restitution;
  return row;
}

TEST_CASE("Impacts that act together with friction are not followed") {
  const Trajectory said = simulation(sampled_at(clash(0.5, 1), {4}));
  REQUIRE(said.complete_until);
  CHECK(*said.complete_until == Approx(1).margin(1e-8));
  CHECK(said.gave_up.find("act together with friction") != std::string::npos);
}

// p = 1 and 1, K = (2, -1; -1, 2): of q = s (1, 1/2), 3/2 s² may be 1 + 1/4.
TEST_CASE("Impacts that act together with unlike restitution return what their energy allows") {
  const Trajectory said = simulation(sampled_at(clash(0, 0.5), {1.5}));
  REQUIRE(said.states.size() == 1);
  const double s = std::sqrt(5.0 / 6);
  const auto v = [&](std::size_t i) { return said.states[0][i].velocity.v_WBcm.x(); };
  CHECK(v(0) == Approx(-s).epsilon(1e-12));
  CHECK(v(1) == Approx(s / 2).epsilon(1e-12));
  CHECK(v(2) == Approx(s / 2).epsilon(1e-12));
}

TEST_CASE("A ball that hits two at once breaks them symmetrically, in any order of the three") {
  // Normals (4/5, ±3/5): diameter 5, centres (4, ±3) from the first one's. docs/design/simultaneous.md has the law.
  for (const double e : {1.0, 0.5}) {
    std::vector<int> order = {0, 1, 2};
    do {
      std::vector<Body> bodies;
      for (const int k : order) {
        Body b = ball(2.5, k == 0 ? Vec3(-5, 0, 0) : Vec3(4, k == 1 ? 3 : -3, 0), Vec3(k == 0 ? 5 : 0, 0, 0), e);
        b.mass = round_mass();
        bodies.push_back(b);
      }
      const Trajectory said = simulation(sampled_at(bodies, {1.5}));
      REQUIRE(said.events->size() == 2);
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 v = said.states.back()[i].velocity.v_WBcm / 5;
        const double side = order[i] == 1 ? 1 : -1;
        const Vec3 striker = e == 1 ? Vec3(-7.0 / 57, 0, 0) : Vec3(3.0 / 19, 0, 0);
        const Vec3 other = e == 1 ? Vec3(32.0 / 57, side * 8 / 19, 0) : Vec3(8.0 / 19, side * 6 / 19, 0);
        // The normal is that of centres within the envelope of 2^-29 of touching.
        CHECK((v - (order[i] == 0 ? striker : other)).norm() < 1e-8);
      }
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

TEST_CASE("A push is an event of its own") {
  Scene scene = sampled_at({ball(0.5, Vec3(0, 0, 0), Vec3(1, 0, 0))}, {1, 2});
  scene.bodies[0].mass = round_mass(2);
  scene.motion->force_bound = 4;
  scene.motion->forces = {{0, 0, Vec3(0, 0, 4)}, {1, 0, Vec3::Zero()}};
  const Trajectory said = simulation(scene);
  REQUIRE(said.events->size() == 1);
  CHECK((*said.events)[0].kind == Event::Kind::force);
  CHECK(said.states[0][0].X_WB.p_WB == Vec3(1, 0, 1));
  CHECK(said.states[1][0].X_WB.p_WB == Vec3(2, 0, 3));
}

TEST_CASE("A body that tumbles for long keeps its energy") {
  Body block = body(Box{Vec3(1, 2, 3)});
  block.velocity.w_WB = Vec3(1, 8, 2);
  const Trajectory said = simulation(sampled_at({block}, {0.5, 1, 1024}));
  CHECK(!said.complete_until);
  REQUIRE(said.states.size() == 3);
  const auto twice_energy = [](const Quaternion& q, const Vec3& w) {  // of a mass of 3
    const Vec3 w_B = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().conjugate() * w;
    return Vec3(13, 10, 5).dot(w_B.cwiseAbs2());
  };
  const double before = twice_energy(block.X_WB.q_WB, block.velocity.w_WB);
  for (const std::vector<State>& sample : said.states) {
    CHECK(twice_energy(sample[0].X_WB.q_WB, sample[0].velocity.w_WB) == Approx(before).epsilon(1e-14));
  }
}

TEST_CASE("Bodies that overlap at the start are refused") {
  CHECK_THROWS_AS(
      simulation(sampled_at({ball(1, Vec3::Zero(), Vec3::Zero()), ball(1, Vec3(1, 0, 0), Vec3::Zero())}, {1})),
      InputError);
}

}  // namespace
}  // namespace touchstone::tests
