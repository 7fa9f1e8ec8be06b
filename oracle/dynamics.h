// How an engine's dynamics differ by design from the laws of the specification, as data on its card.
#pragma once

#include <optional>
#include <string>

#include "model/scene.h"

namespace touchstone::oracle {

/// How an engine makes one coefficient of the two bodies'. Touchstone's rule is `min`.
enum class Combine { min, max, product, mean, geometric_mean };

/// A body slower than both for so long is put to sleep.
struct Sleep {
  double speed = 0;          ///< m/s
  double angular_speed = 0;  ///< rad/s
  double seconds = 0;

  bool operator==(const Sleep&) const = default;
};

/// What is absent, or 0, does not differ. A scene that depends on a difference is outside what the subject vouches for.
struct Dynamics {
  Combine restitution = Combine::min;
  Combine friction = Combine::min;
  double restitution_threshold = 0;           ///< m/s: a slower approach does not bounce
  bool friction_pyramid = false;              ///< instead of Coulomb's cone
  double linear_damping = 0;                  ///< 1/s
  double angular_damping = 0;                 ///< 1/s
  std::optional<double> speed_limit;          ///< m/s: faster bodies are slowed down
  std::optional<double> angular_speed_limit;  ///< rad/s
  std::optional<Sleep> sleep;

  bool operator==(const Dynamics&) const = default;
};

/// Why the scene's impact depends on what differs, in words with numbers; none if it does not. Requires a contact.
std::optional<std::string> beyond_impact(const Dynamics& dynamics, const Scene& scene);

/// The same for the motion of all bodies. Requires a motion.
std::optional<std::string> beyond_motion(const Dynamics& dynamics, const Scene& scene);

}  // namespace touchstone::oracle
