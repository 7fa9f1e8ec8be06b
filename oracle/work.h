// How much work an answer took, in counts that are the same on every run, and how much a subject promises at most.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace touchstone::oracle {

/// How often each kind of step was taken for one answer: "walk_step", "exact_proximity", ... A kind that is not named
/// was not taken.
using Work = std::map<std::string, std::uint64_t>;

/// A promise about the answers to one query: the count is at most base + Σ per[x]·x. A name x is another count of the
/// same answer, or a size of the scene:
/// - "bodies", "pairs" of them, and "vertices" of all bodies (a ball has one, a compound those of its parts);
/// - "frames" and "placements" of a sequence;
/// - "pixels" of a raster;
/// - "samples" of a motion, its "seconds", these times the number of bodies ("body_seconds"), and the "radians" by
///   which its bodies, but for balls about their centres, would turn until its end at their first angular velocities,
///   together;
/// - "aspect" of the most slender body, its length over its thickness (oracle/domain.h), but at most 2^20.
/// A fault that exact arithmetic or a further iteration repairs changes no answer, but breaks this.
struct WorkLimit {
  std::string query;
  std::string count;
  double base = 0;
  std::map<std::string, double> per = {};
  int placements = 0;  ///< 0: of the scene; else the sum over so many generic placements of its two convex bodies

  bool operator==(const WorkLimit&) const = default;
};

}  // namespace touchstone::oracle
