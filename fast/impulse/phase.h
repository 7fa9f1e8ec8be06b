// A phase of curved sliding, as power series; two ways to compute one.
#pragma once

#include "fast/impulse/impact.h"
#include "fast/impulse/series.h"

namespace touchstone::fast::impulse {

/// Over t in [0, length]: the slip speed, and the impulse added along two axes of its own and along n.
struct Phase {
  Series s, along, across, p;
  double length = 0;
  double c = 1, d = 0;  ///< the axis `along`, in the axes of the impact
  double side = 1;      ///< `across` is side·(−d, c)
  /// Direction of slip in these axes, if t is regularised time; otherwise t is tan of half the turn.
  Series turn_c, turn_d;
  bool by_direction = false;
};

/// t = tan(δ/2), δ the angle that slip has turned: s and p obey linear equations with polynomial coefficients, so a
/// term costs 14 products. Makes `phase`; false if a root of η is near: there δ says too little about s.
bool phase_by_direction(const Impact& impact, const ImpactState& at, Phase& phase);

/// t = τ·rate with dτ = dp/s: (c, d)' = η (−d, c), s' = g s, p' = s, without singularities. A term costs as many
/// products as there are terms before it.
void phase_by_time(const Impact& impact, const ImpactState& at, Phase& phase);

/// u_n along a phase, starting at `start`.
Series normal_speed(const Impact& impact, const Phase& phase, double start);

/// ∫ u_n dp along it.
Series work(const Phase& phase, const Series& normal_speed);

/// Advances the state to t.
void advance(const Phase& phase, double t, double work, ImpactState& at);

}  // namespace touchstone::fast::impulse
