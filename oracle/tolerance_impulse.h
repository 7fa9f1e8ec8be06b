// How far a careful computation of an impact may be from the law, derived in tolerance_impulse.cpp.
#pragma once

#include "model/answers.h"
#include "oracle/impact.h"
#include "oracle/subject.h"

namespace touchstone::oracle::tolerance {

/// √J: of the change of velocities in the norm √(Σ m|v|² + wᵀ I w), which for the change that an impulse error dP
/// makes is √(dPᵀ K dP); so too of a stated impulse, and of u' in K⁻¹'s norm.
double impulse(const Scene& scene, const Impact& impact, const std::array<Velocity, 2>& after, Precision precision);

/// N s: |Σ m v' − Σ m v|, after an impulse of the size |P|.
double momentum(const Scene& scene, const Impact& impact, const std::array<Velocity, 2>& after, Real impulse,
                Precision precision);

/// N m s: of one body's angular momentum about C.
double angular_momentum(const Scene& scene, const Impact& impact, std::size_t body, const Velocity& after, Real impulse,
                        Precision precision);

/// N s: of a coordinate of a stated impulse of the size |P|: of its part beyond the cone, or its pull.
double cone(Real impulse, Real friction, Precision precision);

/// Is K so far from singular that a computation in this precision is sure of a digit (and the judge, in long double, of
/// many)?
bool impact_is_sure(const Impact& impact, Precision precision);

/// Do the squares that an impact is made of stand in this precision as normal numbers, with room for their products?
bool impact_in_range(const Impact& impact, Precision precision);

}  // namespace touchstone::oracle::tolerance
