#include <array>
#include <memory>

#include "fast/motion/ballistic_motion.h"
#include "fast/time_of_impact.h"
#include "fast/time_of_impact/first_contact.h"
#include "reference/time_of_impact.h"
#include "tests/bench/time_of_impact/contestant.h"

namespace touchstone::bench {
namespace {

using fast::motion::BallisticMotion;
using fast::motion::RigidBodyModel;

/// Two bodies, each with a density or given mass properties, that fall freely from time 0.
struct Pair {
  explicit Pair(const Scene& given)
      : scene(given), models{RigidBodyModel(given.bodies[0]), RigidBodyModel(given.bodies[1])} {}

  BallisticMotion motion(std::size_t i) const {
    return {models[i], 0, scene.bodies[i].X_WB, scene.bodies[i].velocity, scene.gravity};
  }
  TimeOfImpact first_contact(const BallisticMotion& a, const BallisticMotion& b) const {
    const fast::FirstContact met = fast::first_contact(a, b, 0, scene.motion->sample_times.back());
    TimeOfImpact said;
    said.status = met.status;
    said.time = met.lo;
    said.enclosure = Interval{met.lo, met.hi};
    return said;
  }

  Scene scene;
  std::array<RigidBodyModel, 2> models;
};

Ask with_new_motions(const Scene& scene) {
  return [pair = std::make_shared<Pair>(scene)] { return pair->first_contact(pair->motion(0), pair->motion(1)); };
}

Ask with_kept_motions(const Scene& scene) {
  struct Moving {
    explicit Moving(const Scene& given) : pair(given), a(pair.motion(0)), b(pair.motion(1)) {}
    Pair pair;
    BallisticMotion a, b;
  };
  return [moving = std::make_shared<Moving>(scene)] { return moving->pair.first_contact(moving->a, moving->b); };
}

Ask by_reference(const Scene& scene) {
  return [scene] {
    const reference::TimeOfImpactTruth truth = reference::time_of_impact(scene);
    TimeOfImpact said;
    said.status = truth.status;
    said.time = truth.time.lo;
    said.enclosure = truth.time;
    return said;
  };
}

}  // namespace

std::vector<Entrant> ours() {
  return {{"fast new motions", "ours", with_new_motions}, {"fast kept motions", "ours", with_kept_motions}};
}

std::vector<Entrant> asked_once() {
  return {{"fast", "ours", [](const Scene& scene) { return [scene] { return fast::time_of_impact_of(scene); }; }},
          {"reference", "peer", by_reference}};
}

}  // namespace touchstone::bench
