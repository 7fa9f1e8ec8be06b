// The exact motion of one ball on fixed boxes under its contact constraint: sliding, rolling, ballistic, and the
// changes between these modes.
//
// While the ball (radius r, inertia κ m r² times 1) rests on a face with unit normal n, one coordinate is constrained:
// its centre stays r above the face. With the slip u = v − r w × n, N = −g·n > 0, g_t = g + N n, and the pair's μ:
//   sliding    v' = g_t − μ N û,    w' = μ N/(κ r) n × û      (û = u/|u|, or g_t/|g_t| where slip begins)
//   rolling    v' = g_t/(1 + κ),    w' = n × v'/r             (as long as κ/(1 + κ) |g_t| ≤ μ N)
//   ballistic  v' = g,              w' = 0.
// In each mode the centre moves on a parabola, so the time of the next change is a root of a polynomial: slip stops,
// the centre crosses the face's edge, or the ball touches another box (which gives the impulse of
// docs/spec/impulse.md). docs/design/constraint.md derives all of this and says what is outside.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "model/answers.h"
#include "model/infinity.h"
#include "model/scene.h"

namespace touchstone::reference {

/// Enclosures, rounded outward to doubles (m, m/s, rad/s). The ball's orientation is not part of the question.
struct BallTruth {
  std::array<Interval, 3> p_WB, v_WB, w_WB;
};

/// The ball's mode and its changes, with bounds of the quantities by which an answer is judged.
struct ConstraintTruth {
  enum class Mode { ballistic, sliding, rolling };
  /// What holds from the start or from a change until the next change.
  struct Segment {
    Mode mode = Mode::ballistic;
    double acceleration = 0;  ///< m/s²: upper bound of |v'| and r |w'|
    /// m: lower bound of the distance to any change other than the next one; infinity if it has no duration. A change
    /// exactly at the end does not count, but comes near: then it is at most 0.
    double clearance = infinity;
  };
  /// At `time` the set of contacts changes, or the mode of one.
  struct Change {
    Event::Kind kind = Event::Kind::contact;  ///< contact, release or impact
    Interval time;                            ///< s
    int other = 0;                            ///< the box in contact
    Vec3 p_WC = Vec3::Zero();                 ///< to the nearest doubles, as are n̂ and P
    Vec3 nhat_W = Vec3::Zero();               ///< from the box to the ball
    Vec3 P_W = Vec3::Zero();                  ///< on the ball (N s)
    /// Lower bound of the rate at which the quantity that is 0 at the change passes 0: m/s² for slip, else m/s
    double rate = 0;
    double velocity_jump = 0;  ///< m/s: upper bound of the jumps of v and of r w
    double curvature = 0;  ///< 1/m: for an impact, upper bound of how fast n̂ turns with the position; 0 over a face
    Segment segment;       ///< from this change on
    BallTruth after;
  };

  int ball = 0;
  Segment first;                  ///< from the start on
  double speed = 0;               ///< m/s: upper bound of |v| and r |w| at the start, at each sample and at each change
  std::vector<Change> changes;    ///< in order; a contact at the start comes first
  std::vector<BallTruth> states;  ///< one for each sample time
};

/// The motion of one ball among fixed boxes at rest, exactly. Requires a valid scene with a motion.
///
/// Throws InputError with the reason where the question is outside: other bodies than these; slip that turns (a tilted
/// face); a ball that comes to rest on an edge, pivots about one, or stays between two boxes; what 254 bits do not
/// decide (grazing contact, two changes at one time); more than 40 changes (bounces that accumulate).
ConstraintTruth constraint(const Scene& scene);

}  // namespace touchstone::reference
