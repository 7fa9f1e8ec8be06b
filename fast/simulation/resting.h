// A body that stays on a plane face of a fixed block, in closed form: a ball slides or rolls, another slides or lies.
#pragma once

#include <optional>

#include "fast/simulation/impact.h"
#include "fast/simulation/patch.h"

namespace touchstone::fast::world {

/// Hops too low to be followed, in place of which a body is said to rest: the speed of the first, and how hard they
/// press in the mean, by its weight. With v, ev, e²v, ... they last T = 2v/(g_n (1 − e)) and give m v (1 + e)/(1 − e).
struct Hops {
  double speed = 0;
  double load = 1;
};

/// How a body is held by what it rests on, from now until it changes.
struct Rest {
  enum class Then { hops_end, slip_ends, leaves };
  BodyId on = 0;
  Vec3 nhat_W = Vec3::Zero();  ///< from the support to the body
  Vec3 lever = Vec3::Zero();   ///< from the body's origin to where it is held
  State start;                 ///< what it sets out from
  Vec3 acceleration = Vec3::Zero(), alpha = Vec3::Zero();
  double until = never;  ///< s; when
  Then then = Then::leaves;
  Hops hops;
  double hops_end = 0;  ///< s
};

/// How hard two bodies press on each other on the paths that they are on (m/s²): −n̂·(a_A − a_B).
inline double press(const Mover& a, const Mover& b, const Touch& touch) {
  return -touch.nhat_BA_W.dot(a.path().a - b.path().a);
}

/// Hops are too low to be told from contact if their apex stays within the envelope: v²/(2 press) ≤ ε.
double least_speed(double press, double envelope);

/// Rest of a ball on the face of a block under its foot, from time t and a state without normal velocity; none where
/// there is no closed form: at an edge, or where slip turns (gravity along the face, but not along the slip).
///
/// r: radius, λ = m r²/I, g_n and g_t: gravity against and along the face, u: slip of the lowest point, σ = u/|u|.
///   slides: a = g_t − μ N σ, α = (λ/r) n̂ × μ N σ, N = load · g_n, until |u| + (g_t·σ − (1 + λ) μ N) τ = 0
///   rolls:  a = λ/(1 + λ) g_t, α = n̂ × a/r, while g_t/(1 + λ) ≤ μ N
/// and either until the foot leaves the face. `load` is 1 but for hops, which press less than their weight.
std::optional<Rest> roll(const Mover& ball, const Mover& block, const State& state, double t, const Vec3& nhat_W,
                         const Vec3& gravity, double friction, double load = 1);

/// Rest of a body that touches the face with the given corners of a region (patch.h); none unless all of them part or
/// approach, and turn, no faster than `still`, the force that holds it goes through the region, and slip is along the
/// slope, if there is one.
///
///   lies:   a = 0, at slips below `still`, while |g_t| ≤ μ g_n
///   slides: a = g_t − μ g_n σ, until |v| + (g_t·σ − μ g_n) τ = 0, or the foot of the force leaves the face
/// The force a − g acts through the centre of mass, since the body does not turn; where its line meets the face is the
/// foot. A foot outside of the region: the body tips, and does not rest.
std::optional<Rest> lie(const Mover& body, const Mover& block, State state, double t, const Vec3& nhat_W,
                        const std::vector<Vec3>& corners, const Vec3& gravity, double friction, double still);

/// The state once slip has ended: a ball rolls, without slip to rounding; another body stands.
State without_slip(const Mover& body, const Mover& block, State state, const Vec3& nhat_W);

/// The normal of the block's face that n̂ is near (by 2⁻²⁰: a body that lies within an envelope is no more askew), else
/// n̂.
Vec3 face_normal(const Mover& block, const Vec3& nhat_W);

/// Without velocity against the support along n̂.
State without_normal(const Mover& support, State state, const Vec3& nhat_W);

}  // namespace touchstone::fast::world
