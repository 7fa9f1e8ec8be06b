// Impacts at several points at one instant: one round of the law of docs/design/simultaneous.md.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "fast/contact/row.h"

namespace touchstone::fast::simultaneous {

/// The points at which two bodies touch with one normal n̂. They act as one: only their convex hull matters, since u_n
/// is affine over it.
struct Region {
  double restitution = 0;
  std::vector<contact::ContactRow> points;  ///< at least one; all with the region's bodies and n̂. `act` sets P
};

/// The least u_n over the region's points (m/s). Below 0 the region approaches.
double least_normal_velocity(const Region& region, const std::vector<contact::Twist>& twists);

/// Indices of the regions that are connected through bodies that move, each component in the order given, components in
/// the order of their first regions.
std::vector<std::vector<std::size_t>> components(const std::vector<Region>& regions,
                                                 const std::vector<contact::Mobility>& bodies);

/// Normal impulses p ≥ 0 at the points, without friction, that bring the bodies to the velocities that are nearest in
/// kinetic energy among those with u_n ≥ `least_u_n` (m/s) at each point. So u_n = least_u_n where p > 0. The
/// velocities are unique; p is not where points are redundant.
Eigen::VectorXd compression(const std::vector<contact::ContactRow>& points,
                            const std::vector<contact::Mobility>& bodies, const std::vector<contact::Twist>& twists,
                            double least_u_n);

/// One round for a component of regions that approach: all act at once, each with all of its points, first by
/// compression and then by restitution. Sets P of each point and changes the twists.
///
/// Without friction, compression is the one above. Of all p with this effect it takes the one with the least
/// Σ ½ Wᵀ M⁻¹ W over the regions, where W is a region's wrench on its two bodies and M their mass matrix; so W is
/// unique. Restitution is s e p in each region, with the greatest s ≤ 1 for which kinetic energy falls by at least Σ (1
/// − e²) w, where w = ½ Σ p (−u_n) is the work of compression of a region. With one e, s = 1: kinetic energy falls by
/// exactly (1 − e²) of what compression took, and the velocities do not depend on p.
///
/// With friction, compression fulfils Coulomb's law with the slip at its end (contact/solver.h). Where the regions are
/// redundant, several impulses do. Normal impulses at given friction and friction at given normal impulses, each with a
/// unique effect, are solved in turn, at most 32 times; the contact solver goes on from there. Restitution adds s e P_n
/// with friction against the slip at its end, with s so small that no more energy returns than above, nor than
/// compression took.
void act(std::vector<Region>& regions, const std::vector<contact::Mobility>& bodies,
         std::vector<contact::Twist>& twists);

}  // namespace touchstone::fast::simultaneous
