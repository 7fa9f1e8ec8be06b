// Laws shared by distance and penetration: an exact change of the pair keeps the verdict and scales the value.
#pragma once

#include <optional>

#include "oracle/finding.h"
#include "oracle/subject.h"

namespace touchstone::properties {

/// What both answers have: a verdict and one length.
struct Said {
  std::optional<Verdict> verdict;
  std::optional<double> length;
};

inline Said said(const Distance& answer) { return {answer.verdict, answer.distance}; }
inline Said said(const Penetration& answer) { return {answer.verdict, answer.depth}; }

/// Asks about both scenes, whose true lengths differ by the factor `times`. The second length must be the first times
/// that factor within both roundings, and the verdict the same unless the pair is within rounding of touching.
oracle::Finding distance_unchanged(const Scene& before, const std::optional<Scene>& after, double times,
                                   oracle::Subject& subject, oracle::Defect defect);
oracle::Finding penetration_unchanged(const Scene& before, const std::optional<Scene>& after, double times,
                                      oracle::Subject& subject, oracle::Defect defect);

/// An exact rigid motion of the world: by 120°, or by 180° where that would round.
std::optional<Scene> some_turn(const Scene& scene);

}  // namespace touchstone::properties
