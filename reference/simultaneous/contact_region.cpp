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
  std::vector<Triple> normals;  ///< one; or of parts that touch and do not approach, the extreme rays of the cone
  Triple d;
  std::vector<Triple> points;        ///< x
  std::array<double, 2> radii = {};  ///< of A and B (m)
  bool gives_normal = true;          ///< else it acts along a normal that another contact gives
};

/// None if they overlap.
std::optional<PartContact> contact_of(const Scene& pair, const PartPair& parts, const BallisticStart& a,
                                      const BallisticStart& b) {
  const Body& A = pair.bodies[0];
  const Body& B = pair.bodies[1];
  PartContact contact;
  std::optional<InitialContact> touch;
  if (parts.apart.verdict == Verdict::separated) {
    contact.d = exact(parts.apart.difference);
    contact.normals = {contact.d};
  } else {
    touch = initial_contact(A, parts.A, a, B, parts.B, b, 0);
    if (touch->kind == InitialContact::Kind::overlapping) return std::nullopt;
    contact.d = minus(touch->x, touch->y);
  }
  contact.points = closest_points_on_A(A, parts.A, B, parts.B, contact.d);
  if (touch) {
    contact.gives_normal = touch->kind == InitialContact::Kind::approaching;
    contact.normals = touch->normals;
    if (contact.gives_normal)
      contact.normals = {approach_normal(touch->normals, contact.points, contact.d, a, b, touch->n)};
  }
  contact.radii = {core_of(A, parts.A).radius, core_of(B, parts.B).radius};
  return contact;
}

bool have_one_direction(const Triple& n, const Triple& m) { return cross(n, m) == Triple{} && dot(n, m) > 0; }

/// Contacts with one normal.
struct ContactDirection {
  Triple n;
  std::vector<PartContact> contacts;
};

bool has_normal(const PartContact& contact, const Triple& n) {
  return std::ranges::any_of(contact.normals, [&](const Triple& m) { return have_one_direction(n, m); });
}

/// By the directions of the normals of those of the nearest that approach or are apart, in their order.
std::vector<ContactDirection> by_direction(const std::vector<PartContact>& contacts) {
  std::vector<ContactDirection> directions;
  for (const PartContact& contact : contacts) {
    const Triple& n = contact.normals.front();
    if (contact.gives_normal && std::ranges::none_of(directions, [&](const ContactDirection& direction) {
          return has_normal(contact, direction.n);
        }))
      directions.push_back({n, {}});
  }
  for (const PartContact& contact : contacts) {
    const auto direction =
        std::ranges::find_if(directions, [&](const ContactDirection& one) { return has_normal(contact, one.n); });
    if (direction != directions.end()) direction->contacts.push_back(contact);
  }
  return directions;
}

bool approaches(const ContactDirection& direction, const BallisticStart& a, const BallisticStart& b) {
  return std::ranges::any_of(direction.contacts, [&](const PartContact& contact) {
    return std::ranges::any_of(contact.points, [&](const Triple& x) {
      return dot(direction.n, minus(velocity(a, x), velocity(b, minus(x, contact.d)))) < 0;
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
  std::vector<PartContact> contacts;
  for (const PartPair& parts : touching) {
    std::optional<PartContact> contact = contact_of(pair, parts, a, b);
    if (!contact) continue;
    // Another direction counts only of what is as near: else a ball that slides over the seam of two parts would meet
    // the edge of the next one.
    if (parts.apart.distance.lo > touching[0].apart.distance.lo) contact->gives_normal = false;
    contacts.push_back(*std::move(contact));
  }
  std::vector<ContactRegion> regions;
  for (const ContactDirection& direction : by_direction(contacts)) {
    if (!approaches(direction, a, b)) continue;
    const Three<Float> n = float_of(direction.n);
    const Three<Float> nhat = scaled(Float(1 / sqrt(inner(n, n))), n);
    std::vector<Vec3> known;  // where two parts meet, a point is one of both
    for (const PartContact& contact : direction.contacts) {
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
