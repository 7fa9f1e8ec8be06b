#include "properties/fuzzing/invent.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include "model/limits.h"
#include "oracle/minimise/scene_edit.h"
#include "properties/scenes/pair.h"
#include "properties/scenes/solids.h"

namespace touchstone::properties::fuzzing {
namespace {

using oracle::Slot;

// Choices: as large as what families draw.
constexpr std::size_t most_parts = 4;
constexpr int most_rows = 64;

Body& one_body(Scene& scene, Random& random) { return scene.bodies[random.index(scene.bodies.size())]; }

double power_of_two(int least, int greatest, Random& random) { return std::exp2(random.between(least, greatest)); }

/// Half the sides of the solid's box, in its own axes.
Vec3 half_extents_of(const ConvexShape& shape) {
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return Vec3::Constant(sphere->radius);
  const std::vector<Vec3> corners = oracle::corners(shape);
  Vec3 lo = corners.front(), hi = lo;
  for (const Vec3& corner : corners) lo = lo.cwiseMin(corner), hi = hi.cwiseMax(corner);
  return (hi - lo) / 2;
}

/// Lattice points times powers of two, so that cocircular ones stay so.
std::vector<Vec3> round_prism(const Vec3& half, Random& random) {
  const int squared_radius = random.pick({5, 25, 65, 325});
  Polytope prism = properties::prism(lattice_circle(squared_radius), -1, 1);
  const double across = std::exp2(std::ilogb(half.head<2>().minCoeff() / std::sqrt(squared_radius)));
  for (Vec3& v : prism.vertices) v = Vec3(across * v.x(), across * v.y(), half.z() * v.z());
  return prism.vertices;
}

ConvexShape solid_of(const Vec3& half, Random& random) {
  const Vec3 x(half.x(), 0, 0), y(0, half.y(), 0), z(0, 0, half.z());
  switch (random.below(6)) {
    case 0:
      return Sphere{half.minCoeff()};
    case 1:
      return Box{half};
    case 2:
      return Polytope{block(-half, half).vertices, {}};
    case 3:
      return Polytope{{x, -x, y, -y, z, -z}, {}};
    case 4:
      return Polytope{{x + y + z, x - y - z, y - x - z, z - x - y}, {}};
    default:
      return Polytope{round_prism(half, random), {}};
  }
}

/// A body that is no compound is its only part.
std::vector<Part> parts_of(const Scene& scene, std::size_t body) {
  if (const auto* compound = std::get_if<Compound>(&scene.bodies[body].shape)) return compound->parts;
  return {{{}, oracle::shape_at(scene, {body, 0})}};
}

MassProperties given_mass(const Body& body, Random& random) {
  const double of_size = size(body.shape);
  MassProperties given;
  given.mass = power_of_two(-4, 4, random);
  if (random.one_in(2)) {
    const int axis = random.below(3);
    const int sign = random.sign();
    given.p_BBcm[axis] = sign * of_size * power_of_two(-8, 0, random);
  }
  const int a = random.between(1, 8), b = random.between(1, 8);
  const int c = random.between(std::max(1, std::abs(a - b)), a + b);  // the triangle inequality
  const double unit = given.mass * of_size * of_size * power_of_two(-3, 3, random);
  given.I_BBcm_B.diagonal() = unit * Vec3(a, b, c);
  if (random.one_in(4)) given.I_BBcm_B(0, 1) = given.I_BBcm_B(1, 0) = unit / 4;
  return given;
}

}  // namespace

Changed other_solid(Scene scene, const Scene&, Random& random) {
  const Slot slot = random.pick(oracle::slots(scene));
  oracle::set_shape(scene, slot, solid_of(half_extents_of(oracle::shape_at(scene, slot)), random));
  return scene;
}

Changed join_part(Scene scene, const Scene& other, Random& random) {
  const Scene& source = random.one_in(2) || other.bodies.empty() ? scene : other;
  Part part{{}, oracle::shape_at(source, random.pick(oracle::slots(source)))};
  const std::size_t body = random.index(scene.bodies.size());
  std::vector<Part> parts = parts_of(scene, body);
  if (parts.size() >= most_parts) return std::nullopt;
  const Part& beside = random.pick(parts);
  const int axis = random.below(3);
  const double face_to_face = half_extents_of(beside.shape)[axis] + half_extents_of(part.shape)[axis];
  part.X_BP.p_WB = beside.X_BP.p_WB;
  const int sign = random.sign();
  part.X_BP.p_WB[axis] += sign * face_to_face * random.pick({1.0, 1.0, 0.5, 2.0});
  if (random.one_in(2)) part.X_BP.q_WB = random.one_in(2) ? axes_quaternion(random) : small_quaternion(random);
  parts.push_back(std::move(part));
  scene.bodies[body].shape = Compound{std::move(parts)};
  return scene;
}

Changed drop_part(Scene scene, const Scene&, Random& random) {
  const std::size_t body = random.index(scene.bodies.size());
  std::vector<Part> parts = parts_of(scene, body);
  if (parts.size() < 2) return std::nullopt;
  parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(random.index(parts.size())));
  scene.bodies[body].shape = Compound{parts};
  if (parts.size() == 1) std::visit([&](const auto& solid) { scene.bodies[body].shape = solid; }, parts.front().shape);
  return scene;
}

Changed other_mass(Scene scene, const Scene&, Random& random) {
  Body& body = one_body(scene, random);
  switch (random.below(4)) {
    case 0:
      body.mass = Fixed{};
      break;
    case 1:
      body.mass = Density{power_of_two(-4, 4, random)};
      break;
    default:
      body.mass = given_mass(body, random);
  }
  return scene;
}

Changed other_normal(Scene scene, const Scene&, Random& random) {
  if (!scene.contact) return std::nullopt;
  const Vec3 n = small_vector(random, 4);
  if (n.isZero(0)) return std::nullopt;
  scene.contact->nhat_BA_W = n / n.norm();
  return scene;
}

Changed other_raster(Scene scene, const Scene&, Random& random) {
  if (!scene.raster) return std::nullopt;
  switch (random.below(4)) {
    case 0:
      scene.raster->columns = random.between(1, most_rows);
      break;
    case 1:
      scene.raster->rows = random.between(1, most_rows);
      break;
    case 2:
      scene.raster->pixel *= power_of_two(-2, 2, random);
      break;
    default:
      scene.raster->shift_x = random.between(-most_rows, most_rows);
      scene.raster->shift_y = random.between(-most_rows, most_rows);
  }
  return scene;
}

Changed other_times(Scene scene, const Scene&, Random& random) {
  if (!scene.motion) return std::nullopt;
  Motion& motion = *scene.motion;
  std::vector<double>& samples = motion.sample_times;
  const double eighth = samples.back() / 8 * random.below(8);
  switch (random.below(4)) {
    case 0:
      if (eighth > 0) samples.insert(std::ranges::upper_bound(samples, eighth), eighth);
      break;
    case 1: {
      const double factor = random.pick({0.5, 2.0});
      for (double& time : samples) time *= factor;
      break;
    }
    case 2:
      motion.start_times.resize(scene.bodies.size());
      motion.start_times[random.index(scene.bodies.size())] = eighth;
      break;
    default:
      motion.envelope.reset();
      if (random.one_in(4)) break;
      motion.envelope = size(one_body(scene, random).shape);
      *motion.envelope *= power_of_two(-40, -11, random);
  }
  return scene;
}

Changed other_forces(Scene scene, const Scene&, Random& random) {
  if (!scene.motion) return std::nullopt;
  Motion& motion = *scene.motion;
  std::vector<AppliedForce>& forces = motion.forces;
  if (!forces.empty() && random.one_in(3)) {
    forces.erase(forces.begin() + static_cast<std::ptrdiff_t>(random.index(forces.size())));
    return scene;
  }
  AppliedForce force;
  if (random.one_in(2)) force.time = motion.sample_times.back() / 8 * random.below(8);
  force.body = random.below(static_cast<int>(scene.bodies.size()));
  const double unit = power_of_two(-4, 4, random);
  force.force_W = unit * small_vector(random, 4);
  motion.force_bound = std::max(motion.force_bound, force.force_W.lpNorm<1>());
  forces.insert(std::ranges::upper_bound(forces, force.time, {}, &AppliedForce::time), force);
  return scene;
}

Changed place(Scene scene, const Scene&, Random& random) {
  if (scene.bodies.empty() || scene.contact || scene.raster || scene.motion) return std::nullopt;
  const int b = random.below(static_cast<int>(scene.bodies.size()));
  std::optional<Pose> last;
  for (const SequenceFrame& frame : scene.frames) {
    for (const Placement& placement : frame) {
      if (placement.body == b) last = placement.X_WB;
    }
  }
  if (scene.frames.empty() || random.one_in(2)) scene.frames.emplace_back();
  SequenceFrame& frame = scene.frames.back();
  if (std::ranges::any_of(frame, [&](const Placement& placement) { return placement.body == b; })) return std::nullopt;
  if (last && random.one_in(3)) {
    frame.push_back({b, {}});
    return scene;
  }
  const Body& body = scene.bodies[static_cast<std::size_t>(b)];
  Pose X_WB = last.value_or(body.X_WB);
  const int axis = random.below(3);
  const int sign = random.sign();
  X_WB.p_WB[axis] += sign * size(body.shape) * power_of_two(-4, 4, random);
  frame.push_back({b, X_WB});
  return scene;
}

}  // namespace touchstone::properties::fuzzing
