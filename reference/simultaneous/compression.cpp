#include <cstddef>
#include <utility>

#include "reference/exact/linear.h"
#include "reference/exact/rational.h"
#include "reference/impulse/impact.h"
#include "reference/simultaneous.h"
#include "reference/simultaneous/complementary.h"

namespace touchstone::reference {
namespace {

/// One contact point, with the responses of its two bodies to an impulse there.
struct Row {
  std::size_t region;
  std::array<int, 2> bodies;
  Vec3 point_W;
  Impact impact;
};

Row row_of(const Scene& scene, const ContactRegion& pair, std::size_t region, const Vec3& point_W) {
  Scene two;
  two.bodies = {scene.bodies[static_cast<std::size_t>(pair.a)], scene.bodies[static_cast<std::size_t>(pair.b)]};
  two.contact.emplace();
  two.contact->p_WC = point_W;
  two.contact->nhat_BA_W = pair.nhat_BA_W;
  return {region, {pair.a, pair.b}, point_W, impact(two)};
}

/// The change of the normal velocity at `at` by an impulse N of `by`. A takes the impulse and B its opposite.
mpq_class influence(const Row& at, const Row& by) {
  mpq_class sum = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      if (at.bodies[i] != by.bodies[j]) continue;
      const Response &there = at.impact.bodies[i], &here = by.impact.bodies[j];
      const Triple moves = plus(here.linear(by.impact.N), cross(here.angular(by.impact.N), there.arm));
      const mpq_class along = dot(at.impact.N, moves);
      sum += i == j ? along : mpq_class(-along);
    }
  }
  return sum;
}

std::vector<Row> rows_of(const Scene& scene, const std::vector<ContactRegion>& regions) {
  std::vector<Row> rows;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    for (const Vec3& point : regions[r].points_W) rows.push_back(row_of(scene, regions[r], r, point));
  }
  return rows;
}

ExactVec3 exact(const Triple& v) { return {rational_of(v[0]), rational_of(v[1]), rational_of(v[2])}; }

/// The sum of a region's impulses p N at x, which is all that its two bodies know of them.
struct Wrench {
  mpq_class p;
  Triple moment;  ///< Σ p x
  Triple P;
  std::array<std::array<Triple, 2>, 2> changes;  ///< of v and w, of A and B

  void add(const Row& row, const mpq_class& impulse) {
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

}  // namespace

std::optional<std::vector<RegionImpulse>> compression(const Scene& scene, const std::vector<ContactRegion>& regions) {
  const std::vector<Row> rows = rows_of(scene, regions);
  std::vector<std::vector<mpq_class>> K;
  std::vector<mpq_class> u;
  for (const Row& at : rows) {
    K.emplace_back();
    for (const Row& by : rows) K.back().push_back(influence(at, by));
    u.push_back(dot(at.impact.N, at.impact.u0));
  }
  const auto p = complementary(K, u);
  if (!p) return std::nullopt;
  std::vector<Wrench> wrenches(regions.size());
  for (std::size_t k = 0; k < rows.size(); ++k) wrenches[rows[k].region].add(rows[k], (*p)[k]);
  std::vector<RegionImpulse> impulses;
  for (const Wrench& wrench : wrenches) impulses.push_back(wrench.impulse());
  return impulses;
}

}  // namespace touchstone::reference
