#include "fast/simulation/meeting.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "fast/lin_canny/nearest_parts.h"
#include "fast/rounding.h"
#include "fast/simulation/length.h"
#include "fast/simulation/range.h"
#include "fast/time_of_impact.h"

namespace touchstone::fast::world {
namespace {

constexpr int most_steps = 200;  // quadratic convergence takes a handful; then the bound is kept as one

/// Lengths are what plain sqrt serves; the limits of a scene's numbers are far below where squares overflow.
struct Nearest {
  double gap;
  Vec3 n;      ///< from B to A
  Vec3 p_WCb;  ///< on B
};

Nearest balls(const Mover& a, const Mover& b, const Vec3& s, const Vec3& p_b) {
  const double far = length(s);
  const Vec3 n = far > 0 ? Vec3(s / far) : Vec3(0, 0, 1);
  return {far - (a.radius() + b.radius()), n, p_b + b.radius() * n};
}

/// The face that is nearest to a centre inside the block.
Nearest inside(const Mover& ball, const Mover& block, const Vec3& s_B, const Vec3& p_block) {
  int axis = 0;
  const Vec3 left = block.half_extents() - s_B.cwiseAbs();
  left.minCoeff(&axis);
  Vec3 n_B = Vec3::Zero();
  n_B[axis] = s_B[axis] < 0 ? -1 : 1;
  return {-left[axis] - ball.radius(), block.R_WB() * n_B, p_block + block.R_WB() * (s_B + left[axis] * n_B)};
}

/// s: from the block's origin to the ball's centre.
Nearest ball_on_block(const Mover& ball, const Mover& block, const Vec3& s, const Vec3& p_block) {
  const Vec3 s_B = block.R_WB().transpose() * s;
  const Vec3 foot = s_B.cwiseMax(-block.half_extents()).cwiseMin(block.half_extents());
  const Vec3 away = s_B - foot;
  const double far = length(away);
  if (!(far > 0)) return inside(ball, block, s_B, p_block);
  return {far - ball.radius(), block.R_WB() * (away / far), p_block + block.R_WB() * foot};
}

/// Of two bodies with a closed form, at p_a and p_b.
Nearest nearest(const Mover& a, const Mover& b, const Vec3& p_a, const Vec3& p_b) {
  const Vec3 s = p_a - p_b;
  if (a.kind() == Kind::block) {
    const Nearest other = ball_on_block(b, a, -s, p_a);
    return {other.gap, -other.n, other.p_WCb + other.gap * other.n};
  }
  return b.kind() == Kind::block ? ball_on_block(a, b, s, p_b) : balls(a, b, s, p_b);
}

double rounding(const Mover& m, double t) {
  const Path& path = m.path();
  const double tau = t - path.since, speed = path.v.lpNorm<1>() + tau * path.a.lpNorm<1>();
  const double own = m.kind() == Kind::ball ? m.radius() : 0;
  return 16 * u * (path.p.lpNorm<1>() + own + tau * speed) + 4 * u * t * speed;
}

struct Relative {
  Vec3 v, a;
};

Relative relative(const Mover& a, const Mover& b, double t) {
  return {a.path().velocity(t) - b.path().velocity(t), a.path().a - b.path().a};
}

/// Two that part do so for ever. The quadratic twice: how clear is clear enough depends a little on when they meet. Two
/// that miss each other do so only if they pass by more than rounding makes of their places.
double alike_falling_balls(const Mover& a, const Mover& b, double from, double until, double envelope, double margin) {
  const Vec3 s = a.path().place(from) - b.path().place(from);
  const Vec3 v = relative(a, b, from).v;
  const double b_half = s.dot(v);
  if (b_half >= 0) return never;
  const double reach = a.radius() + b.radius() + margin;
  const double about = sphere_closes(s, v, reach + clearance(a, b, from, envelope));
  const double then = about < never ? from + about : std::min(until, from - b_half / v.dot(v));
  if (!places_tell(a, b, then)) return from + sphere_closes(s, v, reach + clearance(a, b, then, never));
  return about > 0 && about < never ? from + sphere_closes(s, v, reach + clearance(a, b, from + about, envelope))
                                    : from + about;
}

double by_planes(const Mover& a, const Mover& b, double from, double until, double envelope, double margin) {
  double t = from;
  for (int step = 0; step < most_steps; ++step) {
    const double clear = clearance(a, b, t, envelope) + margin;
    const Nearest at = nearest(a, b, a.path().place(t), b.path().place(t));
    const Relative rate = relative(a, b, t);
    const double dt = closes(at.gap - clear, at.n.dot(rate.v), at.n.dot(rate.a));
    if (!(dt > 0) || (at.gap <= 2 * clear && at.n.dot(rate.v) < 0)) return t;
    if (at.gap <= 2 * clearance(a, b, t, never) && !places_tell(a, b, t)) return t;
    if (!(t + dt <= until)) return never;
    if (t + dt == t) return t;
    t += dt;
  }
  return t;
}

/// Where doubles do not see whether two bodies that graze meet, they are taken not to, and looked at again thereafter;
/// but where they do not even see where the two are, that is said to be a meeting, which the loop does not take.
double advanced(const Mover& a, const Mover& b, double from, double until, double envelope, const Swelling& swelling,
                Memory& memory) {
  memory.looks = 0;
  while (true) {
    const Meeting found = time_of_impact(a.flight(), b.flight(), from, until, envelope, memory.walks, swelling);
    memory.looks += found.looks;
    if (found.meeting == TimeOfImpact::Meeting::hit) {
      if (envelope == 0) return found.hi;
      memory.time = found.lo;
      memory.touch = {0, found.p_WC, found.nhat_BA_W};
      return found.lo;
    }
    if (found.meeting == TimeOfImpact::Meeting::undecided && !places_tell(a, b, found.hi)) return found.lo;
    if (found.meeting == TimeOfImpact::Meeting::miss || !(found.hi > from) || found.hi >= until) return never;
    from = found.hi;
  }
}

}  // namespace

bool has_closed_form(const Mover& a, const Mover& b) {
  return (a.kind() == Kind::ball && b.kind() != Kind::other) || (a.kind() == Kind::block && b.kind() == Kind::ball);
}

double clearance(const Mover& a, const Mover& b, double t, double envelope) {
  constexpr std::uint64_t exponent = 0x7ff0000000000000;
  const double sum = rounding(a, t) + rounding(b, t);
  return std::min(envelope / 2, 2 * std::bit_cast<double>(std::bit_cast<std::uint64_t>(sum) & exponent));
}

Touch touch(const Mover& a, const Mover& b, double t, Memory& memory) {
  if (has_closed_form(a, b)) {
    const Nearest at = nearest(a, b, a.path().place(t), b.path().place(t));
    return {at.gap, at.p_WCb + at.gap / 2 * at.n, at.n};
  }
  if (memory.time == t) return memory.touch;
  const lin_canny::Solid &A = a.flyer().solid, &B = b.flyer().solid;
  memory.walks.resize(A.parts().size() * B.parts().size());
  const auto found = lin_canny::nearest_parts(A, lin_canny::Station(a.flight().pose(t)), B,
                                              lin_canny::Station(b.flight().pose(t)), memory.walks);
  const lin_canny::Proximity& at = found.proximity;
  const Vec3 apart = at.p_WCa - at.p_WCb;
  const double far = length(apart);
  return {at.verdict == Verdict::overlapping ? -1.0 : at.distance, (at.p_WCa + at.p_WCb) / 2,
          far > 0 ? Vec3(apart / far) : Vec3(Vec3::Zero())};
}

double meeting(const Mover& a, const Mover& b, double from, double until, double envelope, const Swelling& swelling,
               Memory& memory) {
  if (has_closed_form(a, b)) {
    const double margin = swelling.at(until);
    const bool alike = a.kind() == b.kind() && a.path().a == b.path().a;
    const double t = alike ? alike_falling_balls(a, b, from, until, envelope, margin)
                           : by_planes(a, b, from, until, envelope, margin);
    return t <= until ? t : never;
  }
  memory.walks.resize(a.flyer().solid.parts().size() * b.flyer().solid.parts().size());
  return advanced(a, b, from, until, envelope, swelling, memory);
}

}  // namespace touchstone::fast::world
