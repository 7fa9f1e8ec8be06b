// Prints scenes as the program writes them, one per line, for schema_test.py. Numbers are random bit patterns made
// valid.
#include <algorithm>
#include <iostream>
#include <limits>

#include "model/json.h"
#include "model/limits.h"
#include "tests/model/random_scene.h"

namespace touchstone {
namespace {

double above_zero(double number) { return std::abs(number) + 5e-324; }

void legalise(Sphere& sphere) { sphere.radius = above_zero(sphere.radius); }
void legalise(Box& box) { box.half_extents = box.half_extents.unaryExpr(&above_zero); }
void legalise(Polytope& polytope) {
  polytope = {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1e-300, 0), Vec3(0, 0, 5e-324)}, {}};
}
void legalise(Compound& compound) {
  for (Part& part : compound.parts) std::visit([](auto& shape) { legalise(shape); }, part.shape);
}

void legalise(Density& density) { density.value = above_zero(density.value); }
void legalise(Fixed&) {}
void legalise(MassProperties& given) {
  given.mass = above_zero(given.mass);
  given.I_BBcm_B = Mat3::Identity() * given.mass;
}

void legalise(Contact& contact) {
  contact.nhat_BA_W = contact.p_WC.x() > 0 ? Vec3(0, -1, 0) : Vec3(0.6, 0, 0.8);
  contact.restitution = contact.restitution > 0 ? 5e-324 : 1;
  contact.friction = std::abs(contact.friction);
}

void legalise(Raster& raster) {
  raster.pixel = above_zero(raster.pixel);
  ++raster.columns;
  ++raster.rows;
}

void legalise(Motion& motion, int bodies) {
  for (std::vector<double>* numbers : {&motion.sample_times, &motion.start_times}) {
    for (double& x : *numbers) x = above_zero(x);
    std::sort(numbers->begin(), numbers->end());
  }
  motion.sample_times.erase(std::unique(motion.sample_times.begin(), motion.sample_times.end()),
                            motion.sample_times.end());
  for (double& since : motion.start_times) since = std::min(since, motion.sample_times.front());
  motion.envelope.reset();  // the body may be too small for any envelope
  if (bodies == 0) motion.forces.clear();
  motion.force_bound = std::numeric_limits<double>::max();
  for (AppliedForce& force : motion.forces) force = {above_zero(force.time), force.body % bodies, force.force_W / 4};
  std::ranges::sort(motion.forces, {}, &AppliedForce::time);
}

Scene legal_scene(std::uint64_t seed) {
  Scene scene = tests::random_scene(seed);
  if (scene.bodies.size() != 2) scene.contact.reset();
  if (scene.contact) {
    legalise(*scene.contact);
    scene.bodies[0].mass = Density{};
  }
  if (scene.raster) legalise(*scene.raster);
  if (scene.motion) {
    legalise(*scene.motion, static_cast<int>(scene.bodies.size()));
    for (const AppliedForce& force : scene.motion->forces)
      scene.bodies[static_cast<std::size_t>(force.body)].mass = Density{};
  }
  for (Body& body : scene.bodies) {
    std::visit([](auto& shape) { legalise(shape); }, body.shape);
    std::visit([](auto& mass) { legalise(mass); }, body.mass);
    body.material = {seed % 2 ? 1.0 : 5e-324, std::abs(body.material.friction)};
  }
  std::vector<bool> there(scene.bodies.size(), false);
  for (SequenceFrame& frame : scene.frames) {
    std::erase_if(frame, [&](const Placement& p) { return !p.X_WB && !there[static_cast<std::size_t>(p.body)]; });
    for (const Placement& p : frame) there[static_cast<std::size_t>(p.body)] = p.X_WB.has_value();
  }
  validate(scene);
  return scene;
}

}  // namespace
}  // namespace touchstone

int main() {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    std::cout << touchstone::json_of(touchstone::legal_scene(seed)).dump() << '\n';
  }
}
