// Changes of a motion under which the truth changes by a known law, done without rounding. Return none where doubles
// would round.
#pragma once

#include <optional>

#include "model/scene.h"

namespace touchstone::properties {

/// Time runs 2^k times as fast: sample and start times times 2^-k, velocities times 2^k, gravity and forces times 4^k.
std::optional<Scene> hastened(Scene scene, int k);

/// Densities, given masses and inertias, and forces times 2^k: no motion changes.
std::optional<Scene> heavier(Scene scene, int k);

/// All sample times, starts and forces later by `seconds`.
std::optional<Scene> later(Scene scene, double seconds);

/// Adds the same velocity to that of all bodies, fixed ones too. None unless all start at once.
std::optional<Scene> carried(Scene scene);

/// Removes gravity. None unless all bodies fall from the same time on.
std::optional<Scene> weightless(Scene scene);

/// Changes the rotation of balls about their centres. None if the scene has no such ball.
std::optional<Scene> spun_balls(Scene scene);

/// The scene as it is at `time`, with the motion from there. None if a body has turned by then, or a number rounds.
std::optional<Scene> taken_up_at(Scene scene, double time);

/// From the end of the motion back to its start. None as above.
std::optional<Scene> backwards(const Scene& scene);

}  // namespace touchstone::properties
