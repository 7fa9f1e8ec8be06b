#include <algorithm>
#include <cstddef>
#include <utility>

#include "reference/exact/linear.h"
#include "reference/exact/rational.h"
#include "reference/impulse/exact_vectors.h"
#include "reference/simultaneous.h"
#include "reference/simultaneous/complementary.h"
#include "reference/simultaneous/contact_rows.h"
#include "reference/simultaneous/rounds.h"

namespace touchstone::reference {
namespace {

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
    result.P_A_W = exact_vec(P);
    for (int i = 0; i < 3; ++i) {
      if (sgn(p) != 0) result.centre_W[i] = nearest(mpq_class(moment[static_cast<std::size_t>(i)] / p));
    }
    for (std::size_t side = 0; side < 2; ++side)
      result.changes[side] = {exact_vec(changes[side][0]), exact_vec(changes[side][1])};
    return result;
  }
};

bool act_as_one(const ContactRegion& one, const ContactRegion& other) {
  return one.a == other.a && one.b == other.b && one.nhat_BA_W == other.nhat_BA_W;
}

NormalContacts normal_contacts(const Scene& scene, const std::vector<ContactRegion>& regions,
                               const std::vector<ContactRow>& rows) {
  NormalContacts contacts{normal_responses(rows), normal_velocities(rows), {}};
  std::vector<std::size_t> acts_in;  // by region: which one of `contacts`
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const ContactRegion& region = regions[r];
    const auto same = std::ranges::find_if(regions, [&](const ContactRegion& one) { return act_as_one(one, region); });
    const auto first = static_cast<std::size_t>(same - regions.begin());
    acts_in.push_back(first < r ? acts_in[first] : contacts.regions.size());
    if (first < r) continue;
    const auto moving = [&](int body) {
      return is_fixed(scene.bodies[index(body)]) ? std::nullopt : std::optional(body);
    };
    contacts.regions.push_back({{}, {moving(region.a), moving(region.b)}, restitution(scene, region)});
  }
  for (std::size_t k = 0; k < rows.size(); ++k) contacts.regions[acts_in[rows[k].region]].points.push_back(k);
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
  AllRounds all;
  all.impulses = summed(rows, done->impulses, regions.size());
  for (const Body& body : scene.bodies)
    all.after.push_back({exact_vec(triple(body.velocity.v_WBcm)), exact_vec(triple(body.velocity.w_WB))});
  for (std::size_t r = 0; r < regions.size(); ++r) {
    for (const auto& [body, change] :
         {std::pair(regions[r].a, &all.impulses[r].changes[0]), std::pair(regions[r].b, &all.impulses[r].changes[1])}) {
      auto& [v, w] = all.after[index(body)];
      v = exact_vec(plus(triple(v), triple(change->v_WBcm)));
      w = exact_vec(plus(triple(w), triple(change->w_WB)));
    }
  }
  all.rounds = static_cast<int>(done->rounds.size());
  all.completed = done->completed;
  return all;
}

}  // namespace touchstone::reference
