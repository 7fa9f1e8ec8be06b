// The first contact of two bodies on their trajectories, and the nearest points.
#pragma once

#include <cstdint>
#include <vector>

#include "fast/simulation/prediction/body_motion.h"
#include "fast/simulation/prediction/parabola.h"
#include "fast/time_of_impact/inflation.h"

namespace touchstone::fast::simulation {

/// The nearest points of two bodies: C midway between them, n̂ from B to A.
struct Touch {
  double gap = 0;  ///< m; < 0: they overlap; only closed forms give the depth
  Vec3 p_WC = Vec3::Zero();
  Vec3 nhat_BA_W = Vec3::Zero();
};

/// What is kept of a pair between queries.
struct PairMemory {
  std::vector<lin_canny::FeaturePair> features;  ///< for each pair of parts, where its closest-feature walk ended
  int queries = 0;          ///< separation queries of the last call of first_contact (fast/time_of_impact.h)
  bool is_cut_off = false;  ///< that call needed more queries than it may take; it searched up to its result
  double time = -1;         ///< s; time of the contact found last
  Touch touch;
  double separating_at = -1;   ///< s; when the touching pair was last found to separate
  std::uint64_t impacts = 0;   ///< of the two bodies, with any body, by then
  double not_queried_at = -1;  ///< s; when a step began during which the pair is not queried
  double last_impact = -1;     ///< s; the last impact of the pair
  int impacts_in_place = 0;    ///< successive impacts up to that one between which the two hardly moved
};

/// How far two bodies may be from the trajectories that represent their steps.
struct Deviation {
  Inflation inflation = {};
  double since = 0, acceleration = 0;  ///< s, m/s²; they differ by at most acceleration (t − since)²/2, too
};

/// Two balls, or a ball and a block.
inline bool has_closed_form(const BodyMotion& a, const BodyMotion& b) {
  return (a.kind() == Kind::ball && b.kind() != Kind::other) || (a.kind() == Kind::block && b.kind() == Kind::ball);
}

/// The distance (m) at which two bodies with a closed form count as touching: a bound of the rounding of their
/// positions at time t, so that they never overlap; at most half the envelope.
///
/// For each body, the position is off by 4u of the terms of its sum p + τ (v + τ a/2); the difference of positions, its
/// rotation into the axes of a block, the nearest points and lengths are off by 8u of the same terms; t is rounded by
/// u/2 of itself. 16u and 4u cover these with room for the second order. The sum is rounded up to a power of two, so
/// that a ball that returns has the same clearance, and its energy does not change by a difference of clearances.
double clearance(const BodyMotion& a, const BodyMotion& b, double t, double envelope);

/// The nearest points at time t (≥ the start of both trajectories). If several are, and first_contact has found a
/// contact at exactly this time, the result is the contact found, whose points approach.
Touch touch(const BodyMotion& a, const BodyMotion& b, double t, PairMemory& memory);

/// A lower bound of the first time in [from, until] at which the two are in contact and approach; infinity if there is
/// none. Between balls, and between a ball and a block, the bound is that time up to rounding: there they are within
/// 2 · clearance. Other bodies are within the envelope, or as near as doubles can decide (fast/time_of_impact.h).
///
/// Balls with equal accelerations: their relative motion is straight, so that one quadratic gives the time. Other
/// bodies with closed forms: each bound is the time at which the separating plane at the nearest points is reached,
/// since n̂·s is a parabola and no convex body crosses its own supporting plane. Steps from one bound to the next
/// converge like Newton's method, from below. With a `deviation` they count as being in contact at a distance greater
/// by its inflation. If bodies with closed forms are that near at `from` already, but separate, the result is the first
/// time at which they may be in contact in spite of that, by the bound of the deviation from its acceleration. With
/// `envelope` 0 the result is not the lower bound but the time at which the two provably overlap, by little more than
/// rounding.
double first_contact(const BodyMotion& a, const BodyMotion& b, double from, double until, double envelope,
                     const Deviation& deviation, PairMemory& memory);

}  // namespace touchstone::fast::simulation
