// The preconditions of the impulse properties: a contact with its dynamics by Newton's laws, and an answer with its
// consequences.
#pragma once

#include <array>
#include <concepts>
#include <string>
#include <utility>

#include "oracle/judge/judge.h"
#include "oracle/tolerance/impulse.h"
#include "oracle/truth/impact.h"
#include "properties/judging/asking.h"

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

/// Facts of the question. They are exact for small integers: whatever decides between two cases does so with a margin
/// of 2⁻⁶⁰, far above the rounding of long double and far below any allowance.
struct ImpactCase {
  const Scene& scene;
  const Contact& contact;
  oracle::Impact impact;
  oracle::Precision precision;

  ImpactCase(const Scene& scene, oracle::Precision precision);

  bool approaching() const { return impact.u_n() < 0; }
  Real e() const { return contact.restitution; }
  Real mu() const { return contact.friction; }

  /// mu |K_tn| ≤ K_nn, with a margin: the normal velocity never falls while the normal impulse grows. (Infinite
  /// friction with K_tn ≠ 0 is not regular.)
  bool regular() const;
  /// Does the law itself jump near this contact? According to the reference, and where u_n is 0 within 1e-9 of its
  /// scale and slip may jam: at u_n = 0 nothing happens, just below it the impulse is not small.
  bool law_jumps() const;
  bool uncoupled() const;  ///< K_tn = 0
  bool slips() const;      ///< u_t ≠ 0

  /// The velocities after an impulse P on A at C.
  After moved_by(const Point& P_A_W) const;

  Real kinetic_energy(const After& after) const;  ///< of the bodies that are not fixed (J)
  bool fixed_body_moves() const;
};

/// An answer, and its allowed deviation from the law.
struct SaidImpact {
  const Impulse& answer;
  After after;
  Point u;            ///< velocity of A's point relative to B's, after
  Point P;            ///< the impulse that gives u (N s)
  double allowed;     ///< √J, tolerance::impulse
  double per_normal;  ///< N s: bound for P·n, as |dP·n| ≤ √(K⁻¹)_nn √(dPᵀ K dP)

  SaidImpact(const ImpactCase& asked, const Impulse& said);
};

/// √(Σ m|dv|² + dwᵀ I dw): the energy norm of a difference of velocities (√J).
Real difference(const ImpactCase& asked, const After& a, const After& b);

/// A bound in √J, counted in ulps of √(uᵀ K⁻¹ u).
oracle::judge::Allowance of_energy(const ImpactCase& asked, double bound);

/// A bound, counted in ulps of a size in the same unit.
oracle::judge::Allowance in_ulps_of(const ImpactCase& asked, Real size, double bound, const std::string& name);

/// Passes scenes with a contact that are exact in the subject's precision to judge_it(const ImpactCase&).
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

/// Asks the subject and passes on the answer: judge_it(const SaidImpact&).
template <class JudgeIt>
oracle::Finding answered(const ImpactCase& asked, oracle::Subject& subject, JudgeIt&& judge_it) {
  return oracle::judge::given(subject.impulse(asked.scene),
                              [&](const Impulse& said) { return judge_it(SaidImpact(asked, said)); });
}

/// Passes on both: judge_it(const ImpactCase&, const SaidImpact&).
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
