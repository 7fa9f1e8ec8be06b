#include "reference/simultaneous/rounds.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "reference/simultaneous/complementary.h"
#include "reference/simultaneous/components.h"
#include "reference/simultaneous/lemke.h"

namespace touchstone::reference {
namespace {

using Region = NormalContacts::Region;
using Indices = std::vector<std::size_t>;

constexpr std::size_t most_rounds = 64;
constexpr unsigned share_bits = 64;

/// The regions of one component, with their points numbered anew.
struct Component {
  Indices points;
  RationalMatrix K;
  RationalVector u, e;
  Indices region_of;  ///< by point

  Component(const NormalContacts& contacts, const Indices& regions) {
    for (const std::size_t r : regions) {
      for (const std::size_t point : contacts.regions[r].points) {
        points.push_back(point);
        region_of.push_back(r);
        e.push_back(contacts.regions[r].restitution);
        u.push_back(contacts.u[point]);
      }
    }
    K = part(contacts.K, points);
  }

  bool has_unlike_restitution() const {
    return std::ranges::any_of(e, [&](const mpq_class& each) { return each != e.front(); });
  }
};

/// The regions that approach, by components that share moving bodies.
std::vector<Indices> approaching_components(const NormalContacts& contacts) {
  std::vector<MovingPair> pairs;
  Indices approaching;
  for (std::size_t r = 0; r < contacts.regions.size(); ++r) {
    const Region& region = contacts.regions[r];
    pairs.push_back(region.moving);
    if (std::ranges::any_of(region.points, [&](std::size_t i) { return sgn(contacts.u[i]) < 0; }))
      approaching.push_back(r);
  }
  return components(pairs, approaching);
}

/// Of all impulses ≥ 0 with the effect of p, those with the least sum of the regions' energies. The conditions for this
/// least value, with multipliers λ = λ⁺ − λ⁻ of K p' = K p, are a linear complementarity problem in (p', λ⁺, λ⁻).
RationalVector with_least_wrenches(const Component& component, const RationalVector& p) {
  const std::size_t n = p.size();
  const RationalVector effect = times(component.K, p);
  RationalMatrix M(3 * n, RationalVector(3 * n));
  RationalVector q(3 * n);
  for (std::size_t i = 0; i < n; ++i) {
    q[n + i] = -effect[i];
    q[2 * n + i] = effect[i];
    for (std::size_t j = 0; j < n; ++j) {
      const mpq_class& K = component.K[i][j];
      if (component.region_of[i] == component.region_of[j]) M[i][j] = K;
      M[i][n + j] = M[2 * n + i][j] = -K;
      M[i][2 * n + j] = M[n + i][j] = K;
    }
  }
  RationalVector z = linear_complementarity(M, q).value();  // p itself has this effect, so there is a least one
  z.resize(n);
  return z;
}

/// The greatest s ≤ 1, a multiple of 2^-share_bits, with s² `energy` ≤ `most`.
mpq_class share(const mpq_class& energy, const mpq_class& most) {
  if (energy <= most) return 1;
  mpq_class square = most / energy;
  mpz_class scaled = square.get_num();
  scaled <<= 2 * share_bits;
  scaled /= square.get_den();
  mpz_class denominator = 1;
  denominator <<= share_bits;
  mpq_class s(mpz_class(sqrt(scaled)), denominator);
  s.canonicalize();
  return s;
}

RationalVector restitution(const Component& component, const RationalVector& p) {
  RationalVector q(p.size());
  mpq_class most = 0;  // 2 Σ e² w, with the work of compression w = ½ Σ p (−u)
  for (std::size_t i = 0; i < p.size(); ++i) {
    q[i] = component.e[i] * p[i];
    most -= component.e[i] * q[i] * component.u[i];
  }
  const mpq_class s = share(inner(q, times(component.K, q)), most);
  for (mpq_class& each : q) each *= s;
  return q;
}

}  // namespace

std::optional<ImpactRound> impact_round(const NormalContacts& contacts) {
  ImpactRound round{{}, RationalVector(contacts.u.size()), RationalVector(contacts.u.size())};
  for (const Indices& regions : approaching_components(contacts)) {
    const Component component(contacts, regions);
    std::optional<RationalVector> p = complementary(component.K, component.u);
    if (!p) return std::nullopt;
    if (component.has_unlike_restitution()) p = with_least_wrenches(component, *p);
    const RationalVector q = restitution(component, *p);
    for (std::size_t i = 0; i < component.points.size(); ++i) {
      round.p[component.points[i]] = (*p)[i];
      round.q[component.points[i]] = q[i];
    }
    round.regions.insert(round.regions.end(), regions.begin(), regions.end());
  }
  return round;
}

namespace {

/// One compression of all regions.
std::optional<ImpactRound> completion(const NormalContacts& contacts) {
  std::optional<RationalVector> p = complementary(contacts.K, contacts.u);
  if (!p) return std::nullopt;
  ImpactRound round{Indices(contacts.regions.size()), *std::move(p), RationalVector(contacts.u.size())};
  std::iota(round.regions.begin(), round.regions.end(), std::size_t{0});
  return round;
}

}  // namespace

std::optional<ImpactRounds> impact_rounds(NormalContacts contacts) {
  ImpactRounds all;
  all.impulses.resize(contacts.u.size());
  while (std::ranges::any_of(contacts.u, [](const mpq_class& u) { return sgn(u) < 0; })) {
    all.completed = all.rounds.size() == most_rounds;
    std::optional<ImpactRound> round = all.completed ? completion(contacts) : impact_round(contacts);
    if (!round) return std::nullopt;
    RationalVector impulse = round->p;
    for (std::size_t i = 0; i < impulse.size(); ++i) {
      impulse[i] += round->q[i];
      all.impulses[i] += impulse[i];
    }
    const RationalVector change = times(contacts.K, impulse);
    for (std::size_t i = 0; i < change.size(); ++i) contacts.u[i] += change[i];
    all.rounds.push_back(*std::move(round));
  }
  return all;
}

}  // namespace touchstone::reference
