#include "fast/motion/spread.h"

#include <array>
#include <cstddef>
#include <variant>
#include <vector>

#include "fast/exact/rotation.h"
#include "fast/lin_canny/rotation.h"
#include "model/input_error.h"

namespace touchstone::fast::motion {
namespace {

using exact::Dyadic;

using Entries = std::array<Dyadic, 3>;

Entries entries(const exact::Vector& x) { return {x.x, x.y, x.z}; }
Dyadic dot(const Entries& a, const Entries& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Entries product(const ExactMatrix& A, const Entries& v) { return {dot(A[0], v), dot(A[1], v), dot(A[2], v)}; }
Dyadic magnitude(const Entries& x) { return magnitude(x[0]) + magnitude(x[1]) + magnitude(x[2]); }

/// D = 6V, M = 24 V c and S = 120 ∫ x xᵀ dV, which take no division. C = S/120 − M Mᵀ/(96 D), so 480 D C = 4 D S −
/// 5 M Mᵀ.
struct Moments {
  Dyadic D;
  Entries M;
  ExactMatrix S;
};

/// 480 D C
ExactMatrix scaled_C(const Moments& of) {
  ExactMatrix C;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j)
      C[i][j] = C[j][i] = Dyadic(4) * of.D * of.S[i][j] - Dyadic(5) * of.M[i] * of.M[j];
  }
  return C;
}

/// With tetrahedra from the origin, d = det(a, b, c), s = a + b + c: D = Σ d, M = Σ d s, S = Σ d (aaᵀ + bbᵀ + ccᵀ +
/// ssᵀ).
Moments moments(const Polytope& polytope) {
  if (polytope.faces.empty()) throw InputError("shape.faces", "are missing: mass properties need them");
  Moments sum;
  const auto corner = [&](int v) { return exact::vector(polytope.vertices[static_cast<std::size_t>(v)]); };
  for (const std::vector<int>& face : polytope.faces) {
    const exact::Vector a = corner(face[0]);
    for (std::size_t k = 2; k < face.size(); ++k) {
      const exact::Vector b = corner(face[k - 1]), c = corner(face[k]);
      const Dyadic d = dot(a, cross(b, c));
      const std::array<Entries, 4> corners{entries(a), entries(b), entries(c), entries(a + b + c)};
      sum.D = sum.D + d;
      for (std::size_t i = 0; i < 3; ++i) {
        sum.M[i] = sum.M[i] + d * corners[3][i];
        for (std::size_t j = i; j < 3; ++j) {
          Dyadic products;
          for (const auto& x : corners) products = products + x[i] * x[j];
          sum.S[i][j] = sum.S[i][j] + d * products;
        }
      }
    }
  }
  if (sum.D.sign() <= 0) throw InputError("shape.faces", "bound no positive volume");
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < i; ++j) sum.S[i][j] = sum.S[j][i];
  }
  return sum;
}

/// V = 8 h_x h_y h_z, ∫ x_i² dV = V h_i²/3.
Moments moments(const Box& box) {
  const Entries h = entries(exact::vector(box.half_extents));
  const Dyadic product = h[0] * h[1] * h[2];
  Moments found;
  found.D = Dyadic(48) * product;
  for (std::size_t i = 0; i < 3; ++i) found.S[i][i] = Dyadic(320) * product * h[i] * h[i];
  return found;
}

/// V = 4π/3 r³, ∫ x_i² dV = V r²/5. `pi`: π, or what stands for it.
Moments moments(const Sphere& sphere, const Dyadic& pi) {
  const Dyadic r = sphere.radius;
  Moments found;
  found.D = Dyadic(8) * pi * r * r * r;
  for (std::size_t i = 0; i < 3; ++i) found.S[i][i] = Dyadic(32) * pi * r * r * r * r * r;
  return found;
}

/// π with an error below 2^-216. Each double is what is left of π beside those before, rounded (a test computes π by a
/// series).
Dyadic pi_of_four_doubles() {
  return Dyadic(0x1.921fb54442d18p+1) + Dyadic(0x1.1a62633145c07p-53) + Dyadic(-0x1.f1976b7ed8fbcp-109) +
         Dyadic(0x1.4cf98e804177dp-163);
}

/// 1/s. Two steps of Newton's method square the error of 2^-51 twice.
Dyadic reciprocal(const Dyadic& s) {
  Dyadic r = 1 / s.approximate();
  for (int step = 0; step < 2; ++step) r = r * (Dyadic(2) - s * r);
  return r;
}

/// R(q/|q|) for q ≠ 0, of entries that are exact if |q|² is a power of two.
struct Rotation {
  explicit Rotation(const Quaternion& q) {
    const Quaternion moderate = lin_canny::at_moderate_scale(q);
    const exact::ScaledRotation scaled = exact::scaled_rotation(moderate);
    const Dyadic factor = reciprocal(scaled.squared_length);
    is_exact = moderate == q && (scaled.squared_length * factor - Dyadic(1)).sign() == 0;
    for (std::size_t i = 0; i < 3; ++i) R[i] = entries(factor * scaled.rows[i]);
  }

  ExactMatrix R;
  bool is_exact = false;
};

class Sum {
 public:
  /// x ↦ R x + p: R M + 4 D p, and R S Rᵀ + 5 ((R M) pᵀ + p (R M)ᵀ) + 20 D p pᵀ.
  void add(const Moments& part, const Entries& p) {
    const Dyadic offset = magnitude(p), four(4), five(5), twenty(20);
    total_.D = total_.D + part.D;
    for (std::size_t i = 0; i < 3; ++i) {
      total_.M[i] = total_.M[i] + part.M[i] + four * part.D * p[i];
      for (std::size_t j = 0; j < 3; ++j) {
        total_.S[i][j] = total_.S[i][j] + part.S[i][j] + five * (part.M[i] * p[j] + p[i] * part.M[j]) +
                         twenty * part.D * p[i] * p[j];
      }
    }
    of_M_ = of_M_ + magnitude(part.M) + four * part.D * offset;
    of_S_ = of_S_ + trace(part.S) + Dyadic(10) * magnitude(part.M) * offset + twenty * part.D * offset * offset;
  }

  ScaledC scaled(bool is_exact) const {
    ScaledC found{scaled_C(total_), 0};
    if (is_exact) return found;
    const Dyadic terms = Dyadic(4) * total_.D * of_S_ + Dyadic(5) * of_M_ * of_M_;
    found.error = 0x1p-195 * exact::ratio(terms, trace(found.C));
    return found;
  }

 private:
  Moments total_;
  Dyadic of_M_, of_S_;  ///< sums of the magnitudes of all terms
};

}  // namespace

ExactMatrix entries(const std::array<exact::Vector, 3>& rows) {
  return {entries(rows[0]), entries(rows[1]), entries(rows[2])};
}

ExactMatrix congruent(const ExactMatrix& A, const ExactMatrix& M) {
  ExactMatrix D;
  for (std::size_t j = 0; j < 3; ++j) {
    const Entries whole = product(A, product(M, A[j]));  // column j
    for (std::size_t i = 0; i < 3; ++i) D[i][j] = whole[i];
  }
  return D;
}

Dyadic trace(const ExactMatrix& M) { return M[0][0] + M[1][1] + M[2][2]; }

ExactSpread exact_spread(const Polytope& polytope) {
  const Moments whole = moments(polytope);
  ExactSpread found;
  found.scaled.C = scaled_C(whole);
  Spread& rounded = found.rounded;
  rounded.volume = exact::ratio(whole.D, Dyadic(6));
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    rounded.centroid[row] = exact::ratio(whole.M[i], Dyadic(4) * whole.D);
    for (std::size_t j = 0; j < 3; ++j) {
      rounded.C(row, static_cast<Eigen::Index>(j)) = exact::ratio(found.scaled.C[i][j], Dyadic(480) * whole.D);
    }
  }
  return found;
}

ScaledC scaled_spread(const Compound& compound) {
  std::size_t balls = 0;
  for (const Part& part : compound.parts) balls += std::holds_alternative<Sphere>(part.shape) ? 1 : 0;
  const bool is_mixed = balls > 0 && balls < compound.parts.size();
  const Dyadic pi = is_mixed ? pi_of_four_doubles() : Dyadic(1);  // of balls alone it is a factor of all terms
  bool is_exact = !is_mixed;
  const exact::Vector origin = exact::vector(compound.parts.front().X_BP.p_WB);  // C is the same about any
  Sum sum;
  for (const Part& part : compound.parts) {
    const Entries p = entries(exact::vector(part.X_BP.p_WB) - origin);
    if (const auto* sphere = std::get_if<Sphere>(&part.shape)) {
      sum.add(moments(*sphere, pi), p);
      continue;
    }
    const auto* box = std::get_if<Box>(&part.shape);
    Moments turned = box ? moments(*box) : moments(std::get<Polytope>(part.shape));
    const Rotation R(part.X_BP.q_WB);
    turned.M = product(R.R, turned.M);
    turned.S = congruent(R.R, turned.S);
    is_exact = is_exact && R.is_exact;
    sum.add(turned, p);
  }
  return sum.scaled(is_exact);
}

}  // namespace touchstone::fast::motion
