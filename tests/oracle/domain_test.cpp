// Which scenes a declared domain contains, at sizes that are known on paper.
#include "oracle/domain.h"

#include <array>

#include "model/scene.h"
#include "oracle/truth/truth.h"
#include "tests/catch.h"

namespace touchstone::oracle {
namespace {

Scene of(std::vector<Shape> shapes) {
  Scene scene;
  for (Shape& shape : shapes) scene.bodies.emplace_back().shape = std::move(shape);
  return truth::completed(scene);
}

/// Its faces are 1, 1, 1 and 1/√3 below the opposite vertices; from its first vertex to another it is 1 m.
Polytope tetrahedron() { return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}}; }

bool is_inside(const Domain& domain, const Scene& scene) { return !beyond(domain, scene); }

bool within_lengths(double least, double greatest, const Shape& shape) {
  Domain domain;
  domain.lengths = Interval{least, greatest};
  return is_inside(domain, of({shape}));
}

TEST_CASE("a domain without limits contains every scene") { CHECK(is_inside({}, of({Sphere{1e300}, tetrahedron()}))); }

TEST_CASE("a body is as thick as its least height over a face, and as long as from its first vertex to the farthest") {
  CHECK(within_lengths(0.577, 1.001, tetrahedron()));
  CHECK_FALSE(within_lengths(0.578, 1.001, tetrahedron()));
  CHECK_FALSE(within_lengths(0.577, 0.999, tetrahedron()));
  CHECK(within_lengths(1.999, 7.484, Box{{1, 2, 3}}));  // the diagonal is 2√14
  CHECK_FALSE(within_lengths(2.001, 7.484, Box{{1, 2, 3}}));
  CHECK_FALSE(within_lengths(1.999, 7.483, Box{{1, 2, 3}}));
  CHECK(within_lengths(3.999, 4.001, Sphere{2}));
  CHECK_FALSE(within_lengths(3.999, 4.001, Compound{{{Pose{}, Sphere{2}}, {Pose{}, Sphere{1}}}}));
}

TEST_CASE("a fixed body has limits of its own, where they are declared") {
  Scene scene = of({Box{{1, 1, 1}}, Box{{100, 100, 1}}});
  Domain domain;
  domain.lengths = Interval{0.05, 10};
  domain.fixed_lengths = Interval{0, 1000};
  CHECK(*beyond(domain, scene) == "a length, m: 283 is above 10");
  scene.bodies[1].mass = Fixed{};
  CHECK(is_inside(domain, scene));
  domain.fixed_lengths = Interval{0, 100};
  CHECK(*beyond(domain, scene) == "a length, m: 283 is above 100");
  domain.fixed_lengths.reset();
  CHECK(*beyond(domain, scene) == "a length, m: 283 is above 10");
}

TEST_CASE("the other limits") {
  const auto inside = [](const Domain& wider, const Domain& narrower, const Scene& scene) {
    CHECK(is_inside(wider, scene));
    CHECK_FALSE(is_inside(narrower, scene));
  };
  const auto with = [](auto member, auto limit) {
    Domain domain;
    domain.*member = limit;
    return domain;
  };
  Scene pair = of({tetrahedron(), Sphere{1}});  // masses 1/6 and 4π/3: the ratio is 8π
  pair.bodies[1].X_WB.p_WB = {0, -3, 0};
  pair.bodies[0].velocity.v_WBcm = {3, 4, 0};
  pair.bodies[1].velocity.w_WB = {0, 6, 8};
  inside(with(&Domain::reach, 4.001), with(&Domain::reach, 3.999), pair);
  Scene sequence = pair;  // a ball of radius 1, 5 m away in a frame
  sequence.frames.push_back({Placement{1, Pose{{0, 0, 5}, {}}}, Placement{0, std::nullopt}});
  inside(with(&Domain::reach, 6.001), with(&Domain::reach, 5.999), sequence);
  inside(with(&Domain::aspect, 1.733), with(&Domain::aspect, 1.732), pair);  // √3
  inside(with(&Domain::vertices, 4), with(&Domain::vertices, 3), pair);
  inside(with(&Domain::mass_ratio, 25.14), with(&Domain::mass_ratio, 25.13), pair);
  inside(with(&Domain::speed, 5.001), with(&Domain::speed, 4.999), pair);
  inside(with(&Domain::angular_speed, 10.001), with(&Domain::angular_speed, 9.999), pair);
  CHECK(*beyond(with(&Domain::speed, 4), pair) == "a speed, m/s: 5 is above 4");
}

TEST_CASE("domain: the mass ratio is that of the greatest and the least mass, wherever they are") {
  for (const auto& densities : {std::array{1.0, 4.0, 2.0}, std::array{2.0, 4.0, 1.0}, std::array{4.0, 1.0, 2.0}}) {
    Scene scene;
    for (const double density : densities) {
      Body& body = scene.bodies.emplace_back();
      body.shape = Box{{1, 1, 1}};
      body.mass = Density{density};
    }
    CHECK(mass_ratio(truth::completed(scene)) == 4);
  }
}

TEST_CASE("domain: a scene that moves may be too slow, one at rest or under gravity is not", "[domain]") {
  Domain domain;
  domain.lowest_speed = 3;
  Scene scene = of({Sphere{2}, Sphere{1}});
  CHECK_FALSE(beyond(domain, scene));
  scene.bodies[0].velocity.w_WB = {0, 0, 1};  // 2 m/s on its equator
  CHECK(*beyond(domain, scene) == "the greatest speed of a point, 2 m/s, is below 3 m/s");
  scene.bodies[0].velocity.v_WBcm = {1, 0, 0};  // 3 m/s
  CHECK_FALSE(beyond(domain, scene));
  scene.bodies[0].velocity.v_WBcm = {0.999, 0, 0};
  CHECK(beyond(domain, scene));
  scene.gravity = {0, 0, -10};
  CHECK_FALSE(beyond(domain, scene));
}

}  // namespace
}  // namespace touchstone::oracle
