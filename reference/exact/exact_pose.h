// The vertices of a pair of convex cores in W, as integers over one common denominator and as intervals around them.
//
// A vertex is t + M(q)v/|q|². Lengths (v, t) are integers times one power of two, each q is scaled to integers
// separately, and everything is multiplied by the least common multiple of |qA|² and |qB|², so that no division is
// needed. With the origin moved to that of body B,
//   vertex = origin + integer · 2^exponent / denominator.
// The intervals are scaled by another power of two, so that their coordinates are about 1 at any scale of the scene.
#pragma once

#include <CGAL/Interval_nt.h>
#include <gmpxx.h>

#include <array>
#include <vector>

#include "model/parts.h"
#include "model/scene.h"
#include "reference/exact/coordinates.h"
#include "reference/rational.h"

namespace touchstone::reference {

using Integer = mpz_class;
using IntegerVec = Coordinates<Integer>;
using Enclosure = CGAL::Interval_nt<false>;  // only inside a scope of RoundUpward
using EnclosureVec = Coordinates<Enclosure>;
using PlainVec = Coordinates<double>;

inline Enclosure squared_length(const EnclosureVec& v) {
  return CGAL::square(v.x) + CGAL::square(v.y) + CGAL::square(v.z);
}

/// Interval arithmetic needs the processor to round upwards. Plain double code stays outside this scope to stay
/// reproducible.
using RoundUpward = CGAL::Protect_FPU_rounding<true>;

/// An enclosure of some positive multiple of an integer vector, in doubles of size about 1.
EnclosureVec enclosure(const IntegerVec& v);

/// The same without guaranteed bounds.
PlainVec plain(const IntegerVec& v);

/// num/den · 2^shift.
Enclosure enclosure(const Integer& num, const Integer& den, long shift);

/// A convex part without its radius, in its own frame. Points to the faces of the body, which must outlive it.
struct Core {
  std::vector<Vec3> vertices;
  const std::vector<std::vector<int>>* faces = nullptr;  ///< empty for a point
  double radius = 0;

  bool is_point() const { return vertices.size() == 1; }
};

Core core_of(const Body& body, int part);
Pose part_pose(const Body& body, int part);  ///< X_BP; the body's own frame for a convex body

/// One posed core of a pair. Exact vertices are computed on first use and cached.
class PosedCore {
 public:
  int size() const { return static_cast<int>(core_.vertices.size()); }
  bool is_point() const { return core_.is_point(); }
  double radius() const { return core_.radius; }
  const std::vector<std::vector<int>>& faces() const { return *core_.faces; }

  const IntegerVec& exact(int vertex) const;
  const EnclosureVec& enclosed(int vertex) const { return enclosed_[static_cast<std::size_t>(vertex)]; }
  const std::vector<PlainVec>& plain() const { return plain_; }

  void enclose();  ///< fills enclosed(); call inside RoundUpward

 private:
  friend class PosedPair;

  Core core_;
  std::array<Integer, 9> linear_;  ///< maps integer lengths
  IntegerVec offset_;
  Integer denominator_;
  long unit_ = 0;                 ///< lengths are integers · 2^unit
  long scale_ = 0;                ///< plain and enclosed coordinates are lengths · 2^-scale
  std::vector<PlainVec> scaled_;  ///< vertices in their own frame
  std::vector<PlainVec> plain_;
  std::vector<EnclosureVec> enclosed_;
  mutable std::vector<IntegerVec> exact_;
  mutable std::vector<bool> known_;
};

class PosedPair {
 public:
  /// `shift_A` (W) is added to A's position, exactly.
  PosedPair(const Body& A, int part_A, const Body& B, int part_B, const Vec3& shift_A = Vec3::Zero());

  PosedCore A;
  PosedCore B;

  IntegerVec difference(int a, int b) const { return A.exact(a) - B.exact(b); }

  Rational length(const Integer& num, const Integer& den) const;        ///< m; num/den in integer units
  Rational square(const Integer& num, const Integer& den) const;        ///< m²; num/den in squared integer units
  RationalVec3 point(const IntegerVec& num, const Integer& den) const;  ///< in W, m
  Vec3 nearest_point(const IntegerVec& num, const Integer& den) const;  ///< the same to the nearest doubles, cheaper

 private:
  IntegerVec origin_;  ///< in integer lengths
  Integer denominator_;
  long exponent_;
};

/// The exact sign of n·(vertex − from); `around` encloses a positive multiple of n. Call inside RoundUpward, after
/// enclose().
int side(const PosedCore& core, const IntegerVec& n, const EnclosureVec& around, int vertex, int from);

Rational rational(const Integer& value);
mpq_class unreduced(const Integer& num, const Integer& den, long shift);     ///< num/den · 2^shift; den > 0
mpq_class fraction(const Integer& num, const Integer& den, long shift = 0);  ///< the same in lowest terms; den ≠ 0
Rational rational(mpq_class value);

}  // namespace touchstone::reference
