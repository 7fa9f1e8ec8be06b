// What all adapters pass to engines, and how they turn engines' results into answers.
#pragma once

#include <algorithm>
#include <variant>
#include <vector>

#include "model/answers.h"
#include "model/scene.h"
#include "oracle/rotation.h"

namespace touchstone::oracle::subjects {

/// The engines' pair queries take convex bodies only, no unions.
inline bool has_compound(const Scene& scene) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(),
                     [](const Body& body) { return std::holds_alternative<Compound>(body.shape); });
}

inline const Abstains no_compounds{"no query for unions of convex parts"};

/// A shape that is no compound is its only part.
inline std::vector<Part> parts_of(const Shape& shape) {
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return {{{}, *sphere}};
  if (const auto* box = std::get_if<Box>(&shape)) return {{{}, *box}};
  if (const auto* polytope = std::get_if<Polytope>(&shape)) return {{{}, *polytope}};
  return std::get<Compound>(shape).parts;
}

inline bool has_hull(const Body& body) {
  return std::ranges::any_of(parts_of(body.shape),
                             [](const Part& part) { return std::holds_alternative<Polytope>(part.shape); });
}

inline Distance apart(double distance, const Vec3& p_WCa, const Vec3& p_WCb) {
  Distance said;
  said.verdict = Verdict::separated;
  said.distance = distance;
  said.p_WCa = p_WCa;
  said.p_WCb = p_WCb;
  return said;
}

/// The answer of an engine that reports a collision without further data.
inline Distance in_collision() {
  Distance said;
  said.verdict = Verdict::overlapping;
  said.distance = 0;
  return said;
}

inline Penetration no_penetration() { return {Verdict::separated, 0.0, std::nullopt}; }

inline Penetration deep(double depth, const Vec3& nhat_BA_W) { return {Verdict::overlapping, depth, nhat_BA_W}; }

}  // namespace touchstone::oracle::subjects
