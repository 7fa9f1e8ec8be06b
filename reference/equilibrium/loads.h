// The parts of LoadedBodies in exact numbers.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "reference/equilibrium.h"
#include "reference/exact/dense.h"
#include "reference/exact/linear.h"
#include "reference/impulse/exact_vectors.h"

namespace touchstone::reference {

/// Force and torque about the centre of mass.
struct ExactLoad {
  Triple force, torque;

  void add(const Triple& P, const Triple& arm) {
    force = plus(force, P);
    torque = plus(torque, cross(arm, P));
  }
  bool is_zero() const { return force == Triple{} && torque == Triple{}; }
};

/// What is left of the loads with forces P. Of fixed bodies: the sum of what acts on them.
inline std::vector<ExactLoad> left_of(const LoadedBodies& bodies, const std::vector<Triple>& P) {
  std::vector<ExactLoad> left;
  for (const auto& load : bodies.loads) {
    left.push_back(load ? ExactLoad{triple(load->force_W), triple(load->torque_W)} : ExactLoad{});
  }
  for (std::size_t k = 0; k < P.size(); ++k) {
    const LoadedBodies::Point& point = bodies.points[k];
    left[index(point.a)].add(P[k], triple(point.arm_A_W));
    left[index(point.b)].add(scaled(mpq_class(-1), P[k]), triple(point.arm_B_W));
  }
  return left;
}

}  // namespace touchstone::reference
