#include "oracle/dynamics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oracle/tolerance/motion.h"
#include "oracle/truth/impact.h"

namespace touchstone::oracle {
namespace {

using Reason = std::optional<std::string>;

double combined(Combine rule, double a, double b) {
  switch (rule) {
    case Combine::min:
      return std::min(a, b);
    case Combine::max:
      return std::max(a, b);
    case Combine::product:
      return a * b;
    case Combine::mean:
      return (a + b) / 2;
    case Combine::geometric_mean:
      return std::sqrt(a * b);
  }
  return std::min(a, b);
}

// The first reason that `of(a, b)` gives for two bodies that may meet.
template <class Of>
Reason of_pairs(const Scene& scene, Of&& of) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Body &a = scene.bodies[j], &b = scene.bodies[i];
      if (is_fixed(a) && is_fixed(b)) continue;
      if (Reason why = of(a.material, b.material)) return why;
    }
  }
  return std::nullopt;
}

Reason beyond_combination(Combine rule, double a, double b, const char* what) {
  const double made = combined(rule, a, b), least = std::min(a, b);
  if (std::abs(made - least) <= 0x1p-20 * least) return std::nullopt;  // a root rounds
  return fmt::format("two coefficients of {}, {:.3g} and {:.3g}, become {:.3g}", what, a, b, made);
}

Reason beyond_materials(const Dynamics& it, const Scene& scene, double fastest) {
  return of_pairs(scene, [&](const Material& a, const Material& b) -> Reason {
    if (Reason why = beyond_combination(it.restitution, a.restitution, b.restitution, "restitution")) return why;
    if (Reason why = beyond_combination(it.friction, a.friction, b.friction, "friction")) return why;
    if (it.friction_pyramid && std::min(a.friction, b.friction) > 0) return "friction, by a pyramid";
    if (std::min(a.restitution, b.restitution) > 0 && 2 * fastest < it.restitution_threshold)
      return fmt::format("all approaches are slower than the {:.3g} m/s that bounce", it.restitution_threshold);
    return std::nullopt;
  });
}

bool may_sleep(const Body& body, const Sleep& sleep) {
  const double v = body.velocity.v_WBcm.norm(), w = body.velocity.w_WB.norm();
  return !is_fixed(body) && (v > 0 || w > 0) && v < sleep.speed && w < sleep.angular_speed;
}

Reason beyond_speeds(const Dynamics& it, const Scene& scene, double fastest) {
  double spin = 0;
  for (const Body& body : scene.bodies) spin = std::max(spin, body.velocity.w_WB.norm());
  if (fastest > it.speed_limit.value_or(fastest))
    return fmt::format("a speed of up to {:.3g} m/s is limited to {:.3g} m/s", fastest, *it.speed_limit);
  if (spin > it.angular_speed_limit.value_or(spin))
    return fmt::format("a spin of {:.3g} rad/s is limited to {:.3g} rad/s", spin, *it.angular_speed_limit);
  if (it.linear_damping > 0 && fastest > 0) return fmt::format("motion, damped by {:.3g}/s", it.linear_damping);
  if (it.angular_damping > 0 && spin > 0) return fmt::format("a spin, damped by {:.3g}/s", it.angular_damping);
  return std::nullopt;
}

}  // namespace

Reason beyond_impact(const Dynamics& it, const Scene& scene) {
  if (it.friction_pyramid && scene.contact->friction > 0) return "friction, by a pyramid";
  if (it.restitution_threshold <= 0 || scene.contact->restitution == 0) return std::nullopt;
  const double approach = static_cast<double>(-impact(scene).u_n());
  if (!(approach < it.restitution_threshold)) return std::nullopt;
  return fmt::format("an approach of {:.3g} m/s is slower than the {:.3g} m/s that bounce", approach,
                     it.restitution_threshold);
}

Reason beyond_motion(const Dynamics& it, const Scene& scene) {
  const double seconds = scene.motion->sample_times.back();
  const double fastest = tolerance::fastest_at_start(scene) + scene.gravity.norm() * seconds;
  if (Reason why = beyond_materials(it, scene, fastest)) return why;
  if (Reason why = beyond_speeds(it, scene, fastest)) return why;
  if (it.sleep && seconds > it.sleep->seconds) {
    for (const Body& body : scene.bodies) {
      if (may_sleep(body, *it.sleep)) return "a body so slow that it is put to sleep";
    }
  }
  return std::nullopt;
}

}  // namespace touchstone::oracle
