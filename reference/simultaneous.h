// Impacts in several contact regions at one time, in exact numbers: the law of docs/design/simultaneous.md.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "model/scene.h"
#include "reference/impulse.h"

namespace touchstone::reference {

/// The points at which two convex parts are closest, with one normal. The normal velocity is affine over them, so the
/// corners of their convex hull are enough. Regions of the same bodies with the same normal act as one; each part's
/// impulse is its own.
struct ContactRegion {
  int a = 0, b = 0;                 ///< indices of the bodies A and B
  Vec3 nhat_BA_W = {0, 0, 0};       ///< of any length but 0, from B to A
  std::vector<Vec3> points_W = {};  ///< midpoints of closest points, in doubles; also inner ones
};

/// The contact regions of bodies a and b at the poses of the scene: one for each of the nearest pairs of parts,
/// and for each pair with a normal of the same direction that is no farther apart than `within` (m). Without the pairs
/// of a direction if none of their points approaches, and without parts that overlap. Requires a completed scene with a
/// motion. Throws what `distance` throws.
std::vector<ContactRegion> approaching_regions(const Scene& scene, int a, int b, double within);

/// What one region does in compression.
struct RegionImpulse {
  ExactVec3 P_A_W;                       ///< on A (N s): Σ p n̂ over the region's points
  Vec3 centre_W = {0, 0, 0};             ///< the centre of pressure Σ p x / Σ p, to the nearest doubles; 0 if P is 0
  std::array<ExactVelocity, 2> changes;  ///< of A and B, by this region's impulses alone
};

/// The impulses p n̂, p ≥ 0, at the points of all regions that change the velocities to the nearest in kinetic energy at
/// which no point approaches (Moreau 1988). Exact in the given doubles, in which a sphere's π is the rational of
/// reference/impulse.h. With 1 + e times the impulses, kinetic energy falls by exactly (1 − e²) of what compression
/// took (docs/design/simultaneous.md). The velocities are unique, and so are P and the centre of one region alone; of
/// several regions P may not be. None if there are no such velocities: a body is clamped between others. Throws what
/// `impulse` throws.
std::optional<std::vector<RegionImpulse>> compression(const Scene& scene, const std::vector<ContactRegion>& regions);

/// The rounds of impacts at one time.
struct AllRounds {
  std::vector<RegionImpulse> impulses;  ///< of each region, summed over the rounds
  std::vector<ExactVelocity> after;     ///< of all bodies
  int rounds = 0;
  bool completed = false;  ///< 64 rounds were not enough; the last one is their limit, one compression of all regions
};

/// Rounds until no region approaches: in each, all regions that approach act at once, by compression and then
/// restitution. e is the lesser of a pair's. Where those that act together differ in e, energy falls by at least
/// Σ (1 − e²) of each region's work of compression: the share s of restitution is the greatest multiple of 2⁻⁶⁴ that
/// this allows, and of all impulses of compression those act whose wrenches have the least energy.
/// For an outcome, the regions are those of all pairs in contact, whether they approach or not. Friction is not used.
/// None and throws: as `compression`.
std::optional<AllRounds> all_rounds(const Scene& scene, const std::vector<ContactRegion>& regions);

/// The point C of one region at which it acts alone while the bodies slide on each other: the normal velocities
/// u_n' after the impact at C, by the law of one contact point, make u_n' + e u_n least at C over the region. A
/// rational to the nearest doubles. None where the region does not slide without rotating about its normal, or where
/// slip stops. Throws what `impulse` throws.
std::optional<Vec3> sliding_centre(const Scene& scene, const ContactRegion& region);

}  // namespace touchstone::reference
