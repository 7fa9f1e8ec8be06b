#include "fast/impulse/straight.h"

#include <algorithm>
#include <cmath>

#include "model/infinity.h"

namespace touchstone::fast::impulse {
namespace {

constexpr double never = infinity;

/// The x ≥ 0 with u x + h x²/2 = left, in a form without cancellation.
double left_for_work(double left, double u, double h) {
  if (left <= 0) return 0;
  const double root = u * u + 2 * h * left;
  if (root < 0) return never;
  const double below = u + std::sqrt(root);
  return below > 0 ? 2 * left / below : never;
}

}  // namespace

double impulse_left(const Impact& impact, const Line& line, const Goal& goal, const ImpactState& at) {
  switch (goal.of) {
    case Goal::Of::impulse:
      return std::max(goal.value - at.p, 0.0);
    case Goal::Of::speed: {
      const double left = goal.value - normal_speed(impact, at);
      if (left <= 0) return 0;
      return line.h > 0 ? left / line.h : never;
    }
    case Goal::Of::work:
      return left_for_work(goal.value - at.work, normal_speed(impact, at), line.h);
  }
  return never;
}

Reached go_straight(const Impact& impact, const Line& line, const Goal& goal, ImpactState& at) {
  const double to_goal = impulse_left(impact, line, goal, at);
  const double to_stop = line.g < 0 ? at.s / -line.g : never;
  const bool stops = to_stop < to_goal;
  const double x = stops ? to_stop : to_goal;
  at.work += x * (normal_speed(impact, at) + line.h * x / 2);
  at.P1 += line.t1 * x;
  at.P2 += line.t2 * x;
  at.p = !stops && goal.of == Goal::Of::impulse ? goal.value : at.p + x;
  at.s = stops ? 0 : at.s + line.g * x;
  return stops ? Reached::stop : Reached::goal;
}

}  // namespace touchstone::fast::impulse
