#include "fast/impulse/curve.h"

#include <algorithm>
#include <cmath>

#include "fast/impulse/phase.h"
#include "fast/impulse/stop.h"
#include "fast/impulse/turning.h"
#include "fast/mark.h"

namespace touchstone::fast::impulse {
namespace {

/// Where slip ends if it stops after the normal impulse `left`: then u_t = 0.
ImpactState stopped_after(const Impact& i, const ImpactState& at, double left) {
  ImpactState end = at;
  end.p += left;
  end.P1 -= (at.s * at.c + i.k1 * left) / i.l1;
  end.P2 -= (at.s * at.d + i.k2 * left) / i.l2;
  end.s = 0;
  return end;
}

/// Whether slip surely does not stop before the goal, without the series: for most phases. |ds/dp| ≤ rate, so slip
/// lasts for s/rate at least; less a part that is far above rounding. p at the stop grows with what is left, and so
/// does u_n, by K_nn − k·A⁻¹k > 0, as A⁻¹ makes u_t vanish. If that is a thousandth of K_nn and u_n at the least stop
/// is above the goal by more than rounding, it is so at the stop.
bool surely_reaches(const Impact& i, const Goal& goal, const ImpactState& at) {
  constexpr double less = 1 - 0x1p-20, least_rise = 0x1p-10, rounding = 0x1p-40;
  const double least = less * (at.s / rate(i));
  if (goal.of == Goal::Of::impulse) return at.p + least >= goal.value;
  if (!(i.b - (i.k1 * i.k1 / i.l1 + i.k2 * i.k2 / i.l2) > least_rise * i.b)) return false;
  const ImpactState end = stopped_after(i, at, least);
  const double terms = std::abs(i.un) + std::abs(i.k1 * end.P1) + std::abs(i.k2 * end.P2) + i.b * end.p;
  return normal_speed(i, end) >= goal.value + rounding * terms;
}

/// Whether slip stops before the goal; if so, advances to there. From the series for the remaining impulse, if it
/// applies.
bool stops(const Impact& i, const Goal& goal, ImpactState& at) {
  if (i.law == Law::stronge) return false;  // the series does not give the work
  if (surely_reaches(i, goal, at)) return false;
  const auto left = until_stop(i, at);
  if (!left) return false;
  const ImpactState end = stopped_after(i, at, left->impulse);
  if (goal.of == Goal::Of::impulse && end.p >= goal.value) return false;
  // On the way u_n must not pass the goal and come back: its slope keeps its sign over the remaining arc.
  const double h = i.b - i.mu * (i.k1 * at.c + i.k2 * at.d), k = std::sqrt(i.k1 * i.k1 + i.k2 * i.k2);
  const bool one_way = i.b > i.mu * k || std::abs(h) > left->turn * i.mu * k;
  if (goal.of == Goal::Of::speed && (!one_way || normal_speed(i, end) >= goal.value)) return false;
  at = end;
  return true;
}

}  // namespace

bool is_straight(const Impact& i, const ImpactState& at) {
  const double eta = i.k2 * at.c - i.k1 * at.d + i.mu * (i.l1 - i.l2) * at.c * at.d;
  return std::abs(eta) <= 0x1p-50 * rate(i);
}

CurveEnd go_round(const Impact& i, const Goal& goal, ImpactState& at, double& closest_miss) {
  const double speeds = std::abs(i.u1) + std::abs(i.u2) + std::abs(i.un);
  mark(Mark::impulse_curve);
  Phase phase;
  while (at.s > 0x1p-70 * speeds) {
    if (is_straight(i, at)) return CurveEnd::straightened;
    if (stops(i, goal, at)) {
      mark(Mark::impulse_series);
      return CurveEnd::stop;
    }
    mark(Mark::impulse_phase);
    if (!phase_by_direction(i, at, phase)) phase_by_time(i, at, phase);
    const Series u = normal_speed(i, phase, normal_speed(i, at));
    const Series W = i.law == Law::stronge ? work(phase, u) : Series();
    if (i.law == Law::stronge) {  // its own series converges more slowly than its factors
      phase.length = std::min(phase.length, length_of(W, speeds * at.s / rate(i)));
    }
    const Series& x = goal.of == Goal::Of::speed ? u : goal.of == Goal::Of::work ? W : phase.p;
    const double before = goal.of == Goal::Of::work ? at.work : goal.of == Goal::Of::impulse ? at.p : 0;
    const auto here = first_reach(x, goal.value - before, phase.length, closest_miss);
    const double t = here.value_or(phase.length);
    advance(phase, t, W(t), at);
    if (here && goal.of == Goal::Of::impulse) at.p = goal.value;
    if (here) return CurveEnd::goal;
  }
  at.s = 0;
  return CurveEnd::stop;
}

}  // namespace touchstone::fast::impulse
