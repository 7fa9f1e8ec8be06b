// The contact points of all regions, and how the impulse at one changes the velocity at another.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "reference/exact/dense.h"
#include "reference/impulse/impact.h"
#include "reference/simultaneous.h"

namespace touchstone::reference {

/// One contact point, with the responses of its two bodies to an impulse there. The normal N is as given, of any
/// length.
struct ContactRow {
  std::size_t region;
  std::array<int, 2> bodies;
  Vec3 point_W;
  Impact impact;
};

/// Of a pair it is the lesser one.
double restitution(const Scene& scene, const ContactRegion& region);
double friction(const Scene& scene, const ContactRegion& region);

/// Throws what `impulse` throws.
std::vector<ContactRow> contact_rows(const Scene& scene, const std::vector<ContactRegion>& regions);

/// The change of N·u at `at` by an impulse P of `by`. A takes the impulse and B its opposite.
mpq_class influence(const ContactRow& at, const ContactRow& by, const Triple& P);

/// N M⁻¹ Nᵀ: the change of N·u at each row by an impulse N at each column.
RationalMatrix normal_responses(const std::vector<ContactRow>& rows);

/// N·u before.
RationalVector normal_velocities(const std::vector<ContactRow>& rows);

}  // namespace touchstone::reference
