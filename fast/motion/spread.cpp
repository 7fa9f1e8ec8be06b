#include "fast/motion/spread.h"

#include <array>
#include <vector>

#include "fast/exact/vector.h"
#include "fast/rounding.h"
#include "model/input_error.h"

namespace touchstone::fast::motion {

using exact::Dyadic;

/// With tetrahedra from the origin, d = det(a, b, c), s = a + b + c: D = Σ d, M = Σ d s, S = Σ d (aaᵀ + bbᵀ + ccᵀ +
/// ssᵀ); V = D/6, centroid M/(4D), C = S/120 − M Mᵀ/(96 D) = (4 D S − 5 M Mᵀ)/(480 D).
ExactSpread exact_spread(const Polytope& polytope) {
  if (polytope.faces.empty()) throw InputError("shape.faces", "are missing: mass properties need them");
  Dyadic D;
  std::array<Dyadic, 3> M;
  ExactMatrix S;
  const auto corner = [&](int v) { return exact::vector(polytope.vertices[static_cast<std::size_t>(v)]); };
  const auto entries = [](const exact::Vector& x) { return std::array<Dyadic, 3>{x.x, x.y, x.z}; };
  for (const std::vector<int>& face : polytope.faces) {
    const exact::Vector a = corner(face[0]);
    for (std::size_t k = 2; k < face.size(); ++k) {
      const exact::Vector b = corner(face[k - 1]), c = corner(face[k]);
      const Dyadic d = dot(a, cross(b, c));
      const std::array<std::array<Dyadic, 3>, 4> corners{entries(a), entries(b), entries(c), entries(a + b + c)};
      D = D + d;
      for (std::size_t i = 0; i < 3; ++i) {
        M[i] = M[i] + d * corners[3][i];
        for (std::size_t j = i; j < 3; ++j) {
          Dyadic sum;
          for (const auto& x : corners) sum = sum + x[i] * x[j];
          S[i][j] = S[i][j] + d * sum;
        }
      }
    }
  }
  if (D.sign() <= 0) throw InputError("shape.faces", "bound no positive volume");
  ExactSpread found;
  Spread& rounded = found.rounded;
  rounded.volume = exact::ratio(D, Dyadic(6));
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    rounded.centroid[row] = exact::ratio(M[i], Dyadic(4) * D);
    for (std::size_t j = i; j < 3; ++j) {
      const auto column = static_cast<Eigen::Index>(j);
      found.scaled_C[i][j] = found.scaled_C[j][i] = Dyadic(4) * D * S[i][j] - Dyadic(5) * M[i] * M[j];
      rounded.C(row, column) = rounded.C(column, row) = exact::ratio(found.scaled_C[i][j], Dyadic(480) * D);
    }
  }
  rounded.error = 6 * u * rounded.C.norm();
  return found;
}

}  // namespace touchstone::fast::motion
