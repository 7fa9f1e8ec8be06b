#include "app/fuzz/scene_numbers.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "model/limits.h"

namespace touchstone::app {
namespace {

class Numbers {
 public:
  void add(double& value, double scale) { all.push_back({&value, scale}); }

  void add(Vec3& v, double scale) {
    for (int i = 0; i < 3; ++i) add(v[i], scale);
  }

  void add(Pose& pose, double size) {
    add(pose.p_WB, size);
    Quaternion& q = pose.q_WB;
    const double length = std::hypot(std::hypot(q.w, q.x), std::hypot(q.y, q.z));
    for (double* component : {&q.w, &q.x, &q.y, &q.z}) add(*component, length);
  }

  void add(Sphere& sphere, double size) { add(sphere.radius, size); }
  void add(Box& box, double size) { add(box.half_extents, size); }
  void add(Polytope& polytope, double size) {
    for (Vec3& vertex : polytope.vertices) add(vertex, size);
  }
  void add(Compound& compound, double size) {
    for (Part& part : compound.parts) {
      add(part.X_BP, size);
      std::visit([&](auto& shape) { add(shape, size); }, part.shape);
    }
  }

  void add(Velocity& velocity) {
    add(velocity.v_WBcm, std::max(1.0, velocity.v_WBcm.stableNorm()));
    add(velocity.w_WB, std::max(1.0, velocity.w_WB.stableNorm()));
  }

  std::vector<SceneNumber> all;
};

}  // namespace

std::vector<SceneNumber> numbers_of(Scene& scene) {
  Numbers numbers;
  const bool moves = scene.contact || scene.motion;
  for (Body& body : scene.bodies) {
    const double body_size = size(body.shape);
    numbers.add(body.X_WB, body_size);
    std::visit([&](auto& shape) { numbers.add(shape, body_size); }, body.shape);
    if (moves) numbers.add(body.velocity);
  }
  return numbers.all;
}

}  // namespace touchstone::app
