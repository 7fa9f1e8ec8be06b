// Changes of a flight under which the truth changes by a known law, done without rounding; none where doubles cannot.
#pragma once

#include <optional>

#include "model/scene.h"

namespace touchstone::properties {

/// Time runs 2^k times as fast: times and starts times 2^-k, velocities times 2^k, gravity and forces times 4^k.
std::optional<Scene> hastened(Scene scene, int k);

/// All times, starts and pushes later by `seconds`.
std::optional<Scene> later(Scene scene, double seconds);

/// The same velocity for all bodies, fixed ones too, on top of their own; none unless all start at once.
std::optional<Scene> carried(Scene scene);

/// Without gravity; none unless all bodies fall from the same time on.
std::optional<Scene> weightless(Scene scene);

/// Balls that turn about their centres otherwise; none if the scene has no such ball.
std::optional<Scene> spun_balls(Scene scene);

/// The scene as it stands at `time`, and the flight from there; none if a body is turned by then, or a number rounds.
std::optional<Scene> taken_up_at(Scene scene, double time);

/// From the flight's end back to where it began; none as above.
std::optional<Scene> backwards(const Scene& scene);

}  // namespace touchstone::properties
