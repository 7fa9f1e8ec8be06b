// Resting contact on a face of a fixed block, in closed form: a ball slides or rolls, another body slides or lies.
#pragma once

#include <optional>

#include "fast/simulation/impact.h"

namespace touchstone::fast::simulation {

/// Micro-bounces too low to be followed, which are replaced by a resting contact: the speed v of the first, and their
/// mean force relative to the weight. With the speeds v, ev, e²v, ... they last T = 2v/(g_n (1 − e)), and their impulse
/// is m v (1 + e)/(1 − e).
struct MicroBounces {
  double speed = 0;
  double load = 1;
};

/// A resting contact, with one force law from now until it ends.
struct RestingContact {
  enum class End { bounces_end, slip_ends, leaves };
  BodyId on = 0;
  Vec3 nhat_W = Vec3::Zero();  ///< from the support to the body
  Vec3 lever = Vec3::Zero();   ///< from the body's origin to the point at which the contact force acts
  Vec3 touch = Vec3::Zero();   ///< to a point at which the two touch: of a body in parts, a corner
  double since = 0;            ///< s; when this force law began
  State start;                 ///< from which the body's trajectory starts
  Vec3 acceleration = Vec3::Zero(), alpha = Vec3::Zero();
  double until = never;  ///< s; when this force law ends
  End ends_by = End::leaves;
  MicroBounces bounces;
  double bounces_end = 0;  ///< s
};

/// The acceleration with which the trajectories of two bodies press them together (m/s²): −n̂·(a_A − a_B).
inline double pressing_acceleration(const BodyMotion& a, const BodyMotion& b, const Touch& touch) {
  return -touch.nhat_BA_W.dot(a.path().a - b.path().a);
}

/// The greatest speed v (m/s) of a micro-bounce whose apex stays within the envelope ε: v²/(2 press) = ε. Such a bounce
/// cannot be distinguished from contact.
double micro_bounce_speed(double press, double envelope);

/// Whether gravity pulls a body off a face with this normal, by more than rounding: then it does not rest there.
bool is_pulled_off(const Vec3& nhat_W, const Vec3& gravity);

/// The resting contact of a ball on the face of a block, from time t and a state without normal velocity. None if there
/// is no closed form: at an edge, or if the slip changes its direction (gravity has a component along the face that is
/// not along the slip).
///
/// r: radius, λ = m r²/I, g_n and g_t: gravity against and along the face, u: slip of the lowest point, σ = u/|u|.
///   slides: a = g_t − μ N σ, α = (λ/r) n̂ × μ N σ, N = load · g_n, until |u| + (g_t·σ − (1 + λ) μ N) τ = 0
///   rolls:  a = λ/(1 + λ) g_t, α = n̂ × a/r, while g_t/(1 + λ) ≤ μ N
/// and both until the contact point leaves the face. `load` is 1 except for micro-bounces, whose mean force is less
/// than the weight.
std::optional<RestingContact> ball_on_face(const BodyMotion& ball, const BodyMotion& block, const State& state,
                                           double t, const Vec3& nhat_W, const Vec3& gravity, double friction,
                                           double load = 1);

/// The resting contact of a body that touches the face in a region with the given corners (contact/patch.h). None
/// unless the normal speed and the turning speed of every corner are at most `rest_speed` (m/s), the contact force goes
/// through the region, and the slip is along the slope, if there is one.
///
///   lies:   a = 0, at slips below `rest_speed`, while |g_t| ≤ μ N, N = load · g_n; without friction at no slip at all
///   slides: a = g_t − μ N σ, until |v| + (g_t·σ − μ N) τ = 0, or the force point leaves the face
/// The force a − g_t + N n̂ per mass acts through the centre of mass, since the body does not turn; the force point is
/// where its line intersects the face. If that is outside of the region, the body tips and does not rest.
std::optional<RestingContact> body_on_face(const BodyMotion& body, const BodyMotion& block, State state, double t,
                                           const Vec3& nhat_W, const std::vector<Vec3>& corners, const Vec3& gravity,
                                           double friction, double rest_speed, double load = 1);

/// The state at the end of slip: a ball rolls, without slip up to rounding; another body is at rest on the block. The
/// end of slip is known to the rounding of time. What is left of a ball's slip by then is ended by an impulse P at the
/// contact point, so what the contact gave is the change of both momenta:
///   m Δv = P, I Δω = −r n̂ × P, P = −m slip/(1 + λ), λ = m r²/I
State without_slip(const BodyMotion& body, const BodyMotion& block, State state, const Vec3& nhat_W);

/// The normal of a face of the block if it differs from n̂ by less than 2⁻²⁰ (a body that lies within the envelope is
/// tilted by less), otherwise n̂.
Vec3 face_normal(const BodyMotion& block, const Vec3& nhat_W);

/// The state without velocity along n̂ relative to the support.
State without_normal(const BodyMotion& support, State state, const Vec3& nhat_W);

}  // namespace touchstone::fast::simulation
