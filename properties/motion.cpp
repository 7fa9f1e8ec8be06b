#include "properties/motion.h"

#include <algorithm>
#include <cmath>

#include "model/film.h"
#include "oracle/tolerance.h"
#include "properties/exact_sum.h"

namespace touchstone::properties {
namespace {

bool translate(Scene& scene, const Vec3& t) {
  for (Pose* X_WB : poses(scene)) {
    const std::optional<Vec3> p = exact_sum(X_WB->p_WB, t);
    if (!p) return false;
    X_WB->p_WB = *p;
  }
  return true;
}

std::optional<Quaternion> turned(const Quaternion& q) {
  const auto w = exact_sum({q.w, -q.x, -q.y, -q.z}), x = exact_sum({q.w, q.x, -q.y, q.z});
  const auto y = exact_sum({q.w, q.x, q.y, -q.z}), z = exact_sum({q.w, -q.x, q.y, q.z});
  if (!w || !x || !y || !z) return std::nullopt;
  return Quaternion{*w, *x, *y, *z};
}

// Whether there is anything to relabel.
bool relabel(Sphere&) { return false; }
bool relabel(Box&) { return false; }
bool relabel(Polytope& polytope) {
  std::ranges::reverse(polytope.vertices);
  const int last = static_cast<int>(polytope.vertices.size()) - 1;
  for (std::vector<int>& face : polytope.faces) {
    for (int& i : face) i = last - i;
  }
  std::ranges::reverse(polytope.faces);
  return true;
}
bool relabel(Compound& compound) {
  bool any = false;
  for (Part& part : compound.parts) any |= std::visit([](auto& shape) { return relabel(shape); }, part.shape);
  return any;
}

// One length: times 2^k, and whether that can be undone.
bool scale(double& length, int k) {
  const double before = length;
  length = std::ldexp(before, k);
  return std::isfinite(length) && std::ldexp(length, -k) == before;
}
bool scale(Vec3& v, int k) {
  return std::all_of(v.data(), v.data() + 3, [k](double& x) { return scale(x, k); });
}
bool scale(Sphere& sphere, int k) { return scale(sphere.radius, k); }
bool scale(Box& box, int k) { return scale(box.half_extents, k); }
bool scale(Polytope& polytope, int k) {
  return std::ranges::all_of(polytope.vertices, [k](Vec3& v) { return scale(v, k); });
}
bool scale(Compound& compound, int k) {
  return std::ranges::all_of(compound.parts, [k](Part& part) {
    return scale(part.X_BP.p_WB, k) && std::visit([k](auto& shape) { return scale(shape, k); }, part.shape);
  });
}

}  // namespace

Scene swapped(Scene scene) {
  std::ranges::reverse(scene.bodies);
  const int last = static_cast<int>(scene.bodies.size()) - 1;
  for (Frame& frame : scene.frames) {
    for (Placement& placement : frame) placement.body = last - placement.body;
  }
  return scene;
}

std::optional<Scene> relabelled(Scene scene) {
  bool any = false;
  for (Body& body : scene.bodies) any |= std::visit([](auto& shape) { return relabel(shape); }, body.shape);
  return any ? std::optional(scene) : std::nullopt;
}

std::optional<Scene> translated(const Scene& scene) {
  if (scene.bodies.empty()) return std::nullopt;
  const double step = std::exp2(std::ceil(std::log2(oracle::tolerance::scale(scene))));
  for (const Vec3& t : {Vec3(step * Vec3(3, -5, 1)), Vec3(-scene.bodies.front().X_WB.p_WB)}) {
    Scene moved = scene;
    if (t != Vec3::Zero() && translate(moved, t)) return moved;
  }
  return std::nullopt;
}

Vec3 translation_between(const Scene& before, const Scene& after) {
  if (before.bodies.empty()) return Vec3::Zero();
  return after.bodies.front().X_WB.p_WB - before.bodies.front().X_WB.p_WB;
}

Vec3 turned(const Vec3& p) { return {p.z(), p.x(), p.y()}; }

std::optional<Pose> turned(const Pose& X) {
  const std::optional<Quaternion> q = turned(X.q_WB);
  if (!q) return std::nullopt;
  return Pose{turned(X.p_WB), *q};
}

std::optional<Scene> turned(const Scene& scene) {
  Scene moved = scene;
  for (Pose* X_WB : poses(moved)) {
    const std::optional<Pose> X = turned(*X_WB);
    if (!X) return std::nullopt;
    *X_WB = *X;
  }
  for (Body& body : moved.bodies) {
    body.velocity = {turned(body.velocity.v_WBcm), turned(body.velocity.w_WB)};
  }
  moved.gravity = turned(moved.gravity);
  return moved;
}

Scene half_turned(Scene scene) {
  const auto half = [](const Vec3& v) { return Vec3(v.x(), -v.y(), -v.z()); };
  for (Pose* X_WB : poses(scene)) {
    const Quaternion q = X_WB->q_WB;
    *X_WB = {half(X_WB->p_WB), {-q.x, q.w, -q.z, q.y}};  // (0,1,0,0) q
  }
  for (Body& body : scene.bodies) {
    body.velocity = {half(body.velocity.v_WBcm), half(body.velocity.w_WB)};
  }
  scene.gravity = half(scene.gravity);
  return scene;
}

std::optional<Scene> scaled(Scene scene, int k) {
  for (Pose* X_WB : poses(scene)) {
    if (!scale(X_WB->p_WB, k)) return std::nullopt;
  }
  for (Body& body : scene.bodies) {
    const bool exact = scale(body.velocity.v_WBcm, k) &&
                       std::visit([k](auto& shape) { return scale(shape, k); }, body.shape);
    if (!exact) return std::nullopt;
  }
  if (!scale(scene.gravity, k)) return std::nullopt;
  return scene;
}

}  // namespace touchstone::properties
