// Rotations as quaternions of any number type.
#pragma once

#include <array>

#include "reference/exact/tiers.h"

namespace touchstone::reference {

template <class T>
using Rotor = std::array<T, 4>;  ///< w, x, y, z

template <class T>
Rotor<T> operator*(const Rotor<T>& a, const Rotor<T>& b) {
  return {T(a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3]),
          T(a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2]),
          T(a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3]),
          T(a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1])};
}

/// The rows of R(q), where q_squared = |q|² (model/frame.h).
template <class T>
std::array<T, 9> matrix_of(const Rotor<T>& q, const T& q_squared) {
  const T s = T(2) / q_squared;
  const T x = s * q[1];
  const T y = s * q[2];
  const T z = s * q[3];
  const T xx = x * q[1], yy = y * q[2], zz = z * q[3], xy = x * q[2], xz = x * q[3], yz = y * q[3];
  const T wx = q[0] * x, wy = q[0] * y, wz = q[0] * z;
  const T one(1);
  return {T(one - yy - zz), T(xy - wz),       T(xz + wy),  //
          T(xy + wz),       T(one - xx - zz), T(yz - wx),  //
          T(xz - wy),       T(yz + wx),       T(one - xx - yy)};
}

/// A constant angular velocity.
template <class E>
struct Spin {
  bool none = true;
  E rate;               ///< |ω|
  Coordinates<E> axis;  ///< ω/|ω|
};

template <class E>
Spin<E> spin(const std::array<mpq_class, 3>& w) {
  const mpq_class squared = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
  if (squared == 0) return {};
  const E rate = root(enclosed<E>(squared));
  const Coordinates<E> v = enclosed<E>(w);
  return {false, rate, {E(v.x / rate), E(v.y / rate), E(v.z / rate)}};
}

/// exp([ω] τ) as a unit quaternion. Requires a spin that is not `none`.
template <class E>
Rotor<E> turn(const Spin<E>& spin, const E& tau) {
  const auto [cosine, sine] = cosine_and_sine(E(spin.rate * tau / E(2)));
  return {cosine, E(sine * spin.axis.x), E(sine * spin.axis.y), E(sine * spin.axis.z)};
}

}  // namespace touchstone::reference
