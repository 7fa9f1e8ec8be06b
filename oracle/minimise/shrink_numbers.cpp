// Shorter numbers: all together on a grid, then each on its own, then of size about 1.
#include <algorithm>
#include <cmath>

#include "model/sequence.h"
#include "oracle/minimise/scene_edit.h"
#include "oracle/minimise/shrink.h"

namespace touchstone::oracle::shrink {
namespace {

double greatest(const std::vector<double*>& numbers) {
  double most = 0;
  for (const double* x : numbers) most = std::max(most, std::abs(*x));
  return most;
}

/// Replaces every turned convex body by a polytope that is not turned, with rounded vertices.
void work_in_rotations(Scene& scene) {
  for (const Slot slot : slots(scene)) {
    Body& body = scene.bodies[slot.body];
    if (std::holds_alternative<Compound>(body.shape) || body.X_WB.q_WB == Quaternion{}) continue;
    Polytope polytope{corners(shape_at(scene, slot)), {}};
    const Mat3 R = rounded_rotation(body.X_WB.q_WB);
    body.X_WB.q_WB = {};
    if (polytope.vertices.empty()) continue;
    for (Vec3& v : polytope.vertices) v = (R * v).eval();
    body.shape = polytope;
  }
}

/// Rounds all lengths to multiples of 2^-bits of the power of two of the greatest length.
std::optional<Scene> on_grid(Scene scene, int bits, bool without_rotations) {
  if (without_rotations && is_sequence(scene)) return std::nullopt;  // a sequence's bodies turn
  if (without_rotations) work_in_rotations(scene);
  drop_faces(scene);
  const std::vector<double*> numbers = lengths(scene);
  const double most = greatest(numbers);
  if (most == 0) return std::nullopt;
  const int exponent = bits - 1 - std::ilogb(most);
  for (double* x : numbers) *x = std::ldexp(std::nearbyint(std::ldexp(*x, exponent)), -exponent);
  return scene;
}

double rounded(double x, int bits) {
  if (x == 0 || bits == 0) return 0;
  const int exponent = bits - 1 - std::ilogb(x);
  return std::ldexp(std::nearbyint(std::ldexp(x, exponent)), -exponent);
}

std::vector<double*> all_numbers(Scene& scene) {
  std::vector<double*> all = lengths(scene);
  for (const auto& more : {quaternion_components(scene), mass_numbers(scene), motion_numbers(scene)})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::optional<Scene> with_short_number(Scene scene, std::size_t i, int bits) {
  const std::vector<double*> numbers = all_numbers(scene);
  if (i >= numbers.size() || bits >= significant_bits(*numbers[i])) return std::nullopt;
  *numbers[i] = rounded(*numbers[i], bits);
  drop_faces(scene);
  return scene;
}

void times_power(const std::vector<double*>& numbers, int exponent) {
  for (double* x : numbers) *x = std::ldexp(*x, exponent);
}

std::optional<Scene> unit_lengths(Scene scene) {
  const std::vector<double*> numbers = lengths(scene);
  const double most = greatest(numbers);
  if (most == 0) return std::nullopt;
  times_power(numbers, -std::ilogb(most));
  return scene;
}

std::optional<Scene> unit_velocities(Scene scene) {
  std::vector<double*> numbers;
  for (Body& body : scene.bodies) {
    for (Vec3* v : {&body.velocity.v_WBcm, &body.velocity.w_WB})
      numbers.insert(numbers.end(), {&v->x(), &v->y(), &v->z()});
  }
  const double most = greatest(numbers);
  if (!scene.contact || most == 0) return std::nullopt;
  times_power(numbers, -std::ilogb(most));
  return scene;
}

std::optional<Scene> unit_quaternions(Scene scene) {
  for (Pose* X_WB : poses(scene)) {
    Quaternion& q = X_WB->q_WB;
    const std::vector<double*> numbers = {&q.w, &q.x, &q.y, &q.z};
    times_power(numbers, -std::ilogb(greatest(numbers)));
  }
  return scene;
}

}  // namespace

std::vector<Move> coarser_grids(const Scene&) {
  std::vector<Move> moves;
  for (const int bits : {1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 16, 20, 24, 32, 40}) {
    moves.push_back([bits](const Scene& s) { return on_grid(s, bits, false); });
    moves.push_back([bits](const Scene& s) { return on_grid(s, bits, true); });
  }
  return moves;
}

std::vector<Move> fewer_bits(const Scene& scene) {
  Scene copy = scene;
  const std::vector<double*> numbers = all_numbers(copy);
  std::vector<std::size_t> longest_first(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) longest_first[i] = i;
  std::ranges::stable_sort(longest_first, std::greater{}, [&](std::size_t i) { return significant_bits(*numbers[i]); });
  std::vector<Move> moves;
  for (const std::size_t i : longest_first) {
    for (const int bits : {0, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 40}) {
      if (bits >= significant_bits(*numbers[i])) break;
      moves.push_back([=](const Scene& s) { return with_short_number(s, i, bits); });
    }
  }
  return moves;
}

std::vector<Move> shrink_units(const Scene&) { return {unit_lengths, unit_velocities, unit_quaternions}; }

}  // namespace touchstone::oracle::shrink
