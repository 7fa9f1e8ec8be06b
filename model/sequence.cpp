#include "model/sequence.h"

namespace touchstone {

std::vector<Pose*> poses(Scene& scene) {
  std::vector<Pose*> all;
  for (Body& body : scene.bodies) all.push_back(&body.X_WB);
  for (SequenceFrame& frame : scene.frames) {
    for (Placement& placement : frame) {
      if (placement.X_WB) all.push_back(&*placement.X_WB);
    }
  }
  return all;
}

std::vector<Places> places(const Scene& sequence) {
  std::vector<Places> all;
  Places now(sequence.bodies.size());
  for (const SequenceFrame& frame : sequence.frames) {
    for (const Placement& placement : frame) now[static_cast<std::size_t>(placement.body)] = placement.X_WB;
    all.push_back(now);
  }
  return all;
}

Scene snapshot(const Scene& sequence, std::size_t f) {
  const Places there = places(sequence)[f];
  Scene scene;
  for (std::size_t i = 0; i < there.size(); ++i) {
    if (!there[i]) continue;
    scene.bodies.push_back(sequence.bodies[i]);
    scene.bodies.back().X_WB = *there[i];
  }
  return scene;
}

}  // namespace touchstone
