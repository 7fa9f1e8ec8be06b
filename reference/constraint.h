// The exact motion of a ball on tables, by the constraints that hold it: slides, rolls, flies, and what changes
// between.
//
// While the ball (radius r, inertia κ m r² times 1) rests on a face with unit normal n, one coordinate is held: its
// centre stays r above the face. With u = v − r w × n the slip, N = −g·n > 0, g_t = g + N n, and μ of the pair:
//   slides  v' = g_t − μ N û,    w' = μ N/(κ r) n × û      (û = u/|u|, or g_t/|g_t| where slip begins)
//   rolls   v' = g_t/(1 + κ),    w' = n × v'/r             (as long as κ/(1 + κ) |g_t| ≤ μ N)
//   flies   v' = g,              w' = 0.
// In each of these the centre runs on a parabola, so the next change is a root of a polynomial in time: slip stops, the
// centre passes the face's edge, the ball meets another box (then the impulse of docs/spec/impulse.md).
// docs/design/constraint.md derives all of this, and says what is outside.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::reference {

/// Enclosures, rounded outward to doubles (m, m/s, rad/s). How a ball is turned is not asked.
struct BallTruth {
  std::array<Interval, 3> p_WB, v_WB, w_WB;
};

struct ConstraintTruth {
  enum class Mode { flies, slides, rolls };
  /// At `time` the contact set, or what a contact does, becomes another.
  struct Change {
    Event::Kind kind = Event::Kind::contact;  ///< contact, release or impact
    Interval time;                            ///< s
    int other = 0;                            ///< the box that is touched
    Vec3 p_WC = Vec3::Zero();                 ///< to the nearest doubles, as n̂ and P
    Vec3 nhat_W = Vec3::Zero();               ///< from the box to the ball
    Vec3 P_W = Vec3::Zero();                  ///< on the ball (N s)
    Mode mode = Mode::flies;                  ///< from now on
    double rate = 0;       ///< how fast that which is 0 at the change goes through 0, at least: of slip m/s², else m/s
    double kick = 0;       ///< m/s: by how much v and r w jump, at most
    double curvature = 0;  ///< 1/m: of an impact, how fast n̂ turns with the place, at most; 0 over a face
    double pull = 0;       ///< m/s²: |v'| and r |w'| from now on, at most
    double clear = 0;      ///< m: until the next change, how far it is from another one, at least
    BallTruth after;
  };

  int ball = 0;
  Mode mode = Mode::flies;        ///< at the start, and so
  double pull = 0, clear = 0;     ///< as in Change
  double speed = 0;               ///< m/s: |v| and r |w| at the start, at each look and change, at most
  std::vector<Change> changes;    ///< in their order; a contact at the start is the first
  std::vector<BallTruth> states;  ///< by time of the flight
};

/// One ball among fixed boxes at rest, exactly. Requires a valid scene with a flight.
///
/// Throws InputError, naming why, where the question is outside: another set of bodies; slip that turns (a tilted
/// face); a ball that comes to lie on an edge, pivots about one, or stays between two boxes; what 254 bits do not
/// decide (grazes, two changes at one time); more than 40 changes (bounces that pile up).
ConstraintTruth constraint(const Scene& scene);

}  // namespace touchstone::reference
