// Three-dimensional linear algebra for mpq_class and for multiprecision floats.
// Results have the type T, never auto: gmpxx's expression templates would dangle.
#pragma once

#include <array>
#include <cstddef>

namespace touchstone::reference {

template <class T>
using Three = std::array<T, 3>;
template <class T>
using Square = std::array<Three<T>, 3>;

template <class T>
T inner(const Three<T>& a, const Three<T>& b) {
  return T(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

template <class T>
Three<T> plus(const Three<T>& a, const Three<T>& b) {
  return {T(a[0] + b[0]), T(a[1] + b[1]), T(a[2] + b[2])};
}

template <class T>
Three<T> minus(const Three<T>& a, const Three<T>& b) {
  return {T(a[0] - b[0]), T(a[1] - b[1]), T(a[2] - b[2])};
}

template <class T>
Three<T> scaled(const T& s, const Three<T>& a) {
  return {T(s * a[0]), T(s * a[1]), T(s * a[2])};
}

template <class T>
Three<T> cross(const Three<T>& a, const Three<T>& b) {
  return {T(a[1] * b[2] - a[2] * b[1]), T(a[2] * b[0] - a[0] * b[2]), T(a[0] * b[1] - a[1] * b[0])};
}

template <class T>
Three<T> times(const Square<T>& M, const Three<T>& a) {
  return {inner(M[0], a), inner(M[1], a), inner(M[2], a)};
}

template <class T>
T determinant(const Square<T>& M) {
  return inner(M[0], cross(M[1], M[2]));
}

/// Inverse by cofactors.
template <class T>
Square<T> inverted(const Square<T>& M) {
  const Square<T> columns = {cross(M[1], M[2]), cross(M[2], M[0]), cross(M[0], M[1])};
  const T det = inner(M[0], columns[0]);
  Square<T> inverse;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) inverse[i][j] = columns[j][i] / det;
  }
  return inverse;
}

}  // namespace touchstone::reference
