#include <algorithm>

#include "reference/ballistic_motion.h"
#include "reference/distance.h"
#include "reference/exact/linear.h"
#include "reference/exact/rational.h"
#include "reference/simultaneous.h"
#include "reference/simultaneous/complementary.h"
#include "reference/time_of_impact/initial_contact.h"

namespace touchstone::reference {
namespace {

Triple exact(const RationalVec3& v) { return {value_of(v.x), value_of(v.y), value_of(v.z)}; }

Vec3 rounded(const Three<Float>& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

Scene pair_of(const Scene& scene, int a, int b) {
  Scene pair;
  pair.bodies = {scene.bodies[static_cast<std::size_t>(a)], scene.bodies[static_cast<std::size_t>(b)]};
  pair.gravity = scene.gravity;
  pair.motion = touchstone::Motion{.sample_times = scene.motion->sample_times};
  return pair;
}

/// Of bodies that touch: the direction of the projection of −u onto the cone of normals (docs/design/simultaneous.md),
/// with u at the mean of the extreme points x of the contact region. `otherwise`: if that is 0.
Triple approach_normal(const std::vector<Triple>& normals, const std::vector<Triple>& points, const Triple& d,
                       const BallisticStart& a, const BallisticStart& b, const Triple& otherwise) {
  Triple u;
  for (const Triple& x : points) u = plus(u, minus(velocity(a, x), velocity(b, minus(x, d))));
  RationalMatrix K;
  RationalVector along;
  for (const Triple& n : normals) {
    RationalVector& row = K.emplace_back();
    for (const Triple& m : normals) row.push_back(dot(n, m));
    along.push_back(dot(n, u));
  }
  const std::optional<RationalVector> p = complementary(K, along);
  Triple n;
  for (std::size_t k = 0; p && k < normals.size(); ++k) n = plus(n, scaled((*p)[k], normals[k]));
  return n == Triple{} ? otherwise : n;
}

double radius(const Body& body, int part) { return core_of(body, part).radius; }

}  // namespace

std::optional<ContactRegion> approaching_region(const Scene& scene, int index_a, int index_b) {
  const Scene pair = pair_of(scene, index_a, index_b);
  const Body& A = pair.bodies[0];
  const Body& B = pair.bodies[1];
  const DistanceTruth apart = distance(pair);
  const BallisticStart a = ballistic_start(pair, 0), b = ballistic_start(pair, 1);
  std::optional<InitialContact> touch;
  Triple n, d;  // from B to A; x − y of closest points of the cores
  if (apart.verdict == Verdict::separated) {
    n = d = exact(apart.difference);
  } else {
    touch = initial_contact(A, apart.part_A, a, B, apart.part_B, b, 0);
    if (touch->kind != InitialContact::Kind::approaching) return std::nullopt;
    d = minus(touch->x, touch->y);
  }
  const std::vector<Triple> points = closest_points_on_A(A, apart.part_A, B, apart.part_B, d);
  if (touch) n = approach_normal(touch->normals, points, d, a, b, touch->n);
  const auto approaches = [&](const Triple& x) { return dot(n, minus(velocity(a, x), velocity(b, minus(x, d)))) < 0; };
  if (std::ranges::none_of(points, approaches)) return std::nullopt;
  const Three<Float> unnormalised = float_of(n);
  const Three<Float> nhat = scaled(Float(1 / sqrt(inner(unnormalised, unnormalised))), unnormalised);
  const Float half(0.5);
  const Float lean = half * (Float(radius(B, apart.part_B)) - Float(radius(A, apart.part_A)));
  ContactRegion region{index_a, index_b, rounded(nhat), {}};
  for (const Triple& x : points) {
    region.points_W.push_back(rounded(plus(scaled(half, float_of(plus(x, minus(x, d)))), scaled(lean, nhat))));
  }
  return region;
}

}  // namespace touchstone::reference
