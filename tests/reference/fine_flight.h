// Flights of bodies that turn as screws do, at 254 bits, and the gap between two hulls by all axes that can separate
// them. For holding certified times against: shares no code with the reference's flights.
#pragma once

#include <array>
#include <vector>

#include "model/scene.h"
#include "reference/float_impl.h"

namespace touchstone::tests {

using reference::Float;
using FineVec = reference::Three<Float>;

/// A body with three equal moments about its own origin.
class FineFlight {
 public:
  FineFlight(const Scene& scene, std::size_t index);

  std::vector<FineVec> vertices(double time) const;
  Pose pose(double time) const;  ///< to rounding
  const std::vector<std::vector<int>>& faces() const;

 private:
  /// Rodrigues: v + sin θ u × v + (1 − cos θ) u × (u × v).
  FineVec turned(const FineVec& v, double time) const;
  FineVec place(double time) const;

  const Body& body_;
  FineVec gravity_;
};

/// The greatest over face normals and crossed edges n of (min n·a − max n·b)/|n|: above 0 exactly if the two are apart.
Float greatest_gap(const FineFlight& A, const FineFlight& B, double time);

}  // namespace touchstone::tests
