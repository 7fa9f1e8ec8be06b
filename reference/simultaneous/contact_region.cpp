#include <algorithm>
#include <array>
#include <utility>

#include "model/parts.h"
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

/// Two parts, by index in A and in B, and how far they are apart.
struct PartPair {
  int A = 0, B = 0;
  DistanceTruth apart;
};

/// The nearest pairs of parts, and those that are no farther apart than `within`; the nearest first.
std::vector<PartPair> touching_parts(const Scene& pair, double within) {
  std::vector<PartPair> all;
  Scene parts;
  for (int a = 0; a < part_count(pair.bodies[0]); ++a) {
    for (int b = 0; b < part_count(pair.bodies[1]); ++b) {
      parts.bodies = {part_alone(pair.bodies[0], a), part_alone(pair.bodies[1], b)};
      all.push_back({a, b, distance(parts)});
    }
  }
  const auto least = [](const PartPair& two) { return two.apart.distance.lo; };
  const double most = std::max(within, std::ranges::min(all, {}, least).apart.distance.lo);
  std::erase_if(all, [&](const PartPair& two) { return least(two) > most; });
  std::ranges::stable_sort(all, {}, least);
  return all;
}

/// Where two parts touch or nearly do: x − y = d for all closest points x, y of their cores.
struct PartContact {
  Triple n, d;
  std::vector<Triple> points;        ///< x
  std::array<double, 2> radii = {};  ///< of A and B (m)
};

/// None if they overlap, or touch without approaching.
std::optional<PartContact> contact_of(const Scene& pair, const PartPair& parts, const BallisticStart& a,
                                      const BallisticStart& b) {
  const Body& A = pair.bodies[0];
  const Body& B = pair.bodies[1];
  PartContact contact;
  std::optional<InitialContact> touch;
  if (parts.apart.verdict == Verdict::separated) {
    contact.n = contact.d = exact(parts.apart.difference);
  } else {
    touch = initial_contact(A, parts.A, a, B, parts.B, b, 0);
    if (touch->kind != InitialContact::Kind::approaching) return std::nullopt;
    contact.d = minus(touch->x, touch->y);
  }
  contact.points = closest_points_on_A(A, parts.A, B, parts.B, contact.d);
  if (touch) contact.n = approach_normal(touch->normals, contact.points, contact.d, a, b, touch->n);
  contact.radii = {core_of(A, parts.A).radius, core_of(B, parts.B).radius};
  return contact;
}

bool have_one_direction(const Triple& n, const Triple& m) { return cross(n, m) == Triple{} && dot(n, m) > 0; }

/// By the directions of their normals, in the order of the first of each.
void add_to(std::vector<std::vector<PartContact>>& groups, const PartContact& contact, bool is_nearest) {
  const auto known =
      std::ranges::find_if(groups, [&](const auto& group) { return have_one_direction(group[0].n, contact.n); });
  if (known != groups.end()) {
    known->push_back(contact);
  } else if (is_nearest) {
    groups.push_back({contact});
  }
}

bool approaches(const std::vector<PartContact>& group, const BallisticStart& a, const BallisticStart& b) {
  return std::ranges::any_of(group, [&](const PartContact& contact) {
    return std::ranges::any_of(contact.points, [&](const Triple& x) {
      return dot(group[0].n, minus(velocity(a, x), velocity(b, minus(x, contact.d)))) < 0;
    });
  });
}

/// Between the surfaces of A and B.
std::vector<Vec3> midpoints(const PartContact& contact, const Three<Float>& nhat) {
  const Float half(0.5), lean = half * (Float(contact.radii[1]) - Float(contact.radii[0]));
  std::vector<Vec3> points;
  for (const Triple& x : contact.points) {
    const Triple twice = plus(x, minus(x, contact.d));
    points.push_back(rounded(plus(scaled(half, float_of(twice)), scaled(lean, nhat))));
  }
  return points;
}

}  // namespace

std::vector<ContactRegion> approaching_regions(const Scene& scene, int index_a, int index_b, double within) {
  const Scene pair = pair_of(scene, index_a, index_b);
  const BallisticStart a = ballistic_start(pair, 0), b = ballistic_start(pair, 1);
  const std::vector<PartPair> touching = touching_parts(pair, within);
  std::vector<std::vector<PartContact>> groups;
  for (const PartPair& parts : touching) {
    // Another direction counts only of what is as near: else a ball that slides over the seam of two parts would meet
    // the edge of the next one.
    const bool is_nearest = parts.apart.distance.lo <= touching[0].apart.distance.lo;
    if (const std::optional<PartContact> contact = contact_of(pair, parts, a, b)) add_to(groups, *contact, is_nearest);
  }
  std::vector<ContactRegion> regions;
  for (const std::vector<PartContact>& group : groups) {
    if (!approaches(group, a, b)) continue;
    const Three<Float> n = float_of(group[0].n);
    const Three<Float> nhat = scaled(Float(1 / sqrt(inner(n, n))), n);
    std::vector<Vec3> known;  // where two parts meet, a point is one of both
    for (const PartContact& contact : group) {
      ContactRegion region{index_a, index_b, rounded(nhat), {}};
      for (const Vec3& point : midpoints(contact, nhat)) {
        if (std::ranges::find(known, point) == known.end()) region.points_W.push_back(point);
      }
      known.insert(known.end(), region.points_W.begin(), region.points_W.end());
      if (!region.points_W.empty()) regions.push_back(std::move(region));
    }
  }
  return regions;
}

}  // namespace touchstone::reference
