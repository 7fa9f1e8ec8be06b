#include <cmath>

#include "reference/exact/linear.h"
#include "reference/exact/rational.h"
#include "reference/simultaneous.h"
#include "reference/simultaneous/contact_rows.h"
#include "reference/simultaneous/lemke.h"

namespace touchstone::reference {
namespace {

/// u − (u·N) N/|N|².
Triple across(const Triple& u, const Triple& N) { return minus(u, scaled(mpq_class(dot(u, N) / dot(N, N)), N)); }

/// |a|, to the nearest doubles of its parts.
double length(const Triple& a) { return std::hypot(nearest(a[0]), nearest(a[1]), nearest(a[2])); }

}  // namespace

// While all points slip along t̂, each normal impulse p brings −μ p t̂, and the mean (u_n' + e u_n)/(1 + e) is
// u_n + N M⁻¹ (N − μ ν t̂)ᵀ p. It is least at C, and 0 there, if p ≥ 0 presses only where it is 0, and it is nowhere
// less.
std::optional<Vec3> sliding_centre(const Scene& scene, const ContactRegion& region) {
  const std::vector<ContactRow> rows = contact_rows(scene, {region});
  const Triple& N = rows.front().impact.N;
  const Triple slip = across(rows.front().impact.u0, N);
  for (const ContactRow& row : rows) {
    if (across(row.impact.u0, N) != slip) return std::nullopt;
  }
  const double mu = friction(scene, region), speed = length(slip);
  if (speed == 0 || !std::isfinite(mu)) return std::nullopt;
  const Triple along = minus(N, scaled(mpq_class(mpq_class(mu) * mpq_class(length(N)) / mpq_class(speed)), slip));
  RationalMatrix K;
  for (const ContactRow& at : rows) {
    RationalVector& line = K.emplace_back();
    for (const ContactRow& by : rows) line.push_back(influence(at, by, along));
  }
  const auto p = linear_complementarity(K, normal_velocities(rows));
  if (!p) return std::nullopt;
  mpq_class sum = 0;
  Triple moment;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    sum += (*p)[k];
    moment = plus(moment, scaled((*p)[k], triple(rows[k].point_W)));
  }
  if (sgn(sum) == 0) return std::nullopt;
  Vec3 centre;
  for (int i = 0; i < 3; ++i) centre[i] = nearest(mpq_class(moment[static_cast<std::size_t>(i)] / sum));
  return centre;
}

}  // namespace touchstone::reference
