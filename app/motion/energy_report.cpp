#include "app/motion/energy_report.h"

#include <Eigen/Geometry>

#include "reference/mass.h"

namespace touchstone::app {

Eigen::Matrix<Real, 3, 3> rotation(const Quaternion& q) {
  return Eigen::Quaternion<Real>(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
}

std::vector<State> start_of(const Scene& scene) {
  std::vector<State> states;
  for (const Body& body : scene.bodies) states.push_back({body.X_WB, body.velocity});
  return states;
}

EnergyReport::EnergyReport(const Scene& scene) : start_(start_of(scene)), gravity_(scene.gravity.cast<Real>()) {
  for (const auto& truth : reference::mass(scene)) {
    masses_.push_back(truth ? std::optional(reference::nearest(*truth)) : std::nullopt);
  }
}

Energies EnergyReport::at(const std::vector<State>& states) const {
  Energies energies;
  for (std::size_t b = 0; b < masses_.size(); ++b) {
    if (!masses_[b]) continue;
    const auto& [mass, p_BBcm, I_B] = *masses_[b];
    const State& state = states[b];
    const Eigen::Matrix<Real, 3, 3> R = rotation(state.X_WB.q_WB);
    const Real3 x = state.X_WB.p_WB.cast<Real>() + R * p_BBcm.cast<Real>();
    const Real3 v = state.velocity.v_WBcm.cast<Real>();
    const Real3 w_B = R.transpose() * state.velocity.w_WB.cast<Real>();
    const Real3 L_B = I_B.cast<Real>() * w_B;
    energies.kinetic += (mass * v.squaredNorm() + w_B.dot(L_B)) / 2;
    energies.potential -= mass * gravity_.dot(x);
    energies.momentum += mass * v;
    energies.angular_momentum += x.cross(mass * v) + R * L_B;
  }
  return energies;
}

Energies EnergyReport::at_start() const { return at(start_); }

}  // namespace touchstone::app
