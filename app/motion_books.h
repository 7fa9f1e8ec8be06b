// What bodies in motion carry: energy, momentum, angular momentum.
#pragma once

#include <optional>
#include <vector>

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::app {

using Real = long double;
using Real3 = Eigen::Matrix<Real, 3, 1>;

/// Of all bodies that are not fixed, in W.
struct Books {
  Real kinetic = 0;                        ///< ½ m v² + ½ ω·Iω (J)
  Real potential = 0;                      ///< −m g·x, x the centre of mass (J)
  Real3 momentum = Real3::Zero();          ///< m v (N s)
  Real3 angular_momentum = Real3::Zero();  ///< x × m v + Iω, about W's origin (N m s)

  Real energy() const { return kinetic + potential; }
};

/// Keeps the books of one scene, in long double: what it adds to the error of what is booked is nothing to speak of.
class BookKeeper {
 public:
  /// Requires a completed scene (reference/validity.h).
  explicit BookKeeper(const Scene& scene);

  /// Requires a state a body.
  Books at(const std::vector<State>& states) const;
  Books at_start() const;

 private:
  std::vector<std::optional<MassProperties>> masses_;
  std::vector<State> start_;
  Real3 gravity_;
};

/// The rotation of q/|q|.
Eigen::Matrix<Real, 3, 3> rotation(const Quaternion& q);

/// Where the bodies stand at first.
std::vector<State> start_of(const Scene& scene);

}  // namespace touchstone::app
