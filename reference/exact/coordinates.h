// Three coordinates of any number type, and their geometric products.
#pragma once

namespace touchstone::reference {

// Results have the type T, never auto: gmpxx's expression templates would dangle.
template <class T>
struct Coordinates {
  T x, y, z;

  bool operator==(const Coordinates&) const = default;
};

template <class T>
Coordinates<T> operator+(const Coordinates<T>& a, const Coordinates<T>& b) {
  return {T(a.x + b.x), T(a.y + b.y), T(a.z + b.z)};
}

template <class T>
Coordinates<T> operator-(const Coordinates<T>& a, const Coordinates<T>& b) {
  return {T(a.x - b.x), T(a.y - b.y), T(a.z - b.z)};
}

template <class T>
Coordinates<T> operator-(const Coordinates<T>& a) {
  return {T(-a.x), T(-a.y), T(-a.z)};
}

template <class T>
Coordinates<T> operator*(const T& s, const Coordinates<T>& a) {
  return {T(s * a.x), T(s * a.y), T(s * a.z)};
}

template <class T>
T dot(const Coordinates<T>& a, const Coordinates<T>& b) {
  return T(a.x * b.x + a.y * b.y + a.z * b.z);
}

template <class T>
Coordinates<T> cross(const Coordinates<T>& a, const Coordinates<T>& b) {
  return {T(a.y * b.z - a.z * b.y), T(a.z * b.x - a.x * b.z), T(a.x * b.y - a.y * b.x)};
}

template <class T>
bool is_zero(const Coordinates<T>& a) {
  return a.x == 0 && a.y == 0 && a.z == 0;
}

}  // namespace touchstone::reference
