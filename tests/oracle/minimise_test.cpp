#include "oracle/minimise/minimise.h"

#include <cmath>

#include "oracle/minimise/scene_edit.h"
#include "oracle/minimise/shrink.h"
#include "oracle/truth/truth.h"
#include "oracle/truth/world_points.h"
#include "tests/catch.h"

namespace touchstone::oracle {
namespace {

/// A number in [-1, 1) that depends only on its counter and uses all bits of its mantissa.
double number(int& counter) {
  const double x = std::sin(static_cast<double>(++counter) * 12.9898) * 43758.5453;
  return 2 * (x - std::floor(x)) - 1;
}

/// Points close to a sphere: a hull of about `count` vertices.
Polytope ball(int count, int& counter) {
  std::vector<Vec3> points;
  while (static_cast<int>(points.size()) < count) {
    const Vec3 p{number(counter), number(counter), number(counter)};
    if (p.norm() > 0.1 && p.norm() < 1) points.push_back(p / p.norm());
  }
  return truth::convex_hull(points);
}

/// Two rotated balls, separated by about `gap` along an oblique line.
Scene balls(int count, double gap) {
  int counter = count;
  Scene scene;
  scene.bodies.resize(2);
  for (Body& body : scene.bodies) {
    body.shape = ball(count, counter);
    body.X_WB.q_WB = {number(counter), number(counter), number(counter), number(counter)};
    body.velocity.v_WBcm = {1, 2, 3};
    body.name = "a body with a name";
  }
  scene.bodies[0].X_WB.p_WB = {100.1, -33.3, 7.77};
  scene.bodies[1].X_WB.p_WB = scene.bodies[0].X_WB.p_WB + (2 + gap) * Vec3(0.36, 0.48, 0.8);
  return truth::completed(scene);
}

struct Counted {
  int asked = 0;
  int limit = 0;
  std::function<bool(const Scene&)> fails;
  bool operator()(const Scene& scene) {
    ++asked;
    REQUIRE(truth::completed(scene) == scene);
    return fails(scene);
  }
};

Scene minimised(const Scene& scene, const std::function<bool(const Scene&)>& fails, int budget = 1500) {
  REQUIRE(fails(scene));
  Counted counted{0, budget, fails};
  const Scene smallest = minimise(scene, std::ref(counted), budget);
  CHECK(counted.asked <= budget);
  CHECK(fails(smallest));
  CHECK(minimise(scene, fails, budget) == smallest);
  const Size size = size_of(smallest);
  INFO(size.bodies << " bodies, " << size.vertices_per_body_max << " vertices, " << size.significant_bits_max
                   << " bits, " << counted.asked << " asked");
  CHECK(shrink::cost(smallest) <= shrink::cost(scene));
  return smallest;
}

bool separated(const Scene& scene) {
  return scene.bodies.size() == 2 && truth::distance(scene).verdict == Verdict::separated;
}

TEST_CASE("Significant bits count from the first to the last set bit") {
  CHECK(significant_bits(0) == 0);
  CHECK(significant_bits(-4) == 1);
  CHECK(significant_bits(5) == 3);
  CHECK(significant_bits(0.1) == 52);
  CHECK(significant_bits(1 + 0x1p-52) == 53);
  CHECK(significant_bits(5e-324) == 1);
}

TEST_CASE("A small gap between two balls of many corners comes down to two tetrahedra and few bits") {
  const auto fails = [](const Scene& scene) {
    return separated(scene) && truth::distance(scene).distance.hi < 1 && truth::distance(scene).distance.lo > 1e-9;
  };
  for (const int count : {12, 60}) {
    const Size size = size_of(minimised(balls(count, 0.01), fails));
    CHECK(size.bodies == 2);
    CHECK(size.vertices_per_body_max <= 4);
    CHECK(size.significant_bits_max <= 3);
  }
}

TEST_CASE("A gap of a ten-millionth of the size survives and still has few bits") {
  Scene scene = balls(30, 0.1);
  const Vec3 apart = truth::distance(scene).p_WCb - truth::distance(scene).p_WCa;
  scene.bodies[1].X_WB.p_WB -= (1 - 1e-7 / apart.norm()) * apart;
  const auto fails = [](const Scene& s) {
    return separated(s) && truth::distance(s).distance.lo > 1e-9 && truth::distance(s).distance.hi < 1e-6;
  };
  const Size size = size_of(minimised(scene, fails));
  CHECK(size.vertices_per_body_max <= 8);
  CHECK(size.significant_bits_max <= 8);
}

TEST_CASE("An edge pair as closest features survives") {
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].shape = Box{Vec3(1.1, 2.3, 1.7)};
  scene.bodies[1].shape = Box{Vec3(0.7, 1.9, 3.1)};
  scene.bodies[0].X_WB.q_WB = {0.9, 0.1, 0.3, 0.2};
  scene.bodies[1].X_WB = {{3.3, 2.9, 3.7}, {0.2, 0.7, -0.4, 0.1}};
  const auto fails = [](const Scene& s) {
    if (!separated(s)) return false;
    const auto& truth = truth::distance(s);
    return truth.feature_A.vertices.size() == 2 && truth.feature_B.vertices.size() == 2;
  };
  scene = truth::completed(scene);
  for (int i = 0; i < 40 && !fails(scene); ++i) scene.bodies[1].X_WB.q_WB.w += 0.13;
  const Size size = size_of(minimised(scene, fails));
  CHECK(size.vertices_per_body_max <= 4);
  CHECK(size.significant_bits_max <= 3);
}

TEST_CASE("Only the bodies that are needed stay") {
  Scene scene;
  scene.bodies.resize(33);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    scene.bodies[i].shape = Box{Vec3(0.4, 0.3, 0.2)};
    scene.bodies[i].X_WB.p_WB = {static_cast<double>(i) * 1.25, 0.1, 7};
  }
  scene.bodies[21].X_WB.p_WB = scene.bodies[4].X_WB.p_WB + Vec3(0.1, 0, 0);
  const auto fails = [](const Scene& s) { return !truth::broad_phase(s).empty(); };
  const Scene smallest = minimised(scene, fails);
  CHECK(smallest.bodies.size() == 2);
  CHECK(size_of(smallest).significant_bits_max <= 1);
}

TEST_CASE("A compound becomes the part that matters, and what does not matter is reset") {
  Scene scene;
  scene.bodies.resize(2);
  Compound compound;
  for (int i = 0; i < 4; ++i) compound.parts.push_back({{Vec3(3.0 * i, 0, 0), {}}, Box{Vec3::Ones()}});
  scene.bodies[0].shape = compound;
  scene.bodies[1].shape = Sphere{0.7};
  scene.bodies[1].X_WB.p_WB = {6.1, 1.6, 0};
  scene.bodies[1].material = {0.5, 0.5};
  scene.gravity = {0, 0, -9.81};
  const auto fails = [](const Scene& s) {
    return s.bodies.size() == 2 && truth::distance(s).verdict == Verdict::overlapping &&
           (std::holds_alternative<Sphere>(s.bodies[0].shape) || std::holds_alternative<Sphere>(s.bodies[1].shape));
  };
  const Scene smallest = minimised(scene, fails);
  CHECK(!std::holds_alternative<Compound>(smallest.bodies[0].shape));
  CHECK(smallest.gravity == Vec3::Zero());
  CHECK(smallest.bodies[1].material == Material{});
  CHECK(size_of(smallest).significant_bits_max <= 2);
}

TEST_CASE("A part alone stays where it was, however both are turned") {
  Scene scene;
  scene.bodies.resize(1);
  scene.bodies[0].shape = Compound{{{{{1, 0, 0}, {1, 0, 0, 1}}, Box{Vec3(1, 2, 3)}}}};
  scene.bodies[0].X_WB = {{0, 5, 0}, {1, 1, 0, 0}};
  const auto alone = shrink::fewer_parts(scene).front()(scene);
  REQUIRE(alone);
  const Points before = world_points(scene.bodies[0], 0), after = world_points(alone->bodies[0], 0);
  REQUIRE(before.size() == after.size());
  for (std::size_t k = 0; k < before.size(); ++k) CHECK(static_cast<double>((before[k] - after[k]).norm()) < 1e-12);
}

TEST_CASE("A hull of hundreds of vertices is cut down within a small budget") {
  const Scene scene = balls(600, 0.05);
  CHECK(size_of(scene).vertices_per_body_max > 500);
  const auto fails = [](const Scene& s) { return separated(s) && truth::distance(s).distance.hi < 0.2; };
  const Size size = size_of(minimised(scene, fails, 400));
  CHECK(size.vertices_per_body_max <= 8);
  CHECK(size.significant_bits_max <= 8);
}

TEST_CASE("A budget of nothing asks nothing, a failure that needs everything keeps everything") {
  const Scene scene = balls(12, 0.1);
  CHECK(minimise(
            scene, [](const Scene&) -> bool { throw std::logic_error("asked"); }, 0) == scene);
  CHECK(minimise(
            scene, [](const Scene&) { return false; }, 50) == scene);
}

/// The sequence that shows a missed removal: two bodies of which one is removed.
TEST_CASE("a film comes down to the shortest sequence that fails") {
  Scene sequence;
  sequence.bodies.resize(7);
  for (Body& body : sequence.bodies) body.shape = Box{{1, 2, 3}};
  int counter = 0;
  for (int f = 0; f < 9; ++f) {
    SequenceFrame& frame = sequence.frames.emplace_back();
    for (int body = f % 3; body < 7; body += 2) {
      Pose X_WB{{number(counter), number(counter), number(counter)}, {number(counter), number(counter), 1, 0}};
      frame.push_back({body, f == 6 && body == 4 ? std::nullopt : std::optional(X_WB)});
    }
  }
  const auto goes = [](const Scene& s) {
    for (const SequenceFrame& frame : s.frames) {
      for (const Placement& placement : frame) {
        if (!placement.X_WB && s.bodies.size() > 1) return true;
      }
    }
    return false;
  };
  const Scene smallest = minimised(sequence, goes);
  CHECK(smallest.bodies.size() == 2);
  REQUIRE(smallest.frames.size() == 2);
  REQUIRE(smallest.frames[0].size() == 1);
  CHECK(smallest.frames[0][0].X_WB == Pose{});
  CHECK(smallest.frames[1] == SequenceFrame{{smallest.frames[0][0].body, {}}});
}

TEST_CASE("an impact comes down to plain numbers, its velocities with them") {
  int counter = 7;
  Scene scene;
  scene.bodies.resize(2);
  for (Body& body : scene.bodies) {
    body.shape = Box{{1, 2, 3}};
    body.X_WB = {{number(counter), number(counter), number(counter)}, {1, number(counter), 0, 1}};
    body.velocity = {{number(counter), number(counter), number(counter)}, {number(counter), 0, number(counter)}};
    MassProperties given;
    given.mass = 1 + std::abs(number(counter));
    given.I_BBcm_B = Vec3(3, 4, 4 + std::abs(number(counter))).asDiagonal();
    body.mass = given;
  }
  scene.contact = Contact{{number(counter), 0.25, 0.5}, Vec3(1, 2, 2) / 3, Law::stronge, 0.7, 0.3};
  const auto slips = [](const Scene& s) {
    return s.contact && s.contact->friction > 0 && s.bodies[0].velocity.v_WBcm.x() != s.bodies[1].velocity.v_WBcm.x();
  };
  const Scene smallest = minimised(scene, slips);
  const Size size = size_of(smallest);
  CHECK(size.significant_bits_max <= 1);
  CHECK(size.vertices_per_body_max == 1);
  CHECK(smallest.contact->nhat_BA_W.cwiseAbs().maxCoeff() == 1);
  CHECK(smallest.contact->law == Law::poisson);
  CHECK(smallest.contact->restitution == 0);
  CHECK(smallest.contact->p_WC == Vec3::Zero());
}

TEST_CASE("a flight comes down to the bodies, times and pushes that matter") {
  int counter = 7;
  Scene scene;
  scene.gravity = Vec3(0, 0, -9.81);
  scene.bodies.resize(4);
  for (Body& body : scene.bodies) {
    body.shape = Box{{1, 2, 3}};
    body.X_WB = {{number(counter), number(counter), number(counter)}, {1, number(counter), 0, 1}};
    body.velocity = {{number(counter), number(counter), number(counter)}, {number(counter), 0, number(counter)}};
    body.material = {0.7, 0.3};
  }
  Motion& motion = scene.motion.emplace();
  motion.sample_times = {1, 1.7, 2.1, 3};
  motion.start_times = {0, 0.1, 0.2, 0.3};
  motion.envelope = 1e-7;
  motion.law = Law::stronge;
  motion.force_bound = 10;
  motion.forces = {{0.1, 1, {1, 2, 3}}, {0.2, 3, {1.5, 0, 0}}, {0.3, 2, {0, 1, 0}}};
  const auto pushed = [](const Scene& s) {
    return s.motion && s.motion->sample_times.back() > 1.5 &&
           std::ranges::any_of(s.motion->forces, [&](const AppliedForce& force) {
             return force.force_W.x() > 1.2 && s.bodies[static_cast<std::size_t>(force.body)].velocity.v_WBcm.x() != 0;
           });
  };
  const Scene smallest = minimised(scene, pushed);
  CHECK(smallest.bodies.size() == 1);
  CHECK(smallest.gravity == Vec3::Zero());
  REQUIRE(smallest.motion->sample_times.size() == 1);
  REQUIRE(smallest.motion->forces.size() == 1);
  CHECK(smallest.motion->start_times.empty());
  CHECK(!smallest.motion->envelope);
  CHECK(smallest.motion->law == Law::poisson);
  CHECK(size_of(smallest).significant_bits_max <= 1);
}

}  // namespace
}  // namespace touchstone::oracle
