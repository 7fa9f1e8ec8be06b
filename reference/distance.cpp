#include "reference/distance.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "model/input_error.h"
#include "reference/distance/routes.h"
#include "reference/exact/float_mode.h"
#include "reference/exact/rational.h"
#include "reference/exact/square_root.h"

namespace touchstone::reference {
namespace {

/// The result for one pair of parts.
struct PartPair {
  PartPair(const Body& A, int a, const Body& B, int b) : part_A(a), part_B(b), posed(A, a, B, b) {}

  int part_A;
  int part_B;
  PosedPair posed;
  CoreNearest nearest;
  Rational factor;  ///< d* = factor · nearest.normal; reduced once for all quantities along d*
  Rational squared;
  Rational radii;
  Verdict verdict = Verdict::separated;
};

CoreNearest nearest_by(Route route, PosedPair& pair) {
  if (route == Route::brute_force) return nearest_by_brute_force(pair);
  if (route == Route::qp) return nearest_by_qp(pair);
  return nearest_certified(pair);
}

/// normal·(a − b), which is equal for all closest pairs.
Rational along_normal(const PosedPair& pair, const CoreNearest& n) {
  if (is_zero(n.normal)) return 0.0;
  return pair.length(dot(n.normal, pair.difference(n.face_A[0], n.face_B[0])), 1);
}

Verdict verdict_of(const PartPair& p) {
  if (p.squared.sign() == 0) return p.radii.sign() > 0 ? Verdict::overlapping : p.nearest.cores;
  const Rational excess = p.squared - p.radii * p.radii;
  return excess.sign() > 0 ? Verdict::separated : excess.sign() == 0 ? Verdict::touching : Verdict::overlapping;
}

std::unique_ptr<PartPair> part_pair(const Body& A, int part_A, const Body& B, int part_B, Route route) {
  auto p = std::make_unique<PartPair>(A, part_A, B, part_B);
  p->nearest = nearest_by(route, p->posed);
  const CoreNearest& n = p->nearest;
  p->factor = p->posed.length(n.height, n.denominator);
  p->squared = p->factor * along_normal(p->posed, n);
  p->radii = Rational(p->posed.A.radius()) + Rational(p->posed.B.radius());
  p->verdict = verdict_of(*p);
  return p;
}

bool nearer(const PartPair& p, const PartPair& q) {
  if (p.verdict != q.verdict) return p.verdict > q.verdict;
  return p.verdict == Verdict::separated && compare_roots(p.squared, q.squared, p.radii - q.radii) < 0;
}

std::unique_ptr<PartPair> nearest_parts(const Body& A, const Body& B, Route route) {
  std::unique_ptr<PartPair> best;
  for (int a = 0; a < part_count(A); ++a) {
    for (int b = 0; b < part_count(B); ++b) {
      std::unique_ptr<PartPair> candidate = part_pair(A, a, B, b, route);
      if (!best || nearer(*candidate, *best)) best = std::move(candidate);
    }
  }
  return best;
}

Certificate certificate_of(const PartPair& p, const DistanceTruth& truth) {
  const CoreNearest& n = p.nearest;
  Certificate c;
  c.cores = n.cores;
  c.part_A = p.part_A;
  c.part_B = p.part_B;
  if (n.cores == Verdict::separated) c.direction = truth.difference;
  if (n.cores == Verdict::touching) {
    c.direction = {rational(n.direction.x), rational(n.direction.y), rational(n.direction.z)};
  }
  c.pairs = n.pairs;
  for (const Integer& weight : n.weights) c.weights.push_back(rational(fraction(weight, n.total)));
  return c;
}

/// a* and b*, the closest points of the cores. They are only rounded to doubles, so they are not reduced to lowest
/// terms: that would cost more than finding them.
struct ClosestPoints {
  IntegerVec a;
  IntegerVec b;
  Integer den;
};

ClosestPoints closest_points(const CoreNearest& n) {
  const IntegerVec known = n.denominator * n.point.num;
  const IntegerVec d = Integer(n.height * n.point.den) * n.normal;
  const Integer den = n.denominator * n.point.den;
  if (n.point_is_of_B) return {known + d, known, den};
  return {known, known - d, den};
}

/// core + reach · d*/|d*|, rounded to doubles. The root's 300 bits are far more than a double needs.
Vec3 swollen(const PosedPair& pair, const IntegerVec& num, const Integer& den, const DistanceTruth& truth,
             double reach) {
  if (reach == 0 || truth.core_squared.sign() == 0) return pair.nearest_point(num, den);
  const RationalVec3 core = pair.point(num, den);
  const Rational step =
      Rational(reach) * rational(root_bounds(truth.core_squared.impl().value, 300).lo) / truth.core_squared;
  const RationalVec3& d = truth.difference;
  return {(core.x + step * d.x).nearest(), (core.y + step * d.y).nearest(), (core.z + step * d.z).nearest()};
}

DistanceTruth truth_of(const PartPair& p) {
  const CoreNearest& n = p.nearest;
  DistanceTruth truth;
  truth.verdict = p.verdict;
  truth.part_A = p.part_A;
  truth.part_B = p.part_B;
  truth.core_squared = p.squared;
  truth.radius_sum = p.radii;
  truth.difference = {p.factor * rational(n.normal.x), p.factor * rational(n.normal.y),
                      p.factor * rational(n.normal.z)};
  truth.feature_A = {p.part_A, n.face_A};
  truth.feature_B = {p.part_B, n.face_B};
  const ClosestPoints closest = closest_points(n);
  truth.p_WCa = swollen(p.posed, closest.a, closest.den, truth, -p.posed.A.radius());
  truth.p_WCb = swollen(p.posed, closest.b, closest.den, truth, p.posed.B.radius());
  if (truth.verdict == Verdict::separated)
    truth.distance = enclosure_of_root_minus(truth.core_squared, truth.radius_sum);
  truth.certificate = certificate_of(p, truth);
  return truth;
}

}  // namespace

Rational squared_distance(const PosedPair& pair, const CoreNearest& nearest) {
  return pair.length(nearest.height, nearest.denominator) * along_normal(pair, nearest);
}

DistanceTruth distance(const Scene& scene, Route route) {
  if (scene.bodies.size() < 2) throw InputError("bodies", "two are needed for a distance");
  const DefaultFloatMode mode;
  return truth_of(*nearest_parts(scene.bodies[0], scene.bodies[1], route));
}

Interval distance_to_body(const Body& body, const Vec3& p_W) {
  const DefaultFloatMode mode;
  const Body point = {"point", Sphere{1}, {p_W, {}}, {}, {}, Fixed{}};
  Interval least = {INFINITY, INFINITY};
  for (int part = 0; part < part_count(body); ++part) {
    PosedPair pair(body, part, point, 0);
    const CoreNearest n = nearest_certified(pair);
    const Rational squared = squared_distance(pair, n);
    const Rational radius = pair.A.radius();
    if (squared <= radius * radius) return {0, 0};
    const Interval gap = enclosure_of_root_minus(squared, radius);
    least = {std::min(least.lo, gap.lo), std::min(least.hi, gap.hi)};
  }
  return least;
}

}  // namespace touchstone::reference
