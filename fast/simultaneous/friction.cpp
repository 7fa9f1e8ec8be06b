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
std::vector<double> stiffness(const std::vector<ContactRow>& centres, const std::vector<Mobility>& bodies) {
  std::vector<int> impulses(bodies.size());
  for (const ContactRow& centre : centres) {
    for (const int body : {centre.a, centre.b}) {
      if (bodies[contact::index(body)].inverse_mass > 0) ++impulses[contact::index(body)];
    }
  }
  std::vector<double> all;
  for (const ContactRow& centre : centres)
    all.push_back(centre.K_tt * std::max(impulses[contact::index(centre.a)], impulses[contact::index(centre.b)]));
  return all;
}

}  // namespace

std::vector<ContactRow> centres_of_pressure(const std::vector<Region>& regions, const std::vector<ContactRow>& points,
                                            const std::vector<Mobility>& bodies) {
  std::vector<ContactRow> centres;
  std::size_t k = 0;
  for (const Region& region : regions) {
    ContactRow& centre = centres.emplace_back(points[k]);
    Vec3 moment_A = Vec3::Zero(), moment_B = Vec3::Zero();
    double sum = 0;
    centre.P.setZero();
    for (std::size_t i = 0; i < region.points.size(); ++i, ++k) {
      const double p = points[k].n.dot(points[k].P);
      moment_A += p * points[k].arm_A;
      moment_B += p * points[k].arm_B;
      sum += p;
      centre.P += points[k].P;
    }
    if (sum > 0) centre.arm_A = moment_A / sum, centre.arm_B = moment_B / sum;
    prepare(centre, bodies);
  }
  return centres;
}

void add_friction(std::vector<ContactRow>& centres, const std::vector<Mobility>& bodies, std::vector<Twist>& twists) {
  const std::vector<double> stiff = stiffness(centres, bodies);
  std::vector<Vec3> last, next(centres.size(), Vec3::Zero());
  for (const ContactRow& centre : centres) last.push_back(friction_of(centre));
  double acceleration = 1, fastest = 0;
  bool has_ended = false;
  for (int step = 1; !has_ended; ++step) {
    mark(Mark::friction_step);
    double change = 0, turned_back = 0;
    for (std::size_t k = 0; k < centres.size(); ++k) {
      const ContactRow& centre = centres[k];
      const Vec3 u = relative_velocity(centre, twists), slip = u - centre.n.dot(u) * centre.n;
      const Vec3 P_t = friction_of(centre);
      next[k] = P_t - slip / stiff[k];
      const double size = next[k].norm(), most = centre.friction * centre.n.dot(centre.P);
      if (size > most) next[k] *= most / size;
      fastest = std::max(fastest, slip.norm() + centre.K_tt * P_t.norm());
      change = std::max(change, centre.K_tt * (next[k] - P_t).norm());
      turned_back += stiff[k] * (P_t - next[k]).dot(next[k] - last[k]);
    }
    has_ended = change <= convergence * fastest || step == most_steps;
    const double before = turned_back > 0 ? 1 : acceleration;
    acceleration = (1 + std::sqrt(1 + 4 * before * before)) / 2;
    const double further = has_ended ? 0 : (before - 1) / acceleration;
    for (std::size_t k = 0; k < centres.size(); ++k) {
      const Vec3 added = next[k] + further * (next[k] - last[k]) - friction_of(centres[k]);
      apply_impulse(centres[k], added, bodies, twists);
      centres[k].P += added;
    }
    last = next;
  }
}

void share_friction(const std::vector<Region>& regions, const std::vector<ContactRow>& centres,
                    std::vector<ContactRow>& points) {
  std::size_t k = 0;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const double sum = centres[r].n.dot(centres[r].P);
    const Vec3 friction = friction_of(centres[r]);
    for (std::size_t i = 0; i < regions[r].points.size(); ++i, ++k) {
      const double p = points[k].n.dot(points[k].P);
      points[k].P = p * points[k].n;
      if (sum > 0) points[k].P += p / sum * friction;
    }
  }
}

}  // namespace touchstone::fast::simultaneous
