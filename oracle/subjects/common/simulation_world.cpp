#include "oracle/subjects/common/simulation_world.h"

#include <algorithm>
#include <cmath>

#include "oracle/subjects/common/impact_input.h"

namespace touchstone::oracle::subjects {
namespace {

bool is_ball(const Body& body) {
  const auto* given = std::get_if<MassProperties>(&body.mass);
  return std::holds_alternative<Sphere>(body.shape) && (given == nullptr || given->p_BBcm.isZero(0));
}

/// A ball's contact normal passes through its centre, so K_tn = 0.
bool all_laws_agree(const Body& a, const Body& b) {
  if (std::min(a.material.restitution, b.material.restitution) == 0) return true;
  if (std::min(a.material.friction, b.material.friction) == 0) return true;
  return (is_fixed(a) || is_ball(a)) && (is_fixed(b) || is_ball(b));
}

bool all_laws_agree(const Scene& scene) {
  for (std::size_t a = 0; a < scene.bodies.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (!all_laws_agree(scene.bodies[a], scene.bodies[b])) return false;
    }
  }
  return true;
}

bool is_weighed(const Body& body) {
  return !std::holds_alternative<Density>(body.mass) || std::holds_alternative<Sphere>(body.shape) ||
         std::holds_alternative<Box>(body.shape);
}

/// All sample times and times of applied forces, sorted, each once.
std::vector<double> instants(const Motion& motion) {
  std::vector<double> all = motion.sample_times;
  for (const AppliedForce& force : motion.forces) all.push_back(force.time);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace

std::optional<Abstains> no_such_motion(const Scene& scene, Law law) {
  if (!scene.motion) return Abstains{"no motion"};
  const Motion& motion = *scene.motion;
  if (std::ranges::any_of(motion.start_times, [](double time) { return time != 0; }))
    return Abstains{"start times other than 0 are not offered"};
  if (motion.law != law && !all_laws_agree(scene)) return Abstains{"this impact law is not offered"};
  if (!std::ranges::all_of(scene.bodies, is_weighed))
    return Abstains{"the mass of hulls and compounds is not computed"};
  return std::nullopt;
}

Trajectory follow(const Scene& scene, double dt, SimulationWorld& world) {
  const Motion& motion = *scene.motion;
  std::vector<Vec3> forces(scene.bodies.size(), Vec3::Zero());
  Trajectory said;
  auto force = motion.forces.begin();
  double now = 0;
  for (const double next : instants(motion)) {
    const double steps = std::ceil((next - now) / dt), step = (next - now) / steps;
    for (double i = 0; i < steps; ++i) world.step(step, forces);
    now = next;
    if (said.states.size() < motion.sample_times.size() && motion.sample_times[said.states.size()] == now) {
      said.states.emplace_back();
      for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
        said.states.back().push_back(world.state(static_cast<int>(body)));
      }
    }
    for (; force != motion.forces.end() && force->time == now; ++force) {
      forces[static_cast<std::size_t>(force->body)] = force->force_W;
    }
  }
  return said;
}

Pose pose_of_body(const Vec3& p_WE, const Eigen::Quaterniond& q_WE, const Pose& X_BE) {
  const Eigen::Quaterniond q_WB = q_WE * rotation(X_BE.q_WB).conjugate();
  return {p_WE - q_WB * X_BE.p_WB, {q_WB.w(), q_WB.x(), q_WB.y(), q_WB.z()}};
}

}  // namespace touchstone::oracle::subjects
