// When two bodies on their paths come into contact, and where.
#pragma once

#include <cstdint>
#include <vector>

#include "fast/simulation/body.h"
#include "fast/simulation/parabola.h"
#include "fast/time_of_impact/swelling.h"

namespace touchstone::fast::world {

/// Where two bodies are nearest: C midway, n̂ from B to A, and how fast A's point leaves B's there along n̂.
struct Touch {
  double gap = 0;  ///< m; < 0: overlap, of a depth that only closed forms know
  Vec3 p_WC = Vec3::Zero();
  Vec3 nhat_BA_W = Vec3::Zero();
};

/// What is kept of a pair without a closed form: where its walks stood, and where the meeting is that was found last.
struct Memory {
  std::vector<lin_canny::FeaturePair> walks;
  int looks = 0;     ///< that the last question took (time_of_impact.h)
  double time = -1;  ///< s; of the touch
  Touch touch;
  double parted = -1;         ///< s; when they last were seen to part, so that a step may begin
  std::uint64_t strikes = 0;  ///< that the two had had by then
  double unasked = -1;        ///< s; when a step began in which nobody asks whether they meet
  double struck = -1;         ///< s; the last impact of the two
  int at_once = 0;            ///< impacts up to that one between which the two hardly moved
};

/// Two balls, or a ball and a block.
bool has_closed_form(const Mover& a, const Mover& b);

/// How near two bodies with a closed form are brought before they count as met (m): what rounding may do to their
/// places at time t, so that they never overlap; at most half the envelope.
///
/// Each body: its place is off by 4u of the terms that it is a sum of, p + τ (v + τ a/2); the difference of places, its
/// turn into a block's axes, feet and lengths by 8u of the same; t is rounded by u/2 of itself.
/// 16u and 4u cover them with room for the second order. Their sum is rounded up to a power of two: a ball that comes
/// back finds the same clearance, so that its energy does not change by the difference.
double clearance(const Mover& a, const Mover& b, double t, double envelope);

/// The nearest points at time t (≥ both paths' beginnings); where several are, and a meeting was found for this very
/// time, those that approach.
Touch touch(const Mover& a, const Mover& b, double t, Memory& memory);

/// A lower bound for the first time in [from, until] at which the two are in contact and approach; infinity: they are
/// not. Between balls, and between a ball and a block, it is that time to rounding: at it they are within
/// 2 · clearance. Else within the envelope, or as far as doubles see (fast/time_of_impact.h).
///
/// Balls that fall alike: relative motion is straight, one quadratic. Else each bound is the time at which the plane
/// that keeps the two apart at their nearest points is reached: n̂·s is a parabola, and no convex body crosses its own
/// supporting plane. Steps from one bound to the next converge like Newton's, from below.
/// `swelling`: they are in contact already when they are so much farther apart. `envelope` 0: not at the lower bound,
/// but where it is proved that the two overlap, by little more than rounding.
double meeting(const Mover& a, const Mover& b, double from, double until, double envelope, const Swelling& swelling,
               Memory& memory);

}  // namespace touchstone::fast::world
