#include "reference/simultaneous/contact_rows.h"

#include <algorithm>

#include "reference/exact/linear.h"

namespace touchstone::reference {
namespace {

ContactRow row_of(const Scene& scene, const ContactRegion& pair, std::size_t region, const Vec3& point_W) {
  Scene two;
  two.bodies = {scene.bodies[index(pair.a)], scene.bodies[index(pair.b)]};
  two.contact.emplace();
  two.contact->p_WC = point_W;
  two.contact->nhat_BA_W = pair.nhat_BA_W;
  return {region, {pair.a, pair.b}, point_W, impact(two)};
}

}  // namespace

double restitution(const Scene& scene, const ContactRegion& region) {
  return std::min(scene.bodies[index(region.a)].material.restitution,
                  scene.bodies[index(region.b)].material.restitution);
}

double friction(const Scene& scene, const ContactRegion& region) {
  return std::min(scene.bodies[index(region.a)].material.friction, scene.bodies[index(region.b)].material.friction);
}

std::vector<ContactRow> contact_rows(const Scene& scene, const std::vector<ContactRegion>& regions) {
  std::vector<ContactRow> rows;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    for (const Vec3& point : regions[r].points_W) rows.push_back(row_of(scene, regions[r], r, point));
  }
  return rows;
}

mpq_class influence(const ContactRow& at, const ContactRow& by, const Triple& P) {
  mpq_class sum = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      if (at.bodies[i] != by.bodies[j]) continue;
      const Response &there = at.impact.bodies[i], &here = by.impact.bodies[j];
      const mpq_class along = dot(at.impact.N, plus(here.linear(P), cross(here.angular(P), there.arm)));
      sum += i == j ? along : mpq_class(-along);
    }
  }
  return sum;
}

RationalMatrix normal_responses(const std::vector<ContactRow>& rows) {
  RationalMatrix K;
  for (const ContactRow& at : rows) {
    RationalVector& line = K.emplace_back();
    for (const ContactRow& by : rows) line.push_back(influence(at, by, by.impact.N));
  }
  return K;
}

RationalVector normal_velocities(const std::vector<ContactRow>& rows) {
  RationalVector u;
  for (const ContactRow& row : rows) u.push_back(dot(row.impact.N, row.impact.u0));
  return u;
}

}  // namespace touchstone::reference
