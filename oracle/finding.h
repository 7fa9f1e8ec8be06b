// The result of asking one subject about one scene under one property.
#pragma once

#include <optional>
#include <string>

#include "model/frame.h"

namespace touchstone::oracle {

/// What came of asking.
enum class Outcome {
  holds,     ///< asked, answered, right
  fails,     ///< asked, answered, wrong
  abstains,  ///< the subject does not offer this; not a pass
  breaks,    ///< threw, refused, crashed, hung, or answered garbage: a failure
  outside    ///< the scene is outside the property's domain, or inexact in the subject's precision: no verdict
};

/// The kind of error, in the words of a user.
enum class Defect {
  none,
  phantom,           ///< contact or pair where there is none
  missed,            ///< no contact or pair where there is one
  too_far,           ///< distance above the truth
  too_near,          ///< distance below the truth
  overdeep,          ///< depth above the truth
  shallow,           ///< depth below the truth
  wrong_normal,      ///< direction does not separate by the stated depth
  wrong_witness,     ///< witness point off its body, or the pair's length is not the distance
  wrong_feature,     ///< claimed features contain no closest pair
  wrong_box,         ///< box does not contain the body
  loose_box,         ///< box wider than allowed
  wrong_mass,        ///< mass, centre or inertia
  wrong_velocity,    ///< velocities after an impact
  wrong_momentum,    ///< momentum created or lost, or a moment that no force at the contact has
  wrong_energy,      ///< more energy gained or lost than an impact can
  too_early,         ///< time of impact before the true one
  too_late,          ///< time of impact after the true one
  wrong_motion,      ///< a body is not where its motion takes it
  drifts,            ///< a body at rest moves
  pulls,             ///< an impulse that pulls the bodies towards each other
  beyond_cone,       ///< more friction than mu allows
  broken_enclosure,  ///< claimed interval does not contain the truth
  too_much_work,     ///< more steps than the card promises
  loose_enclosure,   ///< claimed interval is wider than rounding explains
  asymmetric,        ///< changes when the bodies swap
  moved_with_frame,  ///< changes under a rigid motion of the world
  scaled,            ///< changes with a power-of-two change of unit
  relabelled,        ///< changes with the order of bodies, vertices or axes
  nondeterministic,  ///< two answers to the same question
  inconsistent,      ///< parts of an answer, or two answers, that contradict each other
  not_finite,        ///< NaN or Inf in an answer
  threw,
  refused,  ///< the engine says that it does not take this input
  crashed,
  hung,
  garbage  ///< an answer that cannot be read
};

/// An outcome, and what a user needs to understand it. Fields that an outcome does not need are empty.
struct Finding {
  Outcome outcome = Outcome::holds;
  Defect defect = Defect::none;
  std::string observed;            ///< the subject's answer, in words and numbers
  std::string expected;            ///< the exact truth, likewise
  double error = 0;                ///< in `unit`
  double allowed = 0;              ///< in `unit`; the named bound that `error` is compared with
  std::string unit;                ///< usually "ulps of the scene's scale"
  double rounding = 0;             ///< in `unit`: what rounding explains, where the clause allows less; 0: nothing more
  std::optional<double> relative;  ///< 1: a failure's error over the exact value (infinite if that is 0), or its size
  std::optional<double> of_body;   ///< 1: a failure's error, if it is a length, over the size of the smaller body
  std::optional<Interval> margin;  ///< m: how far the input is from changing the truth
  std::string certificate;         ///< the proof of the truth, in words
  std::string why;                 ///< for abstains, breaks and outside
  long impacts = 0;                ///< simulations: the number of impacts that were compared with the reference

  bool operator==(const Finding&) const = default;
};

/// The unit of a failure without a magnitude: two answers that should be equal, a pair (2, 1), a body without an entry.
inline constexpr const char* without_size = "broken laws";

/// A failure: wrong, or no answer where one is due.
inline bool failed(const Finding& finding) {
  return finding.outcome == Outcome::fails || finding.outcome == Outcome::breaks;
}

/// A failure's error over what is allowed; in ulps, at least one is allowed. Infinite if nothing is.
double excess(const Finding& finding);

/// The enumerator itself, as case files and reports have it: "too_far".
std::string name_of(Outcome outcome);
std::string name_of(Defect defect);

}  // namespace touchstone::oracle
