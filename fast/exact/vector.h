// Vectors of dyadic numbers: the three products that geometry needs.
#pragma once

#include "fast/exact/dyadic.h"
#include "model/frame.h"

namespace touchstone::fast::exact {

struct Vector {
  Dyadic x;
  Dyadic y;
  Dyadic z;

  bool is_zero() const { return x.sign() == 0 && y.sign() == 0 && z.sign() == 0; }
};

inline Vector vector(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
inline Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector operator-(const Vector& a) { return {-a.x, -a.y, -a.z}; }
inline Vector operator*(const Dyadic& s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Dyadic dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The direction of v ≠ 0 in doubles: v · 2^-k, greatest component in [1/2, 1), each component truncated to 53 bits.
Vec3 direction(const Vector& v);

/// v · 2^-k for the k of `direction`, exactly.
Vector at_unit_scale(const Vector& v);

}  // namespace touchstone::fast::exact
