#include "properties/transforms/scene.h"

#include <algorithm>
#include <cmath>

#include "model/sequence.h"
#include "oracle/tolerance/tolerance.h"
#include "properties/transforms/exact_sum.h"
#include "properties/transforms/raster.h"

namespace touchstone::properties {
namespace {

bool translate(Scene& scene, const Vec3& t) {
  for (Pose* X_WB : poses(scene)) {
    const std::optional<Vec3> p = exact_sum(X_WB->p_WB, t);
    if (!p) return false;
    X_WB->p_WB = *p;
  }
  if (scene.raster) {
    scene.raster = translated(*scene.raster, t);
    if (!scene.raster) return false;
  }
  if (!scene.contact) return true;
  const std::optional<Vec3> p = exact_sum(scene.contact->p_WC, t);
  if (p) scene.contact->p_WC = *p;
  return p.has_value();
}

std::optional<Quaternion> turned(const Quaternion& q) {
  const auto w = exact_sum({q.w, -q.x, -q.y, -q.z}), x = exact_sum({q.w, q.x, -q.y, q.z});
  const auto y = exact_sum({q.w, q.x, q.y, -q.z}), z = exact_sum({q.w, -q.x, q.y, q.z});
  if (!w || !x || !y || !z) return std::nullopt;
  return Quaternion{*w, *x, *y, *z};
}

std::vector<AppliedForce*> applied_forces(Scene& scene) {
  std::vector<AppliedForce*> all;
  if (!scene.motion) return all;
  for (AppliedForce& applied : scene.motion->forces) all.push_back(&applied);
  return all;
}

// Returns whether there is anything to relabel.
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

// Multiplies one length by 2^k. Returns whether that can be undone.
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

bool scale(Density&, int) { return true; }
bool scale(Fixed&, int) { return true; }
bool scale(MassProperties& given, int k) {
  double* I = given.I_BBcm_B.data();
  return scale(given.mass, 3 * k) && scale(given.p_BBcm, k) &&
         std::all_of(I, I + 9, [k](double& x) { return scale(x, 5 * k); });
}

}  // namespace

Scene swapped(Scene scene) {
  std::ranges::reverse(scene.bodies);
  const int last = static_cast<int>(scene.bodies.size()) - 1;
  for (SequenceFrame& frame : scene.frames) {
    for (Placement& placement : frame) placement.body = last - placement.body;
  }
  if (scene.contact) scene.contact->nhat_BA_W = -scene.contact->nhat_BA_W;
  if (scene.raster) scene.raster = with_opposite_shift(*scene.raster);
  if (scene.motion) std::ranges::reverse(scene.motion->start_times);
  for (AppliedForce* applied : applied_forces(scene)) applied->body = last - applied->body;
  return scene;
}

std::optional<Scene> relabelled(Scene scene) {
  bool any = false;
  for (Body& body : scene.bodies) any |= std::visit([](auto& shape) { return relabel(shape); }, body.shape);
  return any ? std::optional(scene) : std::nullopt;
}

std::optional<Scene> relabelled_with_parts(Scene scene) {
  bool any = false;
  for (Body& body : scene.bodies) {
    auto* compound = std::get_if<Compound>(&body.shape);
    if (compound == nullptr || compound->parts.size() < 2) continue;
    std::ranges::reverse(compound->parts);
    any = true;
  }
  std::optional<Scene> vertices = relabelled(scene);
  return vertices || !any ? vertices : std::optional(scene);
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
  moved.raster.reset();
  for (Pose* X_WB : poses(moved)) {
    const std::optional<Pose> X = turned(*X_WB);
    if (!X) return std::nullopt;
    *X_WB = *X;
  }
  for (Body& body : moved.bodies) {
    body.velocity = {turned(body.velocity.v_WBcm), turned(body.velocity.w_WB)};
  }
  moved.gravity = turned(moved.gravity);
  for (AppliedForce* applied : applied_forces(moved)) applied->force_W = turned(applied->force_W);
  if (moved.contact) {
    moved.contact->p_WC = turned(moved.contact->p_WC);
    moved.contact->nhat_BA_W = turned(moved.contact->nhat_BA_W);
  }
  return moved;
}

Scene half_turned(Scene scene) {
  scene.raster.reset();
  const auto half = [](const Vec3& v) { return Vec3(v.x(), -v.y(), -v.z()); };
  for (Pose* X_WB : poses(scene)) {
    const Quaternion q = X_WB->q_WB;
    *X_WB = {half(X_WB->p_WB), {-q.x, q.w, -q.z, q.y}};  // (0,1,0,0) q
  }
  for (Body& body : scene.bodies) {
    body.velocity = {half(body.velocity.v_WBcm), half(body.velocity.w_WB)};
  }
  scene.gravity = half(scene.gravity);
  for (AppliedForce* applied : applied_forces(scene)) applied->force_W = half(applied->force_W);
  if (scene.contact) {
    scene.contact->p_WC = half(scene.contact->p_WC);
    scene.contact->nhat_BA_W = half(scene.contact->nhat_BA_W);
  }
  return scene;
}

// With S the mirror, the body's frame is mirrored too: S R S turns it, so (w, x, y, z) → (w, x, −y, −z). Spheres and
// boxes are their own mirror images. Products of inertia with one factor x change sign.
std::optional<Scene> mirrored(Scene scene) {
  scene.raster.reset();
  const auto polar = [](const Vec3& v) { return Vec3(-v.x(), v.y(), v.z()); };
  for (Pose* X_WB : poses(scene)) {
    const Quaternion q = X_WB->q_WB;
    *X_WB = {polar(X_WB->p_WB), {q.w, q.x, -q.y, -q.z}};
  }
  for (Body& body : scene.bodies) {
    if (std::holds_alternative<Polytope>(body.shape) || std::holds_alternative<Compound>(body.shape))
      return std::nullopt;
    body.velocity = {polar(body.velocity.v_WBcm), -polar(body.velocity.w_WB)};
    auto* given = std::get_if<MassProperties>(&body.mass);
    if (given == nullptr) continue;
    given->p_BBcm = polar(given->p_BBcm);
    for (const auto& [i, j] : {std::pair(0, 1), {1, 0}, {0, 2}, {2, 0}}) given->I_BBcm_B(i, j) = -given->I_BBcm_B(i, j);
  }
  scene.gravity = polar(scene.gravity);
  for (AppliedForce* applied : applied_forces(scene)) applied->force_W = polar(applied->force_W);
  if (scene.contact) {
    scene.contact->p_WC = polar(scene.contact->p_WC);
    scene.contact->nhat_BA_W = polar(scene.contact->nhat_BA_W);
  }
  return scene;
}

std::optional<Scene> boosted(Scene scene) {
  double fastest = 0;
  for (const Body& body : scene.bodies) {
    if (std::holds_alternative<Fixed>(body.mass)) return std::nullopt;
    fastest = std::max(fastest, body.velocity.v_WBcm.cwiseAbs().maxCoeff());
  }
  if (fastest == 0) fastest = 1;
  const Vec3 v = std::exp2(std::ceil(std::log2(fastest))) * Vec3(2, -1, 3);
  for (Body& body : scene.bodies) {
    const std::optional<Vec3> sum = exact_sum(body.velocity.v_WBcm, v);
    if (!sum) return std::nullopt;
    body.velocity.v_WBcm = *sum;
  }
  return scene;
}

std::optional<Scene> sped_up(Scene scene, int k) {
  for (Body& body : scene.bodies) {
    if (!scale(body.velocity.v_WBcm, k) || !scale(body.velocity.w_WB, k)) return std::nullopt;
  }
  return scene;
}

std::optional<Scene> scaled(Scene scene, int k) {
  for (Pose* X_WB : poses(scene)) {
    if (!scale(X_WB->p_WB, k)) return std::nullopt;
  }
  for (Body& body : scene.bodies) {
    const auto each = [k](auto& alternative) { return scale(alternative, k); };
    const bool exact = scale(body.velocity.v_WBcm, k) && std::visit(each, body.shape) && std::visit(each, body.mass);
    if (!exact) return std::nullopt;
  }
  if (scene.contact && !scale(scene.contact->p_WC, k)) return std::nullopt;
  if (!scale(scene.gravity, k)) return std::nullopt;
  if (scene.motion && scene.motion->envelope && !scale(*scene.motion->envelope, k)) return std::nullopt;
  if (scene.motion && !scale(scene.motion->force_bound, 4 * k)) return std::nullopt;
  for (AppliedForce* applied : applied_forces(scene)) {
    if (!scale(applied->force_W, 4 * k)) return std::nullopt;
  }
  if (scene.raster) {
    scene.raster = scaled(*scene.raster, k);
    if (!scene.raster) return std::nullopt;
  }
  return scene;
}

}  // namespace touchstone::properties
