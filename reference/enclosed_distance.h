// The verdict and an enclosure of the distance of bodies 0 (A) and 1 (B), proved in long doubles. It takes some
// microseconds, where the exact distance takes a hundred. It is for questions by the ten thousand, with
// reference/distance.h for those that it leaves open.
#pragma once

#include <memory>
#include <optional>

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::reference {

/// What is proved of two bodies that do not touch.
struct EnclosedDistance {
  Verdict verdict = Verdict::separated;  ///< or overlapping
  Interval distance;                     ///< m: contains the exact distance; [0, 0] if overlapping
};

/// The vertices of both bodies in long doubles, relative to A's origin, with a bound on their rounding errors.
class EnclosedPair {
 public:
  /// Requires a completed scene of at least two bodies.
  explicit EnclosedPair(const Scene& scene);
  ~EnclosedPair();
  EnclosedPair(const EnclosedPair&) = delete;
  EnclosedPair& operator=(const EnclosedPair&) = delete;

  /// None if long doubles do not decide the verdict: the bodies touch, or nearly, or are slivers. The interval is
  /// usually some 2⁻⁵⁵ of the lengths wide, and wider where GJK ends early.
  std::optional<EnclosedDistance> distance() const;

  /// m, an upper bound of the distance: of two features, swollen by the radii of their parts; of a point (in W) from a
  /// feature of A or B, swollen likewise. Infinite if there is no such feature.
  double features_apart(const Feature& a, const Feature& b) const;
  double off_feature_A(const Vec3& p_W, const Feature& a) const;
  double off_feature_B(const Vec3& p_W, const Feature& b) const;

 private:
  struct Posed;
  std::unique_ptr<const Posed> posed_;
};

}  // namespace touchstone::reference
