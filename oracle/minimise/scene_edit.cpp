#include "oracle/minimise/scene_edit.h"

#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>
#include <variant>

#include "model/box_vertices.h"
#include "model/parts.h"
#include "model/sequence.h"
#include "oracle/truth/truth.h"

namespace touchstone::oracle {
namespace {

void add(std::vector<double*>& numbers, Vec3& v) {
  for (double& x : v) numbers.push_back(&x);
}

void add(std::vector<double*>& numbers, Sphere& sphere) { numbers.push_back(&sphere.radius); }
void add(std::vector<double*>& numbers, Box& box) { add(numbers, box.half_extents); }
void add(std::vector<double*>& numbers, Polytope& polytope) {
  for (Vec3& v : polytope.vertices) add(numbers, v);
}
void add(std::vector<double*>& numbers, Compound& compound) {
  for (Part& part : compound.parts) {
    add(numbers, part.X_BP.p_WB);
    std::visit([&](auto& shape) { add(numbers, shape); }, part.shape);
  }
}

void add(std::vector<double*>& numbers, Quaternion& q) {
  for (double* x : {&q.w, &q.x, &q.y, &q.z}) numbers.push_back(x);
}

void add(std::vector<double*>& numbers, Vec3& gravity, Motion& motion, std::vector<Body>& bodies) {
  add(numbers, gravity);
  for (std::vector<double>* times : {&motion.sample_times, &motion.start_times}) {
    for (double& t : *times) numbers.push_back(&t);
  }
  if (motion.envelope) numbers.push_back(&*motion.envelope);
  for (AppliedForce& applied : motion.forces) {
    numbers.push_back(&applied.time);
    add(numbers, applied.force_W);
  }
  for (Body& body : bodies) numbers.insert(numbers.end(), {&body.material.restitution, &body.material.friction});
}

/// The poses of a sequence.
std::vector<Pose*> placed(Scene& scene) {
  std::vector<Pose*> all = poses(scene);
  all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(scene.bodies.size()));
  return all;
}

}  // namespace

std::vector<Slot> slots(const Scene& scene) {
  std::vector<Slot> all;
  for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
    for (int part = 0; part < part_count(scene.bodies[body]); ++part) all.push_back({body, part});
  }
  return all;
}

ConvexShape shape_at(const Scene& scene, Slot slot) {
  const Shape& shape = scene.bodies[slot.body].shape;
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return *sphere;
  if (const auto* box = std::get_if<Box>(&shape)) return *box;
  if (const auto* polytope = std::get_if<Polytope>(&shape)) return *polytope;
  return std::get<Compound>(shape).parts[static_cast<std::size_t>(slot.part)].shape;
}

void set_shape(Scene& scene, Slot slot, const ConvexShape& shape) {
  Shape& old = scene.bodies[slot.body].shape;
  if (auto* compound = std::get_if<Compound>(&old)) {
    compound->parts[static_cast<std::size_t>(slot.part)].shape = shape;
  } else {
    std::visit([&old](const auto& convex) { old = convex; }, shape);
  }
}

std::vector<Vec3> corners(const ConvexShape& shape) {
  if (const auto* polytope = std::get_if<Polytope>(&shape)) return polytope->vertices;
  if (const auto* box = std::get_if<Box>(&shape)) return vertices_of(*box);
  return {};
}

std::vector<double*> lengths(Scene& scene) {
  std::vector<double*> numbers;
  for (Body& body : scene.bodies) {
    add(numbers, body.X_WB.p_WB);
    std::visit([&](auto& shape) { add(numbers, shape); }, body.shape);
  }
  for (Pose* X_WB : placed(scene)) add(numbers, X_WB->p_WB);
  if (scene.raster) numbers.insert(numbers.end(), {&scene.raster->x, &scene.raster->y, &scene.raster->pixel});
  if (scene.contact) add(numbers, scene.contact->p_WC);
  return numbers;
}

std::vector<double*> quaternion_components(Scene& scene) {
  std::vector<double*> numbers;
  for (Body& body : scene.bodies) {
    add(numbers, body.X_WB.q_WB);
    if (auto* compound = std::get_if<Compound>(&body.shape)) {
      for (Part& part : compound->parts) add(numbers, part.X_BP.q_WB);
    }
  }
  for (Pose* X_WB : placed(scene)) add(numbers, X_WB->q_WB);
  return numbers;
}

std::vector<double*> mass_numbers(Scene& scene) {
  std::vector<double*> numbers;
  for (Body& body : scene.bodies) {
    if (auto* density = std::get_if<Density>(&body.mass)) numbers.push_back(&density->value);
    if (auto* given = std::get_if<MassProperties>(&body.mass)) {
      numbers.push_back(&given->mass);
      add(numbers, given->p_BBcm);
    }
  }
  return numbers;
}

std::vector<double*> motion_numbers(Scene& scene) {
  std::vector<double*> numbers;
  if (!scene.contact && !scene.motion) return numbers;
  if (scene.contact) numbers.push_back(&scene.contact->restitution);
  if (scene.contact && std::isfinite(scene.contact->friction)) numbers.push_back(&scene.contact->friction);
  if (scene.motion) add(numbers, scene.gravity, *scene.motion, scene.bodies);
  for (Body& body : scene.bodies) {
    add(numbers, body.velocity.v_WBcm);
    add(numbers, body.velocity.w_WB);
    auto* given = std::get_if<MassProperties>(&body.mass);
    for (Eigen::Index i = 0; given != nullptr && i < 3; ++i) numbers.push_back(&given->I_BBcm_B(i, i));
  }
  return numbers;
}

void drop_faces(Scene& scene) {
  for (const Slot slot : slots(scene)) {
    ConvexShape shape = shape_at(scene, slot);
    if (auto* polytope = std::get_if<Polytope>(&shape)) {
      polytope->faces.clear();
      set_shape(scene, slot, shape);
    }
  }
}

Scene with_faces(Scene scene) {
  for (const Slot slot : slots(scene)) {
    const ConvexShape shape = shape_at(scene, slot);
    const auto* polytope = std::get_if<Polytope>(&shape);
    if (polytope && polytope->faces.empty()) set_shape(scene, slot, truth::convex_hull(polytope->vertices));
  }
  return truth::completed(std::move(scene));
}

Mat3 rounded_rotation(const Quaternion& q) {
  // Divides by the largest component first, so that no square overflows or vanishes.
  const Eigen::Vector4d all(q.w, q.x, q.y, q.z);
  const Eigen::Vector4d unit = (all / all.cwiseAbs().maxCoeff()).normalized();
  return Eigen::Quaterniond(unit[0], unit[1], unit[2], unit[3]).toRotationMatrix();
}

int significant_bits(double x) {
  if (x == 0 || !std::isfinite(x)) return 0;
  int exponent = 0;
  const auto mantissa = static_cast<std::uint64_t>(std::ldexp(std::abs(std::frexp(x, &exponent)), 53));
  return 53 - std::countr_zero(mantissa);
}

}  // namespace touchstone::oracle
