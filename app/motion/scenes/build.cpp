#include "app/motion/scenes/build.h"

namespace touchstone::app {

std::vector<Body> room(double side) {
  std::vector<Body> walls;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double at : {-1.0, side + 1}) {
      Vec3 half = Vec3::Constant(side / 2), p = half;
      half[axis] = 1;
      p[axis] = at;
      walls.push_back(fixed_block(half, p));
    }
  }
  return walls;
}

Scene scene_of(const std::string& name, std::vector<Body> bodies, const Setting& setting) {
  Scene scene;
  scene.name = name;
  scene.bodies = std::move(bodies);
  for (Body& body : scene.bodies) body.material = {setting.restitution, setting.friction};
  scene.gravity = Vec3(0, 0, -setting.g);
  scene.motion = Motion{};
  for (int k = 1; k <= setting.samples; ++k) scene.motion->sample_times.push_back(k * setting.step);
  return scene;
}

}  // namespace touchstone::app
