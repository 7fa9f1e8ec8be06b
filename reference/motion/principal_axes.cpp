#include "reference/motion/principal_axes.h"

#include <algorithm>

namespace touchstone::reference {
namespace {

using E = WideEnclosure;

/// (I − λ) v = 0, so v is perpendicular to all rows. The greatest cross product of two rows gives it most precisely.
Coordinates<E> axis(const Square<mpq_class>& I, const E& lambda) {
  std::array<Coordinates<E>, 3> rows;
  for (std::size_t i = 0; i < 3; ++i) rows[i] = enclosed<E>(I[i]);
  rows[0].x -= lambda;
  rows[1].y -= lambda;
  rows[2].z -= lambda;
  const std::array<Coordinates<E>, 3> products = {cross(rows[0], rows[1]), cross(rows[1], rows[2]),
                                                  cross(rows[2], rows[0])};
  const auto size = [](const Coordinates<E>& v) { return middle(E(dot(v, v))); };
  const Coordinates<E>& v =
      *std::ranges::max_element(products, [&](const auto& a, const auto& b) { return size(a) < size(b); });
  return E(E(1) / length(v)) * v;
}

}  // namespace

/// With m the mean of the eigenvalues, D = I − m and 6 p² = tr D², the eigenvalues are m + 2 p cos(φ + 2πk/3), where
/// cos 3φ = det D/(2p³).
PrincipalAxes principal_axes(const Square<mpq_class>& I) {
  const mpq_class mean = (I[0][0] + I[1][1] + I[2][2]) / 3;
  Square<mpq_class> D = I;
  for (std::size_t i = 0; i < 3; ++i) D[i][i] -= mean;
  const mpq_class p_squared = (inner(D[0], D[0]) + inner(D[1], D[1]) + inner(D[2], D[2])) / 6;
  const E p = root(enclosed<E>(p_squared));
  const E cosine = enclosed<E>(determinant(D)) / (E(2) * p * p * p);
  const Float one = 1;
  const E thrice =
      acos(between(std::clamp(lower(cosine), Float(-one), one), std::clamp(upper(cosine), Float(-one), one)));
  const E third_of_turn = E(2) * acos(E(-1)) / E(3);
  const E phi = thrice / E(3), m = enclosed<E>(mean);
  PrincipalAxes found;
  found.moments[2] = m + E(2) * p * cos(phi);
  found.moments[0] = m + E(2) * p * cos(E(phi + third_of_turn));
  found.moments[1] = m + E(2) * p * cos(E(phi - third_of_turn));
  for (std::size_t i = 0; i < 3; ++i) found.axes[i] = axis(I, found.moments[i]);
  return found;
}

}  // namespace touchstone::reference
