// Exact symmetries of a scene of impacts at one time.
#pragma once

#include "reference/impact_conditions.h"

namespace touchstone::reference {

/// N9: the greatest |v' − g v'| or |ω' − g ω'| (times the longest arm), over all reflections g of coordinate axes that
/// map bodies, velocities and regions onto themselves, to the last bit of their doubles. m/s; 0 if there is no such g.
double asymmetry(const ReportedImpacts& reported, double longest_arm);

}  // namespace touchstone::reference
