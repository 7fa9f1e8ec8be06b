// Simpler poses: at the origin, not turned, or turned by few bits.
#include <cmath>

#include "model/sequence.h"
#include "oracle/minimise/scene_edit.h"
#include "oracle/minimise/shrink.h"

namespace touchstone::oracle::shrink {
namespace {

std::optional<Scene> body_at_origin(Scene scene, std::size_t i) {
  if (i >= scene.bodies.size()) return std::nullopt;
  const Vec3 origin = scene.bodies[i].X_WB.p_WB;
  for (Body& body : scene.bodies) body.X_WB.p_WB -= origin;
  if (scene.contact) scene.contact->p_WC -= origin;
  return scene;
}

Quaternion relative(const Quaternion& q, const Quaternion& r) {  // conj(q) r
  return {q.w * r.w + q.x * r.x + q.y * r.y + q.z * r.z, q.w * r.x - q.x * r.w - q.y * r.z + q.z * r.y,
          q.w * r.y + q.x * r.z - q.y * r.w - q.z * r.x, q.w * r.z - q.x * r.y + q.y * r.x - q.z * r.w};
}

/// Turns the world so that body i is not turned; the others keep their poses relative to it.
std::optional<Scene> seen_from(Scene scene, std::size_t i) {
  if (i >= scene.bodies.size() || scene.contact) return std::nullopt;  // a normal would be rounded
  const Quaternion q = scene.bodies[i].X_WB.q_WB;
  const Mat3 back = rounded_rotation(q).transpose();
  for (Body& body : scene.bodies) {
    const bool same = body.X_WB.q_WB == q;
    body.X_WB.p_WB = (back * body.X_WB.p_WB).eval();
    body.X_WB.q_WB = same ? Quaternion{} : relative(q, body.X_WB.q_WB);
  }
  return scene;
}

std::optional<Scene> not_turned(Scene scene, std::size_t i) {
  if (i >= scene.bodies.size()) return std::nullopt;
  scene.bodies[i].X_WB.q_WB = {};
  return scene;
}

std::optional<Scene> none_turned(Scene scene) {
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) scene.bodies[k].X_WB.q_WB = {};
  return scene;
}

/// Rounds the quaternion's components to multiples of 2^-bits of the largest.
std::optional<Scene> turned_by_few_bits(Scene scene, std::size_t i, int bits) {
  if (i >= scene.bodies.size()) return std::nullopt;
  Quaternion& q = scene.bodies[i].X_WB.q_WB;
  const double largest = std::max({std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)});
  const auto few = [=](double x) { return std::nearbyint(std::ldexp(x / largest, bits)); };
  q = {few(q.w), few(q.x), few(q.y), few(q.z)};
  return scene;
}

}  // namespace

std::vector<Move> shrink_poses(const Scene& scene) {
  if (is_sequence(scene)) return {};  // shrink_places has the poses of a sequence
  std::vector<Move> moves = {none_turned};
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    moves.push_back([i](const Scene& s) { return body_at_origin(s, i); });
    moves.push_back([i](const Scene& s) { return seen_from(s, i); });
    moves.push_back([i](const Scene& s) { return not_turned(s, i); });
    for (const int bits : {0, 1, 2, 3, 4, 6}) {
      moves.push_back([=](const Scene& s) { return turned_by_few_bits(s, i, bits); });
    }
  }
  return moves;
}

}  // namespace touchstone::oracle::shrink
