#include <algorithm>
#include <cstddef>
#include <utility>

#include "reference/exact/linear.h"
#include "reference/exact/rational.h"
#include "reference/simultaneous.h"
#include "reference/simultaneous/complementary.h"
#include "reference/simultaneous/contact_rows.h"
#include "reference/simultaneous/rounds.h"

namespace touchstone::reference {
namespace {

ExactVec3 exact(const Triple& v) { return {rational_of(v[0]), rational_of(v[1]), rational_of(v[2])}; }

/// The sum of a region's impulses p N at x, which is all that its two bodies know of them.
struct Wrench {
  mpq_class p;
  Triple moment;  ///< Σ p x
  Triple P;
  std::array<std::array<Triple, 2>, 2> changes;  ///< of v and w, of A and B

  void add(const ContactRow& row, const mpq_class& impulse) {
    const Triple P_A = scaled(impulse, row.impact.N);
    p += impulse;
    moment = plus(moment, scaled(impulse, triple(row.point_W)));
    P = plus(P, P_A);
    for (std::size_t side = 0; side < 2; ++side) {
      const Triple on_side = side == 0 ? P_A : scaled(mpq_class(-1), P_A);
      changes[side][0] = plus(changes[side][0], row.impact.bodies[side].linear(on_side));
      changes[side][1] = plus(changes[side][1], row.impact.bodies[side].angular(on_side));
    }
  }

  RegionImpulse impulse() const {
    RegionImpulse result;
    result.P_A_W = exact(P);
    for (int i = 0; i < 3; ++i) {
      if (sgn(p) != 0) result.centre_W[i] = nearest(mpq_class(moment[static_cast<std::size_t>(i)] / p));
    }
    for (std::size_t side = 0; side < 2; ++side)
      result.changes[side] = {exact(changes[side][0]), exact(changes[side][1])};
    return result;
  }
};

mpq_class restitution(const Scene& scene, const ContactRegion& region) {
  const auto of = [&](int body) { return scene.bodies[static_cast<std::size_t>(body)].material.restitution; };
  return std::min(of(region.a), of(region.b));
}

NormalContacts normal_contacts(const Scene& scene, const std::vector<ContactRegion>& regions,
                               const std::vector<ContactRow>& rows) {
  NormalContacts contacts{normal_responses(rows), normal_velocities(rows), {}};
  for (const ContactRegion& region : regions) {
    const auto moving = [&](int body) {
      return is_fixed(scene.bodies[static_cast<std::size_t>(body)]) ? std::nullopt : std::optional(body);
    };
    contacts.regions.push_back({{}, {moving(region.a), moving(region.b)}, restitution(scene, region)});
  }
  for (std::size_t k = 0; k < rows.size(); ++k) contacts.regions[rows[k].region].points.push_back(k);
  return contacts;
}

std::vector<RegionImpulse> summed(const std::vector<ContactRow>& rows, const RationalVector& impulses,
                                  std::size_t regions) {
  std::vector<Wrench> wrenches(regions);
  for (std::size_t k = 0; k < rows.size(); ++k) wrenches[rows[k].region].add(rows[k], impulses[k]);
  std::vector<RegionImpulse> of;
  for (const Wrench& wrench : wrenches) of.push_back(wrench.impulse());
  return of;
}

}  // namespace

std::optional<std::vector<RegionImpulse>> compression(const Scene& scene, const std::vector<ContactRegion>& regions) {
  const std::vector<ContactRow> rows = contact_rows(scene, regions);
  const auto p = complementary(normal_responses(rows), normal_velocities(rows));
  if (!p) return std::nullopt;
  return summed(rows, *p, regions.size());
}

std::optional<AllRounds> all_rounds(const Scene& scene, const std::vector<ContactRegion>& regions) {
  const std::vector<ContactRow> rows = contact_rows(scene, regions);
  const auto done = impact_rounds(normal_contacts(scene, regions, rows));
  if (!done) return std::nullopt;
  std::vector<std::array<Triple, 2>> velocities;
  for (const Body& body : scene.bodies)
    velocities.push_back({triple(body.velocity.v_WBcm), triple(body.velocity.w_WB)});
  for (std::size_t k = 0; k < rows.size(); ++k) {
    Wrench wrench;
    wrench.add(rows[k], done->impulses[k]);
    for (std::size_t side = 0; side < 2; ++side) {
      auto& [v, w] = velocities[static_cast<std::size_t>(rows[k].bodies[side])];
      v = plus(v, wrench.changes[side][0]);
      w = plus(w, wrench.changes[side][1]);
    }
  }
  AllRounds all;
  all.impulses = summed(rows, done->impulses, regions.size());
  for (const auto& [v, w] : velocities) all.after.push_back({exact(v), exact(w)});
  all.rounds = static_cast<int>(done->rounds.size());
  all.completed = done->completed;
  return all;
}

}  // namespace touchstone::reference
