// What a picture shows besides the bodies: exact and claimed separation, velocities before and after an impact.
#pragma once

#include <string>
#include <vector>

#include "oracle/case.h"
#include "oracle/truth/world_points.h"

namespace touchstone::app {

/// A line between two dots, or an arrow, in W (m).
struct Mark {
  std::string style;  ///< CSS class: exact, claim, before
  oracle::Point from, to;
  bool arrow = false;
};

struct Marks {
  std::vector<Mark> lines;
  std::string key;  ///< HTML: what the lines are; empty if the scene alone is drawn
};

/// The closest points of bodies 0 and 1; nothing if they overlap, or if there are other bodies.
Marks marks_of(const Scene& scene);

/// In addition what the finding's subject claims: its distance along the exact line, its closest points, its separating
/// translation of A beside the exact one, or its velocities after the impact. Arrows of velocities are scaled: the
/// longest is 1/2 of `extent` (m). Nothing of a case whose finding is about two answers, or has no such claim.
Marks marks_of(const oracle::Case& a_case, oracle::Real extent);

}  // namespace touchstone::app
