// Projections onto Coulomb's friction cone, with their derivatives.
#pragma once

#include "model/frame.h"

namespace touchstone::fast::contact {

/// An impulse in the cone |P_t| ≤ μ P_n, and its derivative by the vector that was projected.
struct ConeImpulse {
  Vec3 P = Vec3::Zero();
  Mat3 derivative = Mat3::Zero();
};

/// The point of the cone nearest to z. The derivative is symmetric, with eigenvalues in [0, 1].
ConeImpulse nearest_in_cone(const Vec3& z, const Vec3& n, double friction);

/// P_n = max(0, z_n), and P_t = the point of the disc of radius μ P_n nearest to z_t. With z = P − ρ u, P is a fixed
/// point exactly if P and u satisfy complementarity and Coulomb's law (Alart & Curnier 1991).
ConeImpulse nearest_in_disc(const Vec3& z, const Vec3& n, double friction);

}  // namespace touchstone::fast::contact
