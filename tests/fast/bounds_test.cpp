// fast's boxes and pairs against the exact ones: they contain the exact box, and are no wider than the header's law
// allows.
#include "fast/bounds.h"

#include <cmath>

#include "fast/broad_phase.h"
#include "reference/bounds.h"
#include "reference/broad_phase.h"
#include "tests/catch.h"
#include "tests/fast/box_law.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::fast {
namespace {

using reference::Rational;
using tests::body;
using tests::Dice;
using tests::widening;

void check_law(const Scene& scene) {
  const Bounds boxes = bounds(scene);
  const std::vector<reference::ExactBox> exact = reference::bounds(scene);
  REQUIRE(boxes.size() == exact.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Rational allowed = widening(scene.bodies[i]);
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t k = static_cast<std::size_t>(axis);
      REQUIRE(Rational(boxes[i].lo[axis]) <= exact[i].lo[k]);
      REQUIRE(exact[i].hi[k] <= Rational(boxes[i].hi[axis]));
      REQUIRE(exact[i].lo[k] - Rational(boxes[i].lo[axis]) <= allowed);
      REQUIRE(Rational(boxes[i].hi[axis]) - exact[i].hi[k] <= allowed);
    }
  }
}

Quaternion any_quaternion(Dice& dice, double scale) {
  return {scale * dice.around_zero(), scale * dice.around_zero(), scale * dice.around_zero(),
          scale * dice.around_zero()};
}

ConvexShape any_shape(Dice& dice, double size) {
  switch (dice.between(0, 2)) {
    case 0:
      return Sphere{size * (0.1 + dice.unit())};
    case 1:
      return Box{size * Vec3(0.01 + dice.unit(), 0.01 + dice.unit(), 0.01 + dice.unit())};
    default: {
      Polytope tetrahedron{{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, {}};
      for (Vec3& v : tetrahedron.vertices) v = size * (v + 0.2 * dice.in_cube());
      return tetrahedron;
    }
  }
}

/// A scene of six bodies, the last a compound: lengths of about `size`, quaternions of about `turn`.
Scene any_scene(Dice& dice, double size, double turn) {
  Scene scene;
  for (int i = 0; i < 5; ++i) {
    const Shape shape = std::visit([](auto s) -> Shape { return s; }, any_shape(dice, size));
    scene.bodies.push_back(body(shape, 3 * size * dice.in_cube(), any_quaternion(dice, turn)));
  }
  Compound compound;
  for (int i = 0; i < 3; ++i)
    compound.parts.push_back({{size * dice.in_cube(), any_quaternion(dice, 1 / turn)}, any_shape(dice, size)});
  scene.bodies.push_back(body(compound, 3 * size * dice.in_cube(), any_quaternion(dice, turn)));
  return scene;
}

TEST_CASE("bounds: hold the exact box and obey the law at every scale") {
  Dice dice(11);
  for (const double size : {1.0, 1e-3, 1e9, 0x1p-500, 0x1p500, 0x1p-1000, 0x1p1000})
    for (const double turn : {1.0, 1e-3, 0x1p-500, 0x1p500, 0x1p-1000, 0x1p1000})
      for (int i = 0; i < 40; ++i) check_law(any_scene(dice, size, turn));
}

TEST_CASE("bounds: hold where the size of the parts and the distance differ by far") {
  Dice dice(12);
  for (int i = 0; i < 300; ++i) {
    Scene scene = any_scene(dice, std::ldexp(1, dice.between(-60, 60)), 1);
    for (Body& b : scene.bodies) b.X_WB.p_WB *= std::ldexp(1, dice.between(-60, 60));
    check_law(scene);
  }
}

TEST_CASE("bounds: quarter turns and lattice bodies, where many coordinates tie") {
  Dice dice(13);
  for (int i = 0; i < 500; ++i) {
    Scene scene;
    for (int k = 0; k < 4; ++k) {
      const Vec3 half(dice.between(1, 3), dice.between(1, 3), dice.between(1, 3));
      scene.bodies.push_back(body(Box{half}, dice.lattice(4), tests::integer_quaternion(dice)));
    }
    check_law(scene);
  }
}

TEST_CASE("bounds: at the end of the range the greatest finite double stands, never infinity or NaN") {
  Scene scene;
  scene.bodies = {body(Sphere{1e308}, Vec3::Constant(1.7e308)),
                  body(Box{Vec3::Constant(1e308)}, Vec3::Constant(-1.7e308), {1, 2, 3, 4})};
  for (const Aabb& box : bounds(scene)) {
    CHECK(box.lo.allFinite());
    CHECK(box.hi.allFinite());
    CHECK((box.lo.array() <= box.hi.array()).all());
  }
}

/// Checks that every exact pair is found, and that every other pair is apart by at most the widening of the two boxes.
void check_pairs(const Scene& scene) {
  const PairSet found = broad_phase(scene);
  CHECK(std::is_sorted(found.begin(), found.end()));
  const PairSet exact = reference::broad_phase(scene);
  CHECK(std::includes(found.begin(), found.end(), exact.begin(), exact.end()));
  const std::vector<reference::ExactBox> boxes = reference::bounds(scene);
  for (const auto& [a, b] : found) {
    const std::size_t i = static_cast<std::size_t>(a);
    const std::size_t j = static_cast<std::size_t>(b);
    CHECK(reference::gap(boxes[i], boxes[j]) <= widening(scene.bodies[i]) + widening(scene.bodies[j]));
  }
}

TEST_CASE("broad_phase: misses no exact pair and invents none beyond the widening") {
  Dice dice(14);
  for (int i = 0; i < 300; ++i) check_pairs(any_scene(dice, 1, 1));
  for (int i = 0; i < 300; ++i) {
    Scene scene;
    for (int k = 0; k < 12; ++k) scene.bodies.push_back(body(Box{Vec3(1, 1, 1)}, dice.lattice(4)));
    check_pairs(scene);
  }
  for (const double size : {0x1p-1000, 0x1p1000})
    for (int i = 0; i < 30; ++i) check_pairs(any_scene(dice, size, 1));
}

TEST_CASE("broad_phase: no pair without two bodies") {
  CHECK(broad_phase(Scene{}).empty());
  Scene one;
  one.bodies = {body(Sphere{1})};
  CHECK(broad_phase(one).empty());
}

}  // namespace
}  // namespace touchstone::fast
