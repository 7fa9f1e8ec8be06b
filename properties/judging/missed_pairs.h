// What the two broad-phase clauses about missed pairs, of a scene and of a frame, have in common.
#pragma once

#include <string>

#include "oracle/finding.h"
#include "oracle/subject.h"

namespace touchstone::properties {

/// m: two boxes that overlap by no more may be apart as computed, and those no farther apart may overlap, by rounding
/// alone.
double rounding_of_a_pair(const Scene& scene, oracle::Precision precision);

/// Pairs are missed whose boxes overlap by up to `deepest` (m); boxes that only touch overlap by 0 and still count.
/// Where rounding alone explains it, the grade is A-.
oracle::Finding missed_pairs(const Scene& scene, const oracle::Card& card, double deepest, std::string observed);

}  // namespace touchstone::properties
