// Error bounds of a careful computation of an impact, derived in oracle/tolerance/impulse.cpp.
#pragma once

#include <array>
#include <span>

#include "model/answers.h"
#include "oracle/subject.h"
#include "oracle/truth/impact.h"

namespace touchstone::oracle::tolerance {

/// √J: bound of the error of the change of velocities in the norm √(Σ m|v|² + wᵀ I w). For an impulse error dP this is
/// √(dPᵀ K dP). The bound also holds for a stated impulse, and for u' in the K⁻¹ norm.
double impulse(const Scene& scene, const Impact& impact, const std::array<Velocity, 2>& after, Precision precision);

/// √J, in the same norm: effect of errors of what the impact is computed from. `arms` (m) bounds those of p_BcmC_W of A
/// and B, `u` (m/s) that of the velocity at C.
double of_input(const Scene& scene, const Impact& impact, const std::array<double, 2>& arms, double u);

/// J: error of the kinetic energy after impacts at one time, by the solution for their impulses. `norms` (√J): √(Pᵀ K
/// P) of each impulse, as if its contact were the only one.
double solved_together(std::span<const Real> norms, Precision precision);

/// N s: |Σ m v' − Σ m v|, after an impulse of magnitude |P|.
double momentum(const Scene& scene, const Impact& impact, const std::array<Velocity, 2>& after, Real impulse,
                Precision precision);

/// N m s: of one body's angular momentum about C.
double angular_momentum(const Scene& scene, const Impact& impact, std::size_t body, const Velocity& after, Real impulse,
                        Precision precision);

/// N s: error of a coordinate of a stated impulse of magnitude |P|, of its part outside the cone, or of its tension.
double cone(Real impulse, Real friction, Precision precision);

/// Is K far enough from singular that a computation in this precision has at least one certain digit, and the judge, in
/// long double, many?
bool impact_is_sure(const Impact& impact, Precision precision);

/// In SI units: of smaller numbers products may underflow.
double least_in_range(Precision precision);

/// Are the squares in the computation of an impact normal numbers in this precision, with room for their products?
bool impact_in_range(const Impact& impact, Precision precision);

}  // namespace touchstone::oracle::tolerance
