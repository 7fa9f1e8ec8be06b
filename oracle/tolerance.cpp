#include "oracle/tolerance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "oracle/precision.h"

namespace touchstone::oracle::tolerance {
namespace {

// One pose, p_WA = R(q/|q|) p_BA + p_WB, in precision u, to first order:
//   |q|²      4 squares and 3 sums of terms ≥ 0: relative 4u; its root 2u + u; q/|q| one more: 4u a component.
//   R, diagonal      1 − 2(y² + z²): each square 9u, the sum 10u, of at most 2: 20u, minus and rounding: 21u.
//   R, off diagonal  2(xy ± wz): each product 9u, the sum u; as |xy| + |wz| ≤ 1/2: 10u.
//   so ‖ΔR‖_F ≤ √(3·21² + 6·10²) u < 44u, and |ΔR v| ≤ 44u|v|.
//   R v       3 products, 2 sums a row, rows of length 1: 3u|v| a coordinate, √3·3u|v| < 5.2u|v|.
//   + p_WB    u(|p|∞ + |v|) a coordinate: < 1.8u(|p|∞ + |v|).
// Together < 51u(|p|∞ + |v|) ≤ 51uS; 52 covers the terms of second order.
constexpr double pose = 52;

// An engine may take a point of A through two poses: into the frame of B or of a part, and the answer back to the
// world.
constexpr double poses = 2 * pose;

// A witness point as a convex combination of at most 4 vertices: weights that sum to 1 put it into the hull whatever
// their error, but for 4 products, 3 sums and the weights' own sum: 8u of a vector no longer than √3·S, < 14uS.
constexpr double combination = 14;

// |p_WCa − p_WCb|: subtraction u a coordinate, squares, sums and root 3u more, of at most 2√3·S: 4u·3.47S < 14uS.
constexpr double length = 14;

// Distance and depth change by at most ε when every point of one body moves by at most ε (the support function of A − B
// does), so two bodies' poses count once each.
constexpr double pair_value = 2 * (poses + combination) + length;

// An exact subject rounds once, when it answers: u of a value ≤ 2√3·S, or of each coordinate, or the far end of the
// tightest enclosure, 2u: < 7uS.
constexpr double answer_rounding = 7;

double times_ulp(double k, const Scene& scene, Precision precision) { return k * ulp(scene, precision); }

double rounding(double computed, Precision precision) {
  return precision == Precision::exact ? answer_rounding : computed;
}

double radius(const Sphere& s) { return s.radius; }
double radius(const Box& b) { return b.half_extents.stableNorm(); }
double radius(const Polytope& p) {
  double r = 0;
  for (const Vec3& v : p.vertices) r = std::max(r, v.stableNorm());
  return r;
}
double radius(const Compound& c) {
  double r = 0;
  for (const Part& part : c.parts) {
    r = std::max(r, part.X_BP.p_WB.stableNorm() + std::visit([](const auto& s) { return radius(s); }, part.shape));
  }
  return r;
}

// The size of the sum that a signed-tetrahedra volume is: V = Σ ±V_t, with A = Σ |V_t| over n triangles.
struct SignedSum {
  double n = 0;
  double V = 0;
  double A = 0;
};

// Closed forms: no cancellation, so V = A.
SignedSum signed_sum(const Sphere& s) {
  const double V = 4.18879020478639 * s.radius * s.radius * s.radius;
  return {1, V, V};
}
SignedSum signed_sum(const Box& b) {
  const double V = 8 * b.half_extents.x() * b.half_extents.y() * b.half_extents.z();
  return {1, V, V};
}
SignedSum signed_sum(const Polytope& p) {
  SignedSum sum;
  const auto vertex = [&p](int i) { return p.vertices[static_cast<std::size_t>(i)]; };
  for (const std::vector<int>& face : p.faces) {
    for (std::size_t k = 2; k < face.size(); ++k) {
      const double V_t = vertex(face[0]).dot(vertex(face[k - 1]).cross(vertex(face[k]))) / 6;
      sum = {sum.n + 1, sum.V + V_t, sum.A + std::abs(V_t)};
    }
  }
  return sum;
}
SignedSum signed_sum(const Compound& c) {
  SignedSum sum;
  for (const Part& part : c.parts) {
    const SignedSum s = std::visit([](const auto& shape) { return signed_sum(shape); }, part.shape);
    sum = {sum.n + s.n, sum.V + s.V, sum.A + s.A};
  }
  return sum;
}

}  // namespace

double radius(const Body& body) {
  return std::visit([](const auto& shape) { return radius(shape); }, body.shape);
}

double scale(const Scene& scene) {
  double S = 0;
  for (const Body& body : scene.bodies) {
    S = std::max(S, body.X_WB.p_WB.cwiseAbs().maxCoeff() + radius(body));
  }
  return S;
}

double ulp(const Scene& scene, Precision precision) { return unit_roundoff(precision) * scale(scene); }

double distance(const Scene& scene, Precision precision) {
  return times_ulp(rounding(pair_value, precision), scene, precision);
}

double witness(const Scene& scene, Precision precision) {
  return times_ulp(rounding(poses + combination, precision), scene, precision);
}

// The depth is the distance of 0 to a facet plane of A − B: the same points, the same length.
double penetration(const Scene& scene, Precision precision) { return distance(scene, precision); }

// The stated translation is depth · n: the depth's own error; n's error of length (below) times a depth ≤ 2√3·S; and
// the product's rounding, u a coordinate. An error θ of n's direction costs 1 − cos θ of the depth: second order.
double separation(const Scene& scene, Precision precision) {
  const double depth = 3.47 * scale(scene);
  return penetration(scene, precision) + depth * (unit_length(precision) + 2 * unit_roundoff(precision));
}

// n/|n|: 3 squares and 2 sums 3u, root 1.5u + u, division u: 3.5u a component, all alike but for 1u.
double unit_length(Precision precision) { return 4 * unit_roundoff(precision); }

// Two poses, then outward by as much again so that the box holds the body whatever was rounded.
double bounds(const Scene& scene, Precision precision) {
  return times_ulp(rounding(2 * poses, precision), scene, precision);
}

// Signed tetrahedra (0, a, b, c) over n triangles, all points within ρ of the body's origin; V_t = a·(b × c)/6.
//   V_t           two products and a difference a component of b × c, 3 products, 2 sums, /6: < 8u of |a||b||c|/6 ≤
//   ρ³/6. V = Σ V_t     n u A more, A = Σ |V_t|. With E = A + nρ³/6 · 1 for what cancels inside a determinant: δV ≤ (n
//   + 8) u E. M = Σ V_t·(a + b + c)/4   3 sums and a product more, terms ≤ |V_t| ρ: δM ≤ (n + 12) u E ρ. J, second
//   moments about the origin, terms ≤ |V_t| ρ²: δJ ≤ (n + 16) u E ρ². centre c = M/V, |c| ≤ ρ: δc ≤ (δM + |c| δV)/V +
//   u|c| ≤ (2n + 21) u Eρ/V. I = J − V(|c|²1 − ccᵀ): δI ≤ δJ + 2Vρ δc + ρ² δV + 6uVρ² ≤ (6n + 72) u E ρ². Parts of a
//   compound: R̂ is 44u from a rotation, so V is off by 3·44u and moments by 52u a factor more: + 300. Times the
//   density: u. A sphere's or a box's closed form has fewer roundings than one tetrahedron (E = A).
MassBound mass(const Body& body, Precision precision) {
  const Density* density = std::get_if<Density>(&body.mass);
  if (precision == Precision::exact || density == nullptr)
    return {};  // truth is an enclosure; given values are repeated
  const SignedSum s = std::visit([](const auto& shape) { return signed_sum(shape); }, body.shape);
  const double rho = radius(body);
  const double u = unit_roundoff(precision);
  const double posed = std::holds_alternative<Compound>(body.shape) ? 300 : 0;
  const double E = s.A + s.n * rho * rho * rho / 6;
  return {.mass = density->value * (s.n + 10 + posed) * u * E,
          .centre = (2 * s.n + 22 + posed) * u * E * rho / s.V,
          .inertia = density->value * (6 * s.n + 74 + posed) * u * E * rho * rho};
}

}  // namespace touchstone::oracle::tolerance
