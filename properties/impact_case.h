// The doors of the impulse properties: a contact with what Newton's laws say of it, and an answer with what follows.
#pragma once

#include <array>
#include <concepts>
#include <string>
#include <utility>

#include "oracle/impact.h"
#include "oracle/judge.h"
#include "oracle/tolerance_impulse.h"
#include "properties/asking.h"

namespace touchstone::properties {

using oracle::Point;
using oracle::Real;

/// Velocities of A and B after an impact, before they are rounded.
struct Moving {
  Point v_WBcm = Point::Zero();
  Point w_WB = Point::Zero();
};
using After = std::array<Moving, 2>;

After moving(const std::array<Velocity, 2>& velocities);

/// Facts of the question that are exact on small integers: what decides between two cases does so with a margin of
/// 2⁻⁶⁰, far above long double's rounding and far below any allowance.
struct ImpactCase {
  const Scene& scene;
  const Contact& contact;
  oracle::Impact impact;
  oracle::Precision precision;

  ImpactCase(const Scene& scene, oracle::Precision precision);

  bool approaching() const { return impact.u_n() < 0; }
  Real e() const { return contact.restitution; }
  Real mu() const { return contact.friction; }

  /// mu |K_tn| ≤ K_nn, by a margin: the normal velocity never falls while the normal impulse grows. (Infinite friction
  /// and K_tn ≠ 0 are not regular.)
  bool regular() const;
  /// Does the law itself jump near this contact? By the reference; and where u_n is 0 within 1e-9 of its scale and slip
  /// may jam: nothing happens at u_n = 0, and an impulse that is not small just below it.
  bool law_jumps() const;
  bool uncoupled() const;  ///< K_tn = 0
  bool slips() const;      ///< u_t ≠ 0

  /// What an impulse P on A at C makes of the velocities.
  After moved_by(const Point& P_A_W) const;

  Real kinetic_energy(const After& after) const;  ///< of the bodies that are not fixed (J)
  bool fixed_body_moves() const;
};

/// What an answer says, and how far it may be from the law.
struct SaidImpact {
  const Impulse& answer;
  After after;
  Point u;            ///< of A's point against B's, after
  Point P;            ///< the impulse that explains u (N s)
  double allowed;     ///< √J, tolerance::impulse
  double per_normal;  ///< N s: of P·n, as |dP·n| ≤ √(K⁻¹)_nn √(dPᵀ K dP)

  SaidImpact(const ImpactCase& asked, const Impulse& said);
};

/// √(Σ m|dv|² + dwᵀ I dw): the energy norm of a difference of velocities (√J).
Real difference(const ImpactCase& asked, const After& a, const After& b);

/// A bound in √J, counted in ulps of √(uᵀ K⁻¹ u).
oracle::judge::Allowance of_energy(const ImpactCase& asked, double bound);

/// A bound counted in ulps of a size of the same unit.
oracle::judge::Allowance in_ulps_of(const ImpactCase& asked, Real size, double bound, const std::string& name);

/// Passes scenes with a contact that the subject's precision can hold to judge_it(const ImpactCase&).
template <class JudgeIt>
oracle::Finding of_impact(const Scene& scene, const oracle::Subject& subject, JudgeIt&& judge_it) {
  if (!scene.contact) return oracle::judge::outside("no contact");
  return of_scene(scene, subject, [&] {
    const ImpactCase asked(scene, subject.card().precision);
    if (!oracle::tolerance::impact_in_range(asked.impact, asked.precision)) {
      return oracle::judge::outside("squares beyond the range of the subject's precision");
    }
    return oracle::tolerance::impact_is_sure(asked.impact, asked.precision)
               ? judge_it(asked)
               : oracle::judge::outside("K is singular within the subject's precision");
  });
}

/// Asks, and passes the answer on: judge_it(const SaidImpact&).
template <class JudgeIt>
oracle::Finding answered(const ImpactCase& asked, oracle::Subject& subject, JudgeIt&& judge_it) {
  return oracle::judge::given(subject.impulse(asked.scene),
                              [&](const Impulse& said) { return judge_it(SaidImpact(asked, said)); });
}

/// Both: judge_it(const ImpactCase&, const SaidImpact&).
template <class JudgeIt>
oracle::Finding of_answered_impact(const Scene& scene, oracle::Subject& subject, JudgeIt&& judge_it) {
  return of_impact(scene, subject, [&](const ImpactCase& asked) {
    return answered(asked, subject, [&](const SaidImpact& said) { return judge_it(asked, said); });
  });
}

std::string text(const After& after);
std::string text(const Point& p);
std::string text(Real x);

}  // namespace touchstone::properties
