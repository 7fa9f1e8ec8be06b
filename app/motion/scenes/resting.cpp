// Bodies that stand and must stay at rest.
#include "app/motion/scenes/build.h"
#include "app/motion/scenes/list.h"
#include "app/motion/scenes/truths.h"
#include "reference/validity.h"

namespace touchstone::app {
namespace {

MotionScene resting(const std::string& name, std::vector<Body> bodies, double restitution, double friction) {
  const Scene scene = reference::completed(scene_of(
      name, std::move(bodies), {.restitution = restitution, .friction = friction, .step = 0.25, .samples = 8}));
  return {scene, "stays where it is; relative to its size", off_rest(scene)};
}

std::vector<Body> stack(double ratio) {
  std::vector<Body> bodies{block({1, 1, 1}, {0, 0, 1}), block({1, 1, 1}, {0, 0, 3}), table()};
  bodies[1].mass = Density{ratio};
  return bodies;
}

/// A semicircle of eight stones between radii 2 and 3. Neighbours share the four corners of a face.
std::vector<Body> arch() {
  std::vector<Vec3> rays{{1, 0, 0}, {0, 0, 1}, {-1, 0, 0}};
  for (int halvings = 0; halvings < 2; ++halvings) {
    std::vector<Vec3> finer{rays[0]};
    for (std::size_t k = 1; k < rays.size(); ++k) {
      finer.push_back((rays[k - 1] + rays[k]).normalized());
      finer.push_back(rays[k]);
    }
    rays = finer;
  }
  std::vector<Body> bodies{table()};
  for (std::size_t k = 1; k < rays.size(); ++k) {
    Polytope stone;
    for (const Vec3& ray : {rays[k - 1], rays[k]}) {
      for (const double radius : {2.0, 3.0}) {
        for (const double y : {-1.0, 1.0}) stone.vertices.push_back(radius * ray + Vec3(0, y, 0));
      }
    }
    bodies.push_back(body_of(stone, Vec3::Zero()));
  }
  return bodies;
}

}  // namespace

std::vector<MotionScene> resting_scenes() {
  return {resting("rest_ball_elastic", {ball(0.5, {0, 0, 0.5}), table()}, 1, 0),
          resting("rest_block_elastic", {block({1, 1, 0.5}, {0, 0, 0.5}), table()}, 1, 0.5),
          resting("stack_1_to_100", stack(100), 0, 0.5), resting("stack_1_to_1e6", stack(1e6), 0, 0.5),
          resting("arch", arch(), 0, 0.875)};
}

}  // namespace touchstone::app
