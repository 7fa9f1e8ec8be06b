#include "oracle/tolerance/tolerance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "oracle/tolerance/precision.h"

namespace touchstone::oracle::tolerance {
namespace {

// One pose, p_WA = R(q/|q|) p_BA + p_WB, in precision u, to first order:
//   |q|²      4 squares and 3 sums of terms ≥ 0: relative 4u; its root 2u + u; q/|q| one more: 4u for each component.
//   R, diagonal      1 − 2(y² + z²): each square 9u, the sum 10u, of at most 2: 20u, minus and rounding: 21u.
//   R, off diagonal  2(xy ± wz): each product 9u, the sum u; as |xy| + |wz| ≤ 1/2: 10u.
//   so ‖ΔR‖_F ≤ √(3·21² + 6·10²) u < 44u, and |ΔR v| ≤ 44u|v|.
//   R v       3 products, 2 sums for each row, rows of length 1: 3u|v| a coordinate, √3·3u|v| < 5.2u|v|.
//   + p_WB    u(|p|∞ + |v|) a coordinate: < 1.8u(|p|∞ + |v|).
// Together < 51u(|p|∞ + |v|) ≤ 51uS; 52 covers the terms of second order.
constexpr double pose = 52;

// An engine may transform a point of A by two poses: into the frame of B or of a part, and the answer back to the
// world.
constexpr double poses = 2 * pose;

// A witness point as a convex combination of at most 4 vertices: weights that sum to 1 put it into the hull whatever
// their errors. What remains are 4 products, 3 sums and the sum of the weights: 8u of a vector no longer than √3·S, <
// 14uS.
constexpr double combination = 14;

// |p_WCa − p_WCb|: subtraction u for each coordinate, squares, sums and root 3u more, of at most 2√3·S: 4u·3.47S <
// 14uS.
constexpr double norm = 14;

// Distance and depth change by at most ε if every point of one body moves by at most ε (as the support function of A −
// B does), so the poses of the two bodies count once each.
constexpr double pair_value = 2 * (poses + combination) + norm;

// An exact subject rounds only its answer: u of a value ≤ 2√3·S, or of each coordinate, or the far end of the tightest
// enclosure, 2u: < 7uS.
constexpr double answer_rounding = 7;

double times_ulp(double k, const Scene& scene, Precision precision) { return k * ulp(scene, precision); }

double rounding(double computed, double exact, Precision precision) {
  return precision == Precision::exact ? exact : computed;
}
double rounding(double computed, Precision precision) { return rounding(computed, answer_rounding, precision); }

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

// The sum of tetrahedra that makes up a volume: n triangles seen from a point of the solid, no point farther from it
// than rho; the volume V; and E = V + n rho³/6, which covers cancellation inside the determinants.
struct Solid {
  double n = 0;
  double rho = 0;
  double V = 0;
  double E = 0;
};

// Closed forms have fewer roundings than one tetrahedron.
Solid solid(double rho, double V) { return {1, rho, V, V}; }
Solid solid(const Sphere& s) { return solid(s.radius, 4.18879020478639 * s.radius * s.radius * s.radius); }
Solid solid(const Box& b) { return solid(radius(b), 8 * b.half_extents.x() * b.half_extents.y() * b.half_extents.z()); }
Solid solid(const Polytope& p) {
  Solid sum;
  const auto seen = [&p](int i) { return Vec3(p.vertices[static_cast<std::size_t>(i)] - p.vertices.front()); };
  for (const Vec3& v : p.vertices) sum.rho = std::max(sum.rho, (v - p.vertices.front()).stableNorm());
  for (const std::vector<int>& face : p.faces) {
    for (std::size_t k = 2; k < face.size(); ++k) {
      ++sum.n;
      sum.V += std::abs(seen(face[0]).dot(seen(face[k - 1]).cross(seen(face[k])))) / 6;
    }
  }
  sum.E = sum.V + sum.n * sum.rho * sum.rho * sum.rho / 6;
  return sum;
}
Solid solid(const Compound& c) {
  Solid sum;
  for (const Part& part : c.parts) {
    const Solid s = std::visit([](const auto& shape) { return solid(shape); }, part.shape);
    sum = {sum.n + s.n, radius(c), sum.V + s.V, sum.E + s.E};
  }
  return sum;
}
Solid solid(const Body& body) {
  return std::visit([](const auto& shape) { return solid(shape); }, body.shape);
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

// The stated translation is depth · n: the error of the depth; the error of n's length (below) times a depth ≤ 2√3·S;
// and the rounding of the product, u for each coordinate. An error θ of n's direction costs 1 − cos θ of the depth:
// second order.
double separation(const Scene& scene, Precision precision) {
  const double depth = 3.47 * scale(scene);
  return penetration(scene, precision) + depth * (unit_length(precision) + 2 * unit_roundoff(precision));
}

// n/|n|: 3 squares and 2 sums 3u, root 1.5u + u, division u: 3.5u for each component, equal for all but 1u. An exact
// subject rounds it last. An engine normalises it in the frame of a body or of the pair and turns it, as a point, by up
// to two poses: ‖ΔR‖ < 44u and the product 5.2u each (above), < 50u with the terms of second order.
double unit_length(Precision precision) {
  const double normalised = 4, turned = 50;
  return rounding(normalised + 2 * turned, normalised, precision) * unit_roundoff(precision);
}

bool is_unit(const Vec3& n, Precision precision) { return std::abs(n.norm() - 1) <= unit_length(precision); }

// Two poses, and the same again outward, so that the box contains the body in spite of rounding.
double bounds(const Scene& scene, Precision precision) {
  return times_ulp(rounding(2 * poses, precision), scene, precision);
}

// With G the greatest |x| plus the greatest |y| on the raster, and coordinates below S + G:
//   two poses (a part's, a body's)                                     2·52u
//   a face cut by up to four lines: t = (line − p)/(q − p) to 3u, t (q − p) and p + t (q − p), |q − p| ≤ 2(S + G):
//   6u + 2u + 3u each                                                  44u
//   a line of the raster, start + i·pixel                              3u
// Together 151u(S + G). A conservative test moves its limits outward by that, gets points with that error again, and
// must take the points as larger by that much: 3·151u. 4·151u leaves room for a subject whose own error bound is not
// the tightest.
double pixel(const Scene& scene, Precision precision) {
  if (precision == Precision::exact) return 0;
  const Raster& raster = scene.raster.value();
  const auto greatest = [&](double start, int count) {
    return std::max(std::abs(start), std::abs(start + count * raster.pixel));
  };
  const double G = greatest(raster.x, raster.columns) + greatest(raster.y, raster.rows);
  return 4 * (poses + 47) * unit_roundoff(precision) * (scale(scene) + G);
}

// A side may be rounded outward to the raster's next line. A square within `pixel` of a projection is a neighbour of
// one that intersects it, if pixels are larger than that.
int pixels_around(const Scene& scene, Precision precision) {
  const double within = std::floor(pixel(scene, precision) / scene.raster.value().pixel);
  return 1 + static_cast<int>(std::min<double>(within, most_pixels_around));
}

double size(const Body& body) { return solid(body).rho; }

// A polytope as tetrahedra from its first vertex o, one for each triangle; a, b, c are relative to o, none longer than
// rho (here ρ); V_t = a·(b × c)/6. The rounding of the differences, u of each, is one of the roundings counted.
//   V_t           u each of a, b, c; two products and a difference, 3 products, 2 sums, /6: < 8u of ρ³/6 beside uV_t.
//   V = Σ V_t     n roundings more: δV ≤ (n + 8) u E.
//   M = Σ V_t·(a + b + c)/4   3 sums and a product more, terms ≤ V_t ρ: δM ≤ (n + 12) u E ρ.
//   J, second moments about o, terms ≤ V_t ρ²: δJ ≤ (n + 16) u E ρ².
//   centre c = M/V, |c| ≤ ρ: δc ≤ (δM + |c| δV)/V + u|c| ≤ (2n + 21) u Eρ/V; and o + c: u of the body's radius,
//     and 2u where o is another point, such as the mean of the vertices, since that is rounded too.
//   I = J − V(|c|²1 − ccᵀ): δI ≤ δJ + 2Vρ δc + ρ² δV + 6uVρ² ≤ (6n + 72) u E ρ².
// Times the density: 2u. A compound's parts are turned (44u, derived above) and placed (52u) within the body's radius
// ρ:
//   M_i = V_i c_i: δM_i ≤ ρ δV_i + V_i (δc_i + 52uρ); so δc ≤ (δM + ρ δV)/V + uρ ≤ (4n + 90) u Eρ/V.
//   J_i = R I_i Rᵀ + V_i(|c_i|²1 − c_i c_iᵀ): δJ_i ≤ (11n + 320) u Eρ²; less V(|c|²1 − ccᵀ): δI ≤ (20n + 508) u Eρ².
MassBound mass(const Body& body, Precision precision) {
  const Density* density = std::get_if<Density>(&body.mass);
  if (precision == Precision::exact || density == nullptr) return {};
  const bool whole = !std::holds_alternative<Compound>(body.shape);
  const Solid s = solid(body);
  const double u = unit_roundoff(precision);
  return {.mass = density->value * (s.n + 10) * u * s.E,
          .centre = (whole ? 2 * s.n + 21 : 4 * s.n + 90) * u * s.E * s.rho / s.V + 3 * u * radius(body),
          .inertia = density->value * (whole ? 6 * s.n + 74 : 20 * s.n + 510) * u * s.E * s.rho * s.rho};
}

// Given properties are returned as an engine keeps them: maybe 1/m, the moments' inverses and the principal axes.
//   m = 1/(1/m): 2u m and less than u² m. The centre: 3u of its distance from B's origin.
//   I = R D Rᵀ: the eigenvalues from five sweeps of three plane rotations, 6u‖I‖ each: 90u; 1/(1/D): 2u; R from a unit
//   quaternion, 12u an entry, twice: 42u; two products of matrices, 3u·√3 each: 11u. Together 145u‖I‖.
MassBound mass_as_kept(const MassProperties& given, Precision precision) {
  if (precision == Precision::exact) return {};
  const double u = unit_roundoff(precision);
  return {
      .mass = 3 * u * given.mass, .centre = 3 * u * given.p_BBcm.norm(), .inertia = 145 * u * given.I_BBcm_B.norm()};
}

// R p to 12u + √3·3u < 18u, subtracted and added again.
double place_as_kept(const Body& body, Precision precision) {
  return 40 * unit_roundoff(precision) * (body.X_WB.p_WB.norm() + radius(body));
}

// Into the body's axes and back, 18u each. The roundings of a pose are 4u of its parts, twice for a difference.
double velocity_as_kept(const Body& body, Precision precision, const std::optional<Stepping>& stepping) {
  const long double u = unit_roundoff(precision), rho = radius(body);
  const long double speed =
      body.velocity.v_WBcm.cast<long double>().norm() + rho * body.velocity.w_WB.cast<long double>().norm();
  const long double of_poses = stepping ? 8 * (body.X_WB.p_WB.norm() + rho) / stepping->step : 0;
  return static_cast<double>(u * (36 * speed + of_poses));
}

}  // namespace touchstone::oracle::tolerance
