// The Minkowski difference B − A of two posed point sets, vertex by vertex, exactly.
//
// A vertex in W is (M v + t)/D with M, t and D sums of products of doubles: R(q/|q|) = M(q)/|q|², and a part's two
// poses multiply. All vertices of the pair are brought to the common denominator D_A D_B, so that nothing is ever
// divided.
#pragma once

#include <array>
#include <map>
#include <span>
#include <vector>

#include "fast/exact/vector.h"

namespace touchstone::fast::exact {

/// `poses`: the outermost first; one for a body, two for a part of a compound.
struct PosedPoints {
  std::span<const Pose> poses;
  std::span<const Vec3> points;  ///< at least one
};

/// An index pair: vertex a of A, vertex b of B.
struct VertexPair {
  int a = 0;
  int b = 0;

  bool operator==(const VertexPair&) const = default;
};

class Difference {
 public:
  /// Keeps references to the data of the spans.
  Difference(const PosedPoints& A, const PosedPoints& B);

  /// denominator() · (b − a).
  Vector operator()(const VertexPair& pair) { return B_.scaled_point(pair.b) - A_.scaled_point(pair.a); }
  const Dyadic& denominator() const { return denominator_; }

  /// The pair with the least n·(b − a). Requires n ≠ 0.
  VertexPair support(const Vector& n) { return {A_.farthest(n), B_.farthest(-n)}; }

 private:
  /// v ↦ (M v + t)/D; then times `scale`, which brings it to the pair's denominator.
  class Posed {
   public:
    explicit Posed(const PosedPoints& solid);
    void set_scale(const Dyadic& scale);
    const Dyadic& denominator() const { return D_; }
    const Vector& scaled_point(int i);
    int farthest(const Vector& n);

   private:
    std::vector<double> heights(const Vector& n, double& error) const;

    std::span<const Vec3> points_;
    std::array<Vector, 3> M_;  ///< rows
    Vector t_;
    Dyadic D_;
    Mat3 R_;
    double radius_ = 0;
    std::map<int, Vector> known_;
  };

  Posed A_;
  Posed B_;
  Dyadic denominator_;
};

}  // namespace touchstone::fast::exact
