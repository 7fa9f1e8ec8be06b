// Blocks that slide, or stick.
#include <algorithm>

#include "app/motion/scenes/build.h"
#include "app/motion/scenes/list.h"
#include "app/motion/scenes/truths.h"

namespace touchstone::app {
namespace {

constexpr Real g = 10;

struct Slope {
  Quaternion q;
  int sine, cosine;  ///< times 5
};

/// The ramp's top is 4 above its middle along its normal (sin α, 0, cos α), the block's middle 5, so they touch
/// exactly.
Scene on_ramp(const std::string& name, const Slope& slope, double mu) {
  Body ramp = fixed_block({64, 8, 4}, Vec3::Zero());
  Body slider = block({2, 2, 1}, Vec3(slope.sine, 0, slope.cosine));
  ramp.X_WB.q_WB = slider.X_WB.q_WB = slope.q;
  return scene_of(name, {slider, ramp}, {.friction = mu, .step = 0.25, .samples = 12});
}

MotionScene sticks(const std::string& name, const Slope& slope, double mu) {
  const Scene scene = on_ramp(name, slope, mu);
  return {scene, "tan α < μ: the block stays where it is; relative to its size", off_rest(scene)};
}

MotionScene slides(const std::string& name, const Slope& slope, double mu) {
  const Scene scene = on_ramp(name, slope, mu);
  const Real sine = Real(slope.sine) / 5, cosine = Real(slope.cosine) / 5;
  const Real a = g * (sine - mu * cosine);
  const Path path = [=, p = scene.bodies[0].X_WB.p_WB](Real t) {
    return Real3(p.cast<Real>() + a * t * t / 2 * Real3(cosine, 0, -sine));
  };
  return {scene, "tan α > μ: a = g(sin α − μ cos α); relative to its size", off_paths(scene, {{0, path}}, 1)};
}

/// The block stops after v₀/(μ g), having moved v₀²/(2 μ g).
MotionScene stops() {
  const double mu = 0.5, v0 = 5;
  const Scene scene = scene_of("sliding_block", {block({2, 2, 1}, {0, 0, 1}, {{v0, 0, 0}, {0, 0, 0}}), table()},
                               {.friction = mu, .step = 0.125, .samples = 16});
  const Path path = [=](Real t) {
    t = std::min(t, v0 / (mu * g));
    return Real3(t * (v0 - mu * g * t / 2), 0, 1);
  };
  return {scene, "stops after v₀²/(2μg); relative to its size", off_paths(scene, {{0, path}}, 1)};
}

}  // namespace

std::vector<MotionScene> sliding_scenes() {
  const Slope gentle{{3, 0, 1, 0}, 3, 4}, steep{{2, 0, 1, 0}, 4, 3};
  return {sticks("ramp_sticks", gentle, 0.875), slides("ramp_slides", gentle, 0.5),
          sticks("ramp_sticks_steep", steep, 10), stops()};
}

}  // namespace touchstone::app
