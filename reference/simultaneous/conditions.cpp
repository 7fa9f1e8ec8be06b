#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "reference/exact/linear.h"
#include "reference/exact/rational.h"
#include "reference/impact_conditions.h"
#include "reference/motion/moving_mass.h"
#include "reference/simultaneous/complementary.h"
#include "reference/simultaneous/components.h"
#include "reference/simultaneous/contact_rows.h"
#include "reference/simultaneous/simplex.h"
#include "reference/simultaneous/symmetry.h"

namespace touchstone::reference {
namespace {

using Errors = std::array<double, impact_conditions>;
using Indices = std::vector<std::size_t>;

double root(const mpq_class& square) { return std::sqrt(nearest(square)); }

double quotient(const mpq_class& part, const mpq_class& whole) {
  if (sgn(part) == 0) return 0;
  return sgn(whole) == 0 ? HUGE_VAL : nearest(mpq_class(part / whole));
}

/// A velocity, or a change of one, as an exact number.
struct ExactTwist {
  Triple v, w;
};

ExactTwist exact(const Velocity& V) { return {triple(V.v_WBcm), triple(V.w_WB)}; }

/// Mass and inertia of a body; none of a fixed one.
class Weight {
 public:
  Weight(const Body& body, std::size_t at) : axes_(motion(body.X_WB).rows) {
    if (!is_fixed(body)) mass_ = moving_mass(body, "bodies[" + std::to_string(at) + "]");
  }

  bool moves() const { return mass_.has_value(); }

  /// m v² + ωᵀ I ω: twice the kinetic energy.
  mpq_class twice_energy(const ExactTwist& twist) const {
    if (!mass_) return 0;
    Triple w_B;  // Rᵀ w
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) w_B[i] += axes_[j][i] * twist.w[j];
    }
    return mass_->mass * dot(twist.v, twist.v) + dot(w_B, times(mass_->inertia, w_B));
  }

 private:
  std::array<Triple, 3> axes_;
  std::optional<MovingMass> mass_;
};

/// All that is reported, in exact numbers.
struct Exact {
  explicit Exact(const ReportedImpacts& all) : reported(all), corners(contact_rows(all.before, all.regions)) {
    std::vector<ContactRegion> at;
    for (const ReportedImpacts::Impulse& impulse : all.impulses) {
      at.push_back(all.regions[impulse.region]);
      at.back().points_W = {impulse.point_W};
    }
    impulses = contact_rows(all.before, at);
    for (std::size_t i = 0; i < all.before.bodies.size(); ++i) {
      const Body& body = all.before.bodies[i];
      weights.emplace_back(body, i);
      before.push_back(exact(body.velocity));
      after.push_back(exact(all.after[i]));
      change.push_back({minus(after[i].v, before[i].v), minus(after[i].w, before[i].w)});
      fixed_ones_rest &= !is_fixed(body) || (before[i].v == Triple{} && before[i].w == Triple{});
    }
  }

  /// N·u after at a corner.
  mpq_class normal_velocity_after(const ContactRow& row) const {
    Triple u = row.impact.u0;
    for (std::size_t side = 0; side < 2; ++side) {
      const std::size_t i = index(row.bodies[side]);
      if (!weights[i].moves()) continue;
      const Triple moves = plus(change[i].v, cross(change[i].w, row.impact.bodies[side].arm));
      u = side == 0 ? plus(u, moves) : minus(u, moves);
    }
    return dot(row.impact.N, u);
  }

  mpq_class twice_energy(const std::vector<ExactTwist>& twists, const Indices& bodies) const {
    mpq_class sum = 0;
    for (const std::size_t i : bodies) sum += weights[i].twice_energy(twists[i]);
    return sum;
  }

  const ReportedImpacts& reported;
  std::vector<ContactRow> corners, impulses;
  std::vector<Weight> weights;
  std::vector<ExactTwist> before, after, change;
  bool fixed_ones_rest = true;
};

Indices all_of(std::size_t count) {
  Indices all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

/// N1.
double momentum_error(const Exact& exact) {
  std::vector<ExactTwist> left = exact.change;
  std::vector<mpq_class> scale;
  for (std::size_t i = 0; i < left.size(); ++i)
    scale.emplace_back(exact.weights[i].twice_energy(exact.before[i]) + exact.weights[i].twice_energy(exact.after[i]));
  for (std::size_t k = 0; k < exact.impulses.size(); ++k) {
    const Triple P = triple(exact.reported.impulses[k].P_A_W);
    for (std::size_t side = 0; side < 2; ++side) {
      const Response& response = exact.impulses[k].impact.bodies[side];
      const Triple on_side = side == 0 ? P : scaled(mpq_class(-1), P);
      const ExactTwist moves{response.linear(on_side), response.angular(on_side)};
      const std::size_t i = index(exact.impulses[k].bodies[side]);
      left[i] = {minus(left[i].v, moves.v), minus(left[i].w, moves.w)};
      scale[i] += exact.weights[i].twice_energy(moves);
    }
  }
  double worst = 0;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (!exact.weights[i].moves()) {
      if (exact.change[i].v != Triple{} || exact.change[i].w != Triple{}) return HUGE_VAL;
      continue;
    }
    worst = std::max(worst, std::sqrt(quotient(exact.weights[i].twice_energy(left[i]), scale[i])));
  }
  return worst;
}

/// N2.
double cone_error(const Exact& exact) {
  double worst = 0;
  for (std::size_t k = 0; k < exact.impulses.size(); ++k) {
    const Triple P = triple(exact.reported.impulses[k].P_A_W), &N = exact.impulses[k].impact.N;
    const mpq_class square = dot(P, P), p = dot(P, N), n = dot(N, N);
    const double mu = friction(exact.reported.before, exact.reported.regions[exact.reported.impulses[k].region]);
    if (sgn(p) < 0) worst = std::max(worst, std::sqrt(quotient(p * p / n, square)));
    if (!std::isfinite(mu) || sgn(p) < 0) continue;
    const mpq_class across = square - p * p / n;
    if (across <= mpq_class(mu) * mpq_class(mu) * p * p / n) continue;
    worst = std::max(worst, (root(across) - mu * root(mpq_class(p * p / n))) / root(square));
  }
  return worst;
}

/// N3.
double place_error(const Exact& exact) {
  double worst = 0;
  for (std::size_t k = 0; k < exact.impulses.size(); ++k) {
    const Triple x = triple(exact.reported.impulses[k].point_W);
    std::vector<Triple> offsets;
    for (const Vec3& corner : exact.reported.regions[exact.reported.impulses[k].region].points_W)
      offsets.push_back(minus(triple(corner), x));
    RationalMatrix Q;
    for (const Triple& a : offsets) {
      RationalVector& line = Q.emplace_back();
      for (const Triple& b : offsets) line.push_back(dot(a, b));
    }
    mpq_class arms = 0;
    for (const Response& response : exact.impulses[k].impact.bodies) arms += dot(response.arm, response.arm);
    worst = std::max(worst, std::sqrt(quotient(least_on_simplex(Q), arms)));
  }
  return worst;
}

/// The greatest speed of a corner before or after, and of a body.
double greatest_speed(const Exact& exact) {
  double greatest = 0;
  for (const ContactRow& row : exact.corners) greatest = std::max(greatest, root(dot(row.impact.u0, row.impact.u0)));
  for (std::size_t i = 0; i < exact.before.size(); ++i) {
    for (const std::vector<ExactTwist>* twists : {&exact.before, &exact.after})
      greatest = std::max(greatest, root(dot((*twists)[i].v, (*twists)[i].v)));
  }
  return greatest;
}

/// N4, in m/s.
double approach_left(const Exact& exact) {
  double worst = 0;
  for (const ContactRow& row : exact.corners) {
    const mpq_class u = exact.normal_velocity_after(row);
    if (sgn(u) < 0) worst = std::max(worst, -nearest(u) / root(dot(row.impact.N, row.impact.N)));
  }
  return worst;
}

bool is_frictionless(const Exact& exact, const Indices& regions) {
  return std::ranges::all_of(
      regions, [&](std::size_t r) { return friction(exact.reported.before, exact.reported.regions[r]) == 0; });
}

/// Regions, the bodies that move which they connect, and their corners.
struct Connected {
  Indices regions, bodies, rows;
};

std::vector<Connected> connected(const Exact& exact) {
  std::vector<MovingPair> pairs;
  const auto moving = [&](int body) { return exact.weights[index(body)].moves() ? std::optional(body) : std::nullopt; };
  for (const ContactRegion& region : exact.reported.regions) pairs.push_back({moving(region.a), moving(region.b)});
  std::vector<Connected> all;
  for (Indices& regions : components(pairs, all_of(pairs.size()))) {
    std::set<std::size_t> bodies;
    for (const std::size_t r : regions) {
      for (const std::optional<int>& body : pairs[r]) {
        if (body) bodies.insert(index(*body));
      }
    }
    Connected& each = all.emplace_back(Connected{std::move(regions), {bodies.begin(), bodies.end()}, {}});
    for (std::size_t k = 0; k < exact.corners.size(); ++k) {
      if (std::ranges::binary_search(each.regions, exact.corners[k].region)) each.rows.push_back(k);
    }
  }
  return all;
}

double& at(Errors& errors, ImpactCondition condition) { return errors[static_cast<std::size_t>(condition)]; }

/// N5 and N7.
void check_energy(const Exact& exact, const RationalMatrix& K, const RationalVector& u, Errors& errors) {
  if (!exact.fixed_ones_rest) return;
  const Indices bodies = all_of(exact.weights.size()), regions = all_of(exact.reported.regions.size());
  const mpq_class before = exact.twice_energy(exact.before, bodies), after = exact.twice_energy(exact.after, bodies);
  const bool frictionless = is_frictionless(exact, regions);
  const bool newton = exact.reported.before.motion && exact.reported.before.motion->law == Law::newton;
  if (after > before && (frictionless || !newton))
    at(errors, ImpactCondition::energy) = quotient(after - before, before);
  if (!frictionless) return;
  const auto p = complementary(K, u);
  if (!p) return;
  const mpq_class least = before + inner(u, *p);  // 2 u·p + pᵀKp, and pᵀKp = −u·p
  if (after < least) at(errors, ImpactCondition::least_energy) = quotient(least - after, before);
}

/// N6 and N8.
void check_connected(const Exact& exact, const Connected& part_of, const RationalMatrix& K, const RationalVector& u,
                     Errors& errors) {
  const bool approaches = std::ranges::any_of(part_of.rows, [&](std::size_t k) { return sgn(u[k]) < 0; });
  const mpq_class before = exact.twice_energy(exact.before, part_of.bodies),
                  after = exact.twice_energy(exact.after, part_of.bodies);
  if (!approaches) {
    double& worst = at(errors, ImpactCondition::untouched);
    worst = std::max(worst,
                     std::sqrt(quotient(exact.twice_energy(exact.change, part_of.bodies), mpq_class(before + after))));
  }
  const bool elastic = std::ranges::all_of(part_of.regions, [&](std::size_t r) {
    return restitution(exact.reported.before, exact.reported.regions[r]) == 1;
  });
  if (!elastic || !exact.fixed_ones_rest || !is_frictionless(exact, part_of.regions)) return;
  if (before == after || sgn(least_on_simplex(part(K, part_of.rows))) == 0) return;  // 0: impulses cancel (Gordan)
  double& worst = at(errors, ImpactCondition::elastic);
  worst = std::max(worst, quotient(abs(mpq_class(after - before)), before));
}

}  // namespace

Errors condition_errors(const ReportedImpacts& reported) {
  const Exact exact(reported);
  const RationalMatrix K = normal_responses(exact.corners);
  const RationalVector u = normal_velocities(exact.corners);
  Errors errors{};
  at(errors, ImpactCondition::momentum) = momentum_error(exact);
  at(errors, ImpactCondition::cone) = cone_error(exact);
  at(errors, ImpactCondition::place) = place_error(exact);
  check_energy(exact, K, u, errors);
  for (const Connected& each : connected(exact)) check_connected(exact, each, K, u, errors);
  const double speed = greatest_speed(exact);
  if (speed == 0) return errors;
  mpq_class longest = 0;
  for (const ContactRow& row : exact.corners) {
    for (const Response& response : row.impact.bodies) longest = std::max(longest, dot(response.arm, response.arm));
  }
  at(errors, ImpactCondition::separation) = approach_left(exact) / speed;
  at(errors, ImpactCondition::symmetry) = asymmetry(reported, root(longest)) / speed;
  return errors;
}

std::optional<ImpactCondition> violated(const ReportedImpacts& reported, double allowed) {
  const Errors errors = condition_errors(reported);
  for (std::size_t k = 0; k < errors.size(); ++k) {
    if (!(errors[k] <= allowed)) return static_cast<ImpactCondition>(k);
  }
  return std::nullopt;
}

}  // namespace touchstone::reference
