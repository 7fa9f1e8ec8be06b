#include "fast/simultaneous/friction.h"

#include <algorithm>
#include <cmath>

#include "fast/mark.h"

namespace touchstone::fast::simultaneous {
namespace {

using contact::ContactRow;
using contact::Mobility;
using contact::Twist;

constexpr int most_steps = 400;
constexpr double convergence = 0x1p-44;  // of the greatest velocity that friction acts on or has changed

/// 1/kg; the inverses of steps that do not overshoot, since |Σ x|² ≤ k Σ |x|² over the k impulses on a body.
std::vector<double> stiffness(const std::vector<ContactRow>& rows, const std::vector<Mobility>& bodies) {
  std::vector<int> impulses(bodies.size());
  for (const ContactRow& row : rows) {
    for (const int body : {row.a, row.b}) {
      if (bodies[contact::index(body)].inverse_mass > 0) ++impulses[contact::index(body)];
    }
  }
  std::vector<double> all;
  for (const ContactRow& row : rows)
    all.push_back(row.K_tt * std::max(impulses[contact::index(row.a)], impulses[contact::index(row.b)]));
  return all;
}

}  // namespace

void add_friction(std::vector<ContactRow>& rows, const std::vector<Mobility>& bodies, std::vector<Twist>& twists) {
  const std::vector<double> stiff = stiffness(rows, bodies);
  std::vector<double> rims;  // N s; μ P_n
  std::vector<Vec3> last, next(rows.size(), Vec3::Zero());
  for (const ContactRow& row : rows) {
    rims.push_back(row.friction * row.n.dot(row.P));
    last.push_back(friction_of(row));
  }
  double acceleration = 1, fastest = 0;
  bool has_ended = false;
  for (int step = 1; !has_ended; ++step) {
    mark(Mark::friction_step);
    double change = 0, turned_back = 0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const ContactRow& row = rows[k];
      const Vec3 u = relative_velocity(row, twists), slip = u - row.n.dot(u) * row.n;
      const Vec3 P_t = friction_of(row);
      next[k] = P_t - slip / stiff[k];
      const double size = next[k].norm(), most = rims[k];
      if (size > most) next[k] *= most / size;
      fastest = std::max(fastest, slip.norm() + row.K_tt * P_t.norm());
      change = std::max(change, row.K_tt * (next[k] - P_t).norm());
      turned_back += stiff[k] * (P_t - next[k]).dot(next[k] - last[k]);
    }
    has_ended = change <= convergence * fastest || step == most_steps;
    const double before = turned_back > 0 ? 1 : acceleration;
    acceleration = (1 + std::sqrt(1 + 4 * before * before)) / 2;
    const double further = has_ended ? 0 : (before - 1) / acceleration;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const Vec3 added = next[k] + further * (next[k] - last[k]) - friction_of(rows[k]);
      apply_impulse(rows[k], added, bodies, twists);
      rows[k].P += added;
    }
    last = next;
  }
}

}  // namespace touchstone::fast::simultaneous
