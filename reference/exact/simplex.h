// The point of a small simplex nearest to 0 (Johnson's subalgorithm of GJK, by cofactors, without division).
#pragma once

#include <array>
#include <optional>
#include <span>

#include "reference/exact/coordinates.h"

namespace touchstone::reference {

/// direction·height/denominator = Σ weight_i·w_i/total is the nearest point; all weights > 0, total = Σ weight_i.
/// `members` are indices into the simplex. direction is a positive multiple of the nearest point, with small numbers; 0
/// exactly if 0 is in the simplex.
template <class T>
struct NearestPoint {
  int count = 0;
  std::array<int, 4> members{};
  std::array<T, 4> weight{};
  T total{};
  Coordinates<T> direction{};
  T height{};
  T denominator{};
};

namespace simplex {

template <class T>
T determinant(const Coordinates<T>& a, const Coordinates<T>& b, const Coordinates<T>& c) {
  return dot(a, cross(b, c));
}

/// Divides by the greatest common divisor, which is large: an edge of one body has the other body's |q|² as a factor, a
/// face's normal even more.
void make_primitive(auto& v) {
  if constexpr (requires { gcd(v.x, v.y); }) {
    const auto common = decltype(v.x)(gcd(gcd(v.x, v.y), v.z));
    if (common > 1) v = {v.x / common, v.y / common, v.z / common};
  }
}

template <class T>
void weigh_edge(const Coordinates<T>& w0, const Coordinates<T>& w1, NearestPoint<T>& y) {
  Coordinates<T> e = w1 - w0;
  make_primitive(e);
  y.weight[0] = dot(w1, e);
  y.weight[1] = -dot(w0, e);
  y.total = y.weight[0] + y.weight[1];
}

template <class T>
void weigh_triangle(const Coordinates<T>& w0, const Coordinates<T>& w1, const Coordinates<T>& w2, NearestPoint<T>& y) {
  Coordinates<T> n = cross(Coordinates<T>(w1 - w0), Coordinates<T>(w2 - w0));
  make_primitive(n);
  y.weight[0] = determinant(n, w1, w2);
  y.weight[1] = determinant(n, w2, w0);
  y.weight[2] = determinant(n, w0, w1);
  y.total = y.weight[0] + y.weight[1] + y.weight[2];
  y.denominator = dot(n, n);
  y.direction = n;
}

template <class T>
void weigh_tetrahedron(const std::array<const Coordinates<T>*, 4>& w, NearestPoint<T>& y) {
  y.weight[0] = determinant(*w[1], *w[2], *w[3]);
  y.weight[1] = -determinant(*w[0], *w[2], *w[3]);
  y.weight[2] = determinant(*w[0], *w[1], *w[3]);
  y.weight[3] = -determinant(*w[0], *w[1], *w[2]);
  y.total = y.weight[0] + y.weight[1] + y.weight[2] + y.weight[3];
  if (y.total < 0) {
    for (T& weight : y.weight) weight = -weight;
    y.total = -y.total;
  }
}

/// The projection of 0 on the affine hull of the members in `mask`, if it lies in the relative interior of their hull.
template <class T>
std::optional<NearestPoint<T>> interior_projection(std::span<const Coordinates<T>> w, unsigned mask) {
  NearestPoint<T> y;
  std::array<const Coordinates<T>*, 4> p{};
  for (int i = 0; i < static_cast<int>(w.size()); ++i) {
    if ((mask >> i & 1U) == 0) continue;
    p[static_cast<std::size_t>(y.count)] = &w[static_cast<std::size_t>(i)];
    y.members[static_cast<std::size_t>(y.count++)] = i;
  }
  if (y.count == 1) y.weight[0] = y.total = T(1);
  if (y.count == 2) weigh_edge(*p[0], *p[1], y);
  if (y.count == 3) weigh_triangle(*p[0], *p[1], *p[2], y);
  if (y.count == 4) weigh_tetrahedron(p, y);
  if (!(y.total > 0)) return std::nullopt;
  for (int i = 0; i < y.count; ++i) {
    if (!(y.weight[static_cast<std::size_t>(i)] > 0)) return std::nullopt;
  }
  if (y.count == 3) {
    y.height = dot(y.direction, *p[0]);
    if (y.height < 0) y.direction = -y.direction;
    if (y.height == 0) y.direction = Coordinates<T>{};
    if (y.height < 0) y.height = -y.height;
    return y;
  }
  y.height = T(1);
  y.denominator = y.total;
  if (y.count == 1) y.direction = *p[0];
  if (y.count == 2) y.direction = Coordinates<T>(y.weight[0] * *p[0]) + Coordinates<T>(y.weight[1] * *p[1]);
  return y;
}

/// Larger subsets first, as the first one tried is usually the answer. Each bit stands for a member.
inline constexpr std::array<unsigned, 15> subsets = {15, 14, 13, 11, 7, 12, 10, 9, 6, 5, 3, 8, 4, 2, 1};

}  // namespace simplex
}  // namespace touchstone::reference
