#include "properties/transforms/body.h"

#include <algorithm>
#include <cmath>

#include "oracle/tolerance/tolerance.h"
#include "properties/transforms/exact_sum.h"
#include "properties/transforms/scene.h"

namespace touchstone::properties {
namespace {

bool turn(Sphere&) { return true; }
bool turn(Box& box) {
  box.half_extents = turned(box.half_extents);
  return true;
}
bool turn(Polytope& polytope) {
  for (Vec3& v : polytope.vertices) v = turned(v);
  return true;
}
bool turn(Compound& compound) {
  return std::ranges::all_of(compound.parts, [](Part& part) {
    const std::optional<Pose> X = turned(part.X_BP);
    if (X) part.X_BP = *X;
    return X.has_value();
  });
}

bool shift(Vec3& p, const Vec3& t) {
  const std::optional<Vec3> sum = exact_sum(p, t);
  if (sum) p = *sum;
  return sum.has_value();
}
bool shift(Polytope& polytope, const Vec3& t) {
  return std::ranges::all_of(polytope.vertices, [&](Vec3& v) { return shift(v, t); });
}
bool shift(Compound& compound, const Vec3& t) {
  return std::ranges::all_of(compound.parts, [&](Part& part) { return shift(part.X_BP.p_WB, t); });
}
template <class Centred>
bool shift(Centred&, const Vec3&) {
  return false;
}

}  // namespace

std::optional<Scene> turned_in_body(Scene scene) {
  for (Body& body : scene.bodies) {
    if (!std::visit([](auto& shape) { return turn(shape); }, body.shape)) return std::nullopt;
  }
  return scene;
}

Vec3 shift_in_body(const Body& body) {
  return std::exp2(std::ceil(std::log2(oracle::tolerance::radius(body)))) * Vec3(1, -2, 3);
}

std::optional<Scene> shifted_in_body(Scene scene) {
  for (Body& body : scene.bodies) {
    const Vec3 t = shift_in_body(body);
    if (!std::visit([&](auto& shape) { return shift(shape, t); }, body.shape)) return std::nullopt;
  }
  return scene;
}

std::optional<Scene> denser(Scene scene, int k) {
  for (Body& body : scene.bodies) {
    Density* density = std::get_if<Density>(&body.mass);
    if (density == nullptr) continue;
    const double before = density->value;
    density->value = std::ldexp(before, k);
    if (!std::isfinite(density->value) || std::ldexp(density->value, -k) != before) return std::nullopt;
  }
  return scene;
}

}  // namespace touchstone::properties
