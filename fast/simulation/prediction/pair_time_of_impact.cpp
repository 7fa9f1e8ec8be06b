#include "fast/simulation/prediction/pair_time_of_impact.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "fast/lin_canny/nearest_parts.h"
#include "fast/mark.h"
#include "fast/rounding.h"
#include "fast/simulation/prediction/length.h"
#include "fast/simulation/range.h"
#include "fast/time_of_impact/first_contact.h"

namespace touchstone::fast::simulation {
namespace {

constexpr int most_steps = 200;  // quadratic convergence takes a few; after that many the result is still a lower bound

/// Lengths are computed by a plain sqrt: the limits of a scene's numbers keep squares far from overflow.
struct Nearest {
  double gap;
  Vec3 n;      ///< from B to A
  Vec3 p_WCb;  ///< on B
};

Nearest balls(const BodyMotion& a, const BodyMotion& b, const Vec3& s, const Vec3& p_b) {
  const double far = length(s);
  const Vec3 n = far > 0 ? Vec3(s / far) : Vec3(0, 0, 1);
  return {far - (a.radius() + b.radius()), n, p_b + b.radius() * n};
}

/// For a centre inside the block: the nearest face.
Nearest inside(const BodyMotion& ball, const BodyMotion& block, const Vec3& s_B, const Vec3& p_block) {
  int axis = 0;
  const Vec3 left = half_extents(block) - s_B.cwiseAbs();
  left.minCoeff(&axis);
  Vec3 n_B = Vec3::Zero();
  n_B[axis] = s_B[axis] < 0 ? -1 : 1;
  return {-left[axis] - ball.radius(), block.R_WB() * n_B, p_block + block.R_WB() * (s_B + left[axis] * n_B)};
}

/// s: from the origin of the block to the centre of the ball.
Nearest ball_on_block(const BodyMotion& ball, const BodyMotion& block, const Vec3& s, const Vec3& p_block) {
  const Vec3 s_B = block.R_WB().transpose() * s;
  const Vec3 nearest_B = s_B.cwiseMax(-half_extents(block)).cwiseMin(half_extents(block));
  const Vec3 away = s_B - nearest_B;
  const double far = length(away);
  if (!(far > 0)) return inside(ball, block, s_B, p_block);
  return {far - ball.radius(), block.R_WB() * (away / far), p_block + block.R_WB() * nearest_B};
}

/// For two bodies with a closed form, at positions p_a and p_b.
Nearest nearest(const BodyMotion& a, const BodyMotion& b, const Vec3& p_a, const Vec3& p_b) {
  const Vec3 s = p_a - p_b;
  if (a.kind() == Kind::block) {
    const Nearest other = ball_on_block(b, a, -s, p_a);
    return {other.gap, -other.n, other.p_WCb + other.gap * other.n};
  }
  return b.kind() == Kind::block ? ball_on_block(a, b, s, p_b) : balls(a, b, s, p_b);
}

double rounding(const BodyMotion& m, double t) {
  const Path& path = m.path();
  const double own = m.kind() == Kind::ball ? m.radius() : 0;
  if (m.fixed()) return 16 * u * (path.p.lpNorm<1>() + own);
  const double tau = t - path.since, speed = path.v.lpNorm<1>() + tau * path.a.lpNorm<1>();
  return 16 * u * (path.p.lpNorm<1>() + own + tau * speed) + 4 * u * t * speed;
}

struct Relative {
  Vec3 v, a;
};

Relative relative(const BodyMotion& a, const BodyMotion& b, double t) {
  return {a.path().velocity(t) - b.path().velocity(t), a.path().a - b.path().a};
}

/// Balls that separate do so for ever. The quadratic is solved twice, since the clearance depends on the time of
/// impact. Balls that pass each other count as a miss only if their distance exceeds the rounding of their positions.
double equally_accelerated_balls(const BodyMotion& a, const BodyMotion& b, double from, double until, double envelope) {
  const Vec3 s = a.path().place(from) - b.path().place(from);
  const Vec3 v = relative(a, b, from).v;
  const double b_half = s.dot(v);
  if (b_half >= 0) return never;
  const double reach = a.radius() + b.radius();
  const double about = sphere_closing_time(s, v, reach + clearance(a, b, from, envelope));
  const double then = about < never ? from + about : std::min(until, from - b_half / v.dot(v));
  const double unresolved = clearance(a, b, then, never);
  if (!positions_resolved(a, b, unresolved)) return from + sphere_closing_time(s, v, reach + unresolved);
  return about > 0 && about < never ? from + sphere_closing_time(s, v, reach + std::min(envelope / 2, unresolved))
                                    : from + about;
}

/// How far two bodies may have left their trajectories, and how fast that grows (m, m/s, m/s²).
struct Spread {
  double size = 0, rate = 0, acceleration = 0;
};

template <typename SpreadAt>
double by_planes(const BodyMotion& a, const BodyMotion& b, double from, double until, double envelope,
                 const SpreadAt& spread_at) {
  double t = from;
  for (int step = 0; step < most_steps; ++step) {
    mark(Mark::plane_step);
    const Spread spread = spread_at(t);
    const double unresolved = clearance(a, b, t, never), clear = std::min(envelope / 2, unresolved) + spread.size;
    const Nearest at = nearest(a, b, a.path().place(t), b.path().place(t));
    const Relative rate = relative(a, b, t);
    const double u_n = at.n.dot(rate.v) - spread.rate;
    const double dt = closing_time(at.gap - clear, u_n, at.n.dot(rate.a) - spread.acceleration);
    if (!(dt > 0) || (at.gap <= 2 * clear && u_n < 0)) return t;
    if (at.gap <= 2 * unresolved && !positions_resolved(a, b, unresolved)) return t;
    if (!(t + dt <= until)) return never;
    if (t + dt == t) return t;
    t += dt;
  }
  return t;
}

/// Two bodies with a closed form that may leave their trajectories.
double with_deviation(const BodyMotion& a, const BodyMotion& b, double from, double until, double envelope,
                      const Deviation& deviation) {
  const double most = deviation.inflation.at(until);
  const Nearest at = nearest(a, b, a.path().place(from), b.path().place(from));
  if (at.gap > most + std::min(envelope / 2, clearance(a, b, from, never)))
    return by_planes(a, b, from, until, envelope, [most](double) { return Spread{most, 0, 0}; });
  if (at.n.dot(relative(a, b, from).v) <= 0) return from;
  return by_planes(a, b, from, until, envelope, [&](double t) {
    const double since = t - deviation.since, rate = deviation.acceleration * since;
    return Spread{rate * since / 2, rate, deviation.acceleration};
  });
}

lin_canny::Proximity proximity_at(const BodyMotion& a, const BodyMotion& b, double t, PairMemory& memory) {
  const lin_canny::Solid &A = a.model().solid, &B = b.model().solid;
  memory.features.resize(lin_canny::pairs_of_parts(A, B));
  return nearest_parts(A, lin_canny::CachedPose(a.ballistic().pose(t)), B, lin_canny::CachedPose(b.ballistic().pose(t)),
                       memory.features)
      .proximity;
}

struct Hit {
  double time;
  Vec3 p_WC;
};

/// Of a contact that is proved to come between `lo` and `hi`: a time at which the computed poses are within the
/// envelope. That is `lo`, unless the claimed errors of the poses hide a gap that is wider. A run goes on from the
/// computed poses, so they tell where the two are, and bisection of their distance finds a time.
Hit within_envelope(const BodyMotion& a, const BodyMotion& b, const FirstContact& found, double envelope,
                    PairMemory& memory) {
  const Hit first{found.lo, found.p_WC};
  double lo = found.lo, hi = found.hi;
  if (!(lo < hi) || proximity_at(a, b, lo, memory).distance <= envelope) return first;  // 0 if they overlap
  for (double t = std::midpoint(lo, hi); lo < t && t < hi; t = std::midpoint(lo, hi)) {
    const lin_canny::Proximity at = proximity_at(a, b, t, memory);
    if (at.verdict != Verdict::overlapping && at.distance <= envelope) return {t, (at.p_WCa + at.p_WCb) / 2};
    (at.verdict == Verdict::overlapping ? hi : lo) = t;
  }
  return first;
}

/// If doubles cannot decide whether two grazing bodies touch, they count as separated, and the search continues after
/// the undecided interval. If their positions are not even resolved, a contact is returned, and the loop stops the run
/// there.
double by_advancement(const BodyMotion& a, const BodyMotion& b, double from, double until, double envelope,
                      const Inflation& inflation, PairMemory& memory) {
  memory.queries = 0;
  while (true) {
    const FirstContact found =
        fast::first_contact(a.ballistic(), b.ballistic(), from, until, envelope, memory.features, inflation);
    memory.queries += found.queries;
    memory.is_cut_off = found.is_cut_off;
    if (found.is_cut_off) return found.lo;
    if (found.status == TimeOfImpact::Status::hit) {
      if (envelope == 0) return found.hi;
      const Hit hit = inflation.is_none() ? within_envelope(a, b, found, envelope, memory) : Hit{found.lo, found.p_WC};
      memory.time = hit.time;
      memory.touch = {0, hit.p_WC, found.nhat_BA_W};
      return hit.time;
    }
    if (found.status == TimeOfImpact::Status::undecided && !positions_resolved(a, b, clearance(a, b, found.hi, never)))
      return found.lo;
    if (found.status == TimeOfImpact::Status::miss || !(found.hi > from) || found.hi >= until) return never;
    from = found.hi;
  }
}

}  // namespace

double clearance(const BodyMotion& a, const BodyMotion& b, double t, double envelope) {
  constexpr std::uint64_t exponent = 0x7ff0000000000000;
  const double sum = rounding(a, t) + rounding(b, t);
  return std::min(envelope / 2, 2 * std::bit_cast<double>(std::bit_cast<std::uint64_t>(sum) & exponent));
}

Touch touch(const BodyMotion& a, const BodyMotion& b, double t, PairMemory& memory) {
  if (has_closed_form(a, b)) {
    const Nearest at = nearest(a, b, a.path().place(t), b.path().place(t));
    return {at.gap, at.p_WCb + at.gap / 2 * at.n, at.n};
  }
  if (memory.time == t) return memory.touch;
  const lin_canny::Proximity at = proximity_at(a, b, t, memory);
  const Vec3 apart = at.p_WCa - at.p_WCb;
  const double far = length(apart);
  return {at.verdict == Verdict::overlapping ? -1.0 : at.distance, (at.p_WCa + at.p_WCb) / 2,
          far > 0 ? Vec3(apart / far) : Vec3(Vec3::Zero())};
}

double first_contact(const BodyMotion& a, const BodyMotion& b, double from, double until, double envelope,
                     const Deviation& deviation, PairMemory& memory) {
  if (has_closed_form(a, b)) {
    const bool alike = a.kind() == b.kind() && a.path().a == b.path().a;
    const double t = !deviation.inflation.is_none() ? with_deviation(a, b, from, until, envelope, deviation)
                     : alike                        ? equally_accelerated_balls(a, b, from, until, envelope)
                             : by_planes(a, b, from, until, envelope, [](double) { return Spread{}; });
    return t <= until ? t : never;
  }
  memory.features.resize(lin_canny::pairs_of_parts(a.model().solid, b.model().solid));
  return by_advancement(a, b, from, until, envelope, deviation.inflation, memory);
}

}  // namespace touchstone::fast::simulation
