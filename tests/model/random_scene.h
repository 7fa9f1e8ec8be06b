// Scenes with random shapes whose numbers are random bit patterns: any finite double, including denormals and -0.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "model/scene.h"

namespace touchstone::tests {

/// Steele, Lea & Flood 2014, "Fast splittable pseudorandom number generators": SplitMix64.
class Bits {
 public:
  explicit Bits(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  int below(int end) { return static_cast<int>(next() % static_cast<std::uint64_t>(end)); }

  double finite() {
    double number = std::bit_cast<double>(next());
    while (!std::isfinite(number)) number = std::bit_cast<double>(next());
    return below(16) ? number : std::copysign(below(2) ? 0.0 : 5e-324 * below(9), number);
  }

  Vec3 vec3() { return {finite(), finite(), finite()}; }

 private:
  std::uint64_t state_;
};

inline Pose random_pose(Bits& bits) {
  return {bits.vec3(), {bits.finite(), bits.finite(), bits.finite(), bits.finite()}};
}

inline ConvexShape random_convex(Bits& bits) {
  switch (bits.below(3)) {
    case 0:
      return Sphere{bits.finite()};
    case 1:
      return Box{bits.vec3()};
    default: {
      Polytope polytope;
      for (int i = bits.below(12); i > 0; --i) polytope.vertices.push_back(bits.vec3());
      for (int i = bits.below(5); i > 0; --i)
        polytope.faces.push_back({bits.below(99), bits.below(99), bits.below(99)});
      return polytope;
    }
  }
}

inline Shape random_shape(Bits& bits) {
  if (bits.below(4)) return std::visit([](const auto& convex) -> Shape { return convex; }, random_convex(bits));
  Compound compound;
  for (int i = 1 + bits.below(3); i > 0; --i) compound.parts.push_back({random_pose(bits), random_convex(bits)});
  return compound;
}

inline MassProperties random_mass_properties(Bits& bits) {
  MassProperties mass{bits.finite(), bits.vec3(), {}};
  for (int i = 0; i < 3; ++i) mass.I_BBcm_B.row(i) = bits.vec3().transpose();
  return mass;
}

inline Mass random_mass(Bits& bits) {
  switch (bits.below(3)) {
    case 0:
      return Density{bits.finite()};
    case 1:
      return Fixed{};
    default:
      return random_mass_properties(bits);
  }
}

inline Velocity random_velocity(Bits& bits) { return {bits.vec3(), bits.vec3()}; }

/// Well formed, but valid only by chance.
inline Scene random_scene(std::uint64_t seed) {
  Bits bits(seed);
  Scene scene{bits.below(2) ? "" : "scene \"\\\n\u00e9", {}, bits.vec3()};
  for (int i = bits.below(4); i > 0; --i) {
    scene.bodies.push_back({bits.below(2) ? "" : "body",
                            random_shape(bits),
                            random_pose(bits),
                            random_velocity(bits),
                            {bits.finite(), bits.finite()},
                            random_mass(bits)});
  }
  for (int i = bits.below(3); i > 0; --i) {
    SequenceFrame& frame = scene.frames.emplace_back();
    for (int body = 0; body < static_cast<int>(scene.bodies.size()); ++body) {
      if (bits.below(3)) frame.push_back({body, bits.below(4) ? std::optional(random_pose(bits)) : std::nullopt});
    }
  }
  if (bits.below(2)) {
    scene.contact = {bits.vec3(), bits.vec3(), static_cast<Law>(bits.below(3)), bits.finite(),
                     bits.below(4) ? bits.finite() : std::numeric_limits<double>::infinity()};
  }
  if (bits.below(2)) {
    scene.raster = {bits.finite(),  bits.finite(),       bits.finite(),      bits.below(99),
                    bits.below(99), bits.below(99) - 50, bits.below(99) - 50};
  }
  if (bits.below(2)) {
    Motion& motion = scene.motion.emplace();
    for (int i = bits.below(4); i >= 0; --i) motion.sample_times.push_back(bits.finite());
    if (bits.below(2)) motion.start_times.assign(scene.bodies.size(), bits.finite());
    if (bits.below(2)) motion.envelope = bits.finite();
    motion.law = static_cast<Law>(bits.below(3));
    if (bits.below(2)) motion.force_bound = bits.finite();
    for (int i = bits.below(3); i > 0; --i) motion.forces.push_back({bits.finite(), bits.below(4), bits.vec3()});
  }
  return scene;
}

}  // namespace touchstone::tests
