// The first contact of two convex parts that do not rotate and have the same acceleration, exactly. Each translates
// uniformly relative to the other, so the distance of their cores is convex in time.
//
// With the vertices a and b of the cores at a time `from`, and the velocity u of A relative to B, the difference of two
// points of the cores a time τ later is
//   v = Σ λ a + τ u − Σ μ b,   Σ λ = Σ μ = 1,   λ, μ ≥ 0.
// Radii and `apart` add up to r.
// r = 0: the least τ with v = 0 is a linear program.
// r > 0: the least |v|² up to the end is a quadratic program. If it is more than r², they miss. If it is r², they touch
//        and no more: v is unique, and the least τ with this v is a linear program.
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>

#include "reference/time_of_impact/encounter.h"

namespace touchstone::reference {

/// Does it never rotate?
bool translates(const BallisticStart& start);

/// Lets a body that translates start at `time` instead, where doubles hold its position there.
void start_later(Body& body, BallisticStart& start, double time);

struct TranslatingContact {
  std::optional<mpq_class> time;  ///< s; none: they miss
};

/// From the time `from`, at which they are apart, to the end. None if one rotates, if their accelerations differ, or if
/// r > 0 and the cores come nearer than r.
std::optional<TranslatingContact> translating_contact(const Parts& parts, const std::array<BallisticStart, 2>& starts,
                                                      double apart, double from, double end);

}  // namespace touchstone::reference
