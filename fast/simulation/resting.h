// A ball that stays on a plane face of a fixed block: it slides or rolls, in closed form.
#pragma once

#include <optional>

#include "fast/simulation/impact.h"

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
std::optional<Rest> rest(const Mover& ball, const Mover& block, const State& state, double t, const Vec3& nhat_W,
                         const Vec3& gravity, double friction, double load = 1);

/// The state as rolling wants it: no slip, to rounding.
State rolling(const Mover& ball, const Mover& block, State state, const Vec3& nhat_W);

/// Without velocity against the support along n̂.
State without_normal(const Mover& support, State state, const Vec3& nhat_W);

}  // namespace touchstone::fast::world
