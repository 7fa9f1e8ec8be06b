// The point of a small simplex that is nearest to 0 (Johnson's subalgorithm of GJK, by cofactors, without division).
#pragma once

#include <array>
#include <optional>
#include <span>

#include "reference/triple_impl.h"

namespace touchstone::reference {

/// numerator/total = Σ weight_i·w_i/total, all weights > 0, total = Σ weight_i; `members` are indices into the simplex.
/// direction is a positive multiple of it, of least degree; 0 exactly when 0 is in the simplex.
template <class T>
struct NearestPoint {
  int count = 0;
  std::array<int, 4> members{};
  std::array<T, 4> weight{};
  T total{};
  Triple<T> numerator{};
  Triple<T> direction{};
};

namespace simplex {

template <class T>
T determinant(const Triple<T>& a, const Triple<T>& b, const Triple<T>& c) {
  return dot(a, cross(b, c));
}

template <class T>
void weigh_edge(const Triple<T>& w0, const Triple<T>& w1, NearestPoint<T>& y) {
  const Triple<T> e = w1 - w0;
  y.weight[0] = dot(w1, e);
  y.weight[1] = -dot(w0, e);
  y.total = dot(e, e);
}

template <class T>
void weigh_triangle(const Triple<T>& w0, const Triple<T>& w1, const Triple<T>& w2, NearestPoint<T>& y) {
  const Triple<T> n = cross(Triple<T>(w1 - w0), Triple<T>(w2 - w0));
  y.weight[0] = determinant(n, w1, w2);
  y.weight[1] = determinant(n, w2, w0);
  y.weight[2] = determinant(n, w0, w1);
  y.total = dot(n, n);
  y.direction = n;
}

template <class T>
void weigh_tetrahedron(const std::array<const Triple<T>*, 4>& w, NearestPoint<T>& y) {
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
std::optional<NearestPoint<T>> interior_projection(std::span<const Triple<T>> w, unsigned mask) {
  NearestPoint<T> y;
  std::array<const Triple<T>*, 4> p{};
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
    const T height = dot(y.direction, *p[0]);
    y.numerator = height * y.direction;
    if (height < 0) y.direction = -y.direction;
    if (height == 0) y.direction = Triple<T>{};
  } else if (y.count < 3) {
    y.numerator = Triple<T>(y.weight[0] * *p[0]);
    if (y.count == 2) y.numerator = y.numerator + Triple<T>(y.weight[1] * *p[1]);
    y.direction = y.numerator;
  }
  return y;
}

/// Larger subsets first: as a rule the first one tried is the answer. (Bits are members.)
inline constexpr std::array<unsigned, 15> subsets = {15, 14, 13, 11, 7, 12, 10, 9, 6, 5, 3, 8, 4, 2, 1};

}  // namespace simplex
}  // namespace touchstone::reference
