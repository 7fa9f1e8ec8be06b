// The energy, momentum and angular momentum of bodies in motion.
#pragma once

#include <optional>
#include <vector>

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::app {

using Real = long double;
using Real3 = Eigen::Matrix<Real, 3, 1>;

/// The sums over all bodies that are not fixed, in W.
struct Energies {
  Real kinetic = 0;                        ///< ½ m v² + ½ ω·Iω (J)
  Real potential = 0;                      ///< −m g·x, x the centre of mass (J)
  Real3 momentum = Real3::Zero();          ///< m v (N s)
  Real3 angular_momentum = Real3::Zero();  ///< x × m v + Iω, about W's origin (N m s)

  Real energy() const { return kinetic + potential; }
};

/// Computes the energies of one scene in long double, so that its own rounding is negligible.
class EnergyReport {
 public:
  /// Requires a completed scene (reference/validity.h).
  explicit EnergyReport(const Scene& scene);

  /// Requires one state per body.
  Energies at(const std::vector<State>& states) const;
  Energies at_start() const;

 private:
  std::vector<std::optional<MassProperties>> masses_;
  std::vector<State> start_;
  Real3 gravity_;
};

/// The rotation of q/|q|.
Eigen::Matrix<Real, 3, 3> rotation(const Quaternion& q);

/// The states of the bodies at their start times.
std::vector<State> start_of(const Scene& scene);

}  // namespace touchstone::app
