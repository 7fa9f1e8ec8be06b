// What is kept count of while a simulation runs.
#pragma once

#include <array>
#include <cstdint>

#include "model/answers.h"

namespace touchstone::fast::world {

/// Sums over all events so far. Flight loses nothing: while bodies only fly, collide and take steps in contact, kinetic
/// and potential energy together fall by `loss` and `contact_loss`, and momentum changes by what gravity and pushes
/// give and fixed bodies take.
struct Books {
  std::array<std::int64_t, 6> count{};  ///< by kind of event
  std::int64_t frames = 0;
  std::int64_t pairs = 0;          ///< asked when they may meet
  std::int64_t contact_steps = 0;  ///< taken by bodies that hold each other
  double deepest = 0;              ///< m; how deep two of them were in each other at the end of a step
  double loss = 0;                 ///< J; kinetic energy that impacts took
  double contact_loss = 0;         ///< J; what bodies lost while they took steps in contact
  Vec3 to_fixed = Vec3::Zero();    ///< N s; what fixed bodies took of the others' momentum, impacts only

  std::int64_t of(Event::Kind kind) const { return count[static_cast<std::size_t>(kind)]; }
};

}  // namespace touchstone::fast::world
