// Linear momentum on a grid, so that its total keeps every bit.
#pragma once

#include "fast/simulation/world.h"

namespace touchstone::fast::simulation {

/// Momenta and impulses are rounded to multiples of a power of two, so that their sums are exact. It is 2^-50 to 2^-49
/// of the greatest momentum that a body can have while energy does not rise.
class ExactMomentum {
 public:
  /// Throws InputError with gravity or applied forces, which change momentum.
  explicit ExactMomentum(const World& world);

  /// kg m/s, indexed by body: of the bodies at the start (0 for a fixed one), and after all impulses so far.
  const std::vector<Vec3>& before() const { return before_; }
  const std::vector<Vec3>& now() const { return momentum_; }

  /// Rounds the impulse, and sets the velocities after it to those of the bodies' momenta.
  void apply(BodyId a, BodyId b, ImpactResult& result);

 private:
  const World* world_;
  double grid_ = 0;  ///< N s
  std::vector<Vec3> before_, momentum_;
};

}  // namespace touchstone::fast::simulation
