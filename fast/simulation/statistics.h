// Counters and energy sums of a simulation.
#pragma once

#include <array>
#include <cstdint>
#include <numeric>

#include "model/answers.h"

namespace touchstone::fast::simulation {

/// Sums over all events so far. Ballistic motion loses no energy: while bodies only move ballistically, collide and
/// take contact steps, the sum of kinetic and potential energy falls by `loss` + `contact_loss`, and momentum changes
/// only by what gravity and applied forces give and fixed bodies take.
struct Statistics {
  std::array<std::int64_t, 6> count{};  ///< events, indexed by kind
  std::int64_t frames = 0;
  std::int64_t pairs = 0;          ///< queries for the first contact of a pair
  std::int64_t contact_steps = 0;  ///< steps taken by islands
  std::int64_t unconverged = 0;    ///< of these, steps whose residual exceeds the accuracy that they aim at
  double residual = 0;             ///< m; greatest residual of a step (contact/step.h)
  double deepest = 0;              ///< m; greatest depth of two bodies in contact at the end of a step
  double loss = 0;                 ///< J; kinetic energy lost in impacts
  double contact_loss = 0;         ///< J; energy lost in contact steps
  Vec3 to_fixed = Vec3::Zero();    ///< N s; momentum that fixed bodies took in impacts

  std::int64_t of(Event::Kind kind) const { return count[static_cast<std::size_t>(kind)]; }
  std::int64_t events() const { return std::reduce(count.begin(), count.end()); }
};

}  // namespace touchstone::fast::simulation
