// From a truth and an answer to a finding: the ways in which a property reaches its verdict.
#pragma once

#include <concepts>
#include <string>
#include <type_traits>

#include "model/answers.h"
#include "oracle/finding.h"
#include "oracle/subject.h"

namespace touchstone::oracle::judge {

/// Is every number of the answer finite?
bool finite(const Masses& answer);
bool finite(const Bounds& answer);
bool finite(const PairSet& answer);
bool finite(const PairHistory& answer);
bool finite(const Distance& answer);
bool finite(const Penetration& answer);
bool finite(const Impulse& answer);
bool finite(const Pixels& answer);
bool finite(const TimeOfImpact& answer);
bool finite(const Trajectory& answer);
inline bool finite(const Work&) { return true; }  ///< counts

/// A bound, and the unit in which errors are counted against it.
struct Allowance {
  double bound = 0;  ///< SI
  double unit = 1;   ///< SI; > 0
  std::string unit_name = "ulps of the scene's scale";
  double body = 0;   ///< m: size of the smaller body, if the error is a length; else 0
  double value = 0;  ///< SI: size of the exact value; of a place on a trajectory, of the way; 0: not known in advance
};

/// `allowed` in metres, counted in ulps of the scene's scale in the subject's precision.
Allowance in_ulps(const Scene& scene, const Card& card, double allowed);

Finding holds();
Finding outside(std::string why);
Finding silent(const std::string& about_what);  ///< abstains: the answer lacks the part that is judged
Finding broken(const Breaks& breaks);
Finding not_a_number();

/// Wrong without a magnitude: the form of the answer breaks a rule, or two answers that should be equal differ.
Finding wrong(Defect defect, std::string observed, std::string expected);

/// Wrong whatever the magnitude of the error, which is reported nevertheless.
Finding wrong_by(double error, const Allowance& allowance, Defect defect, std::string observed, std::string expected);

/// Holds if `claimed` is within the bound of the interval that contains the truth. The exact value is the truth, unless
/// the allowance says another one: that of a vector or matrix of which the truth is one entry.
Finding near(double claimed, const Interval& truth, const Allowance& allowance, Defect below, Defect above);

/// Says how large a failure's error (SI) is beside the body and beside the exact value, as far as the allowance knows.
void measure(Finding& finding, double error, const Allowance& allowance);

/// Holds if error ≤ the bound. `observed` and `expected` return strings; they are called only for a failure.
template <std::invocable Observed, std::invocable Expected>
Finding at_most(double error, const Allowance& allowance, Defect defect, Observed&& observed, Expected&& expected) {
  Finding finding;
  finding.error = error / allowance.unit;
  finding.allowed = allowance.bound / allowance.unit;
  finding.unit = allowance.unit_name;
  if (error <= allowance.bound) return finding;
  finding.outcome = Outcome::fails;
  finding.defect = defect;
  measure(finding, error, allowance);
  finding.observed = observed();
  finding.expected = expected();
  return finding;
}

/// Returns the finding for a missing or non-finite answer; else calls `judge_it(const T&)`.
template <class T, std::invocable<const T&> JudgeIt>
Finding given(const Answer<T>& answer, JudgeIt&& judge_it) {
  if (const Abstains* abstains = std::get_if<Abstains>(&answer)) {
    Finding finding;
    finding.outcome = Outcome::abstains;
    finding.why = abstains->why;
    return finding;
  }
  if (const Breaks* breaks = std::get_if<Breaks>(&answer)) return broken(*breaks);
  const T& said = std::get<T>(answer);
  return finite(said) ? judge_it(said) : not_a_number();
}

/// How far the two bodies of a scene are from another verdict, m: the distance, 0, or the depth. For overlapping
/// compounds, whose depth is unknown, from a certified lower bound to infinity.
Interval margin(const Scene& scene);

/// m: how deep the two bodies of a scene surely overlap; 0 if they do not. Of compounds a certified lower bound.
double overlap(const Scene& scene);

/// A subject that is exact, or declares that it knows touching, must give the exact one of three verdicts.
bool is_held_to_touching(const Card& card);

/// The margin up to which a verdict may be wrong, m.
double verdict_allowance(const Scene& scene, const Card& card);

/// Judges a claimed verdict. A two-valued subject may be wrong where the margin is at most `tolerance::distance`, so it
/// may say either where the bodies touch. A subject that knows touching must give the exact verdict.
Finding verdict(const Scene& scene, const Card& card, Verdict said);

/// Adds margin and certificate of the scene's verdict to a finding that fails.
Finding explained(Finding finding, const Scene& scene);

/// Upper bound (a double) of the distance of a point from a body, m; 0 on the body and inside it.
double off_body(const Body& body, const Vec3& p_W);

/// Upper bound of the common depth that remains after A has moved by `translation`, m.
double depth_left(const Scene& scene, const Vec3& translation);

}  // namespace touchstone::oracle::judge
