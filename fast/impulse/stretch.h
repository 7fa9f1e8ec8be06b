// A stretch of sliding along a curve, as power series; two ways to make one.
#pragma once

#include <optional>

#include "fast/impulse/impact.h"
#include "fast/impulse/series.h"

namespace touchstone::fast::impulse {

/// Over t in [0, length]: the slip speed, and what is added to the impulse along two axes of its own and along n.
struct Stretch {
  Series s, along, across, p;
  double length = 0;
  double c = 1, d = 0;    ///< the axis `along`, in the impact's axes
  double side = 1;        ///< `across` is side·(−d, c)
  Series turn_c, turn_d;  ///< direction of slip in these axes by regularised time; else t is tan of half the turn
  bool by_direction = false;
};

/// t = tan(δ/2), δ the angle that slip has turned: s and p obey linear equations with polynomial coefficients, so a
/// term costs 14 products. None where a root of η is near: there δ says too little about s.
std::optional<Stretch> stretch_by_direction(const Impact& impact, const Course& at);

/// t = τ·rate with dτ = dp/s: (c, d)' = η (−d, c), s' = g s, p' = s, nothing singular. A term costs as many products as
/// there are terms before it.
Stretch stretch_by_time(const Impact& impact, const Course& at);

/// u_n along a stretch, from `start` on.
Series normal_speed(const Impact& impact, const Stretch& stretch, double start);

/// ∫ u_n dp along it.
Series work(const Stretch& stretch, const Series& normal_speed);

/// Goes to t.
void advance(const Stretch& stretch, double t, double work, Course& at);

}  // namespace touchstone::fast::impulse
