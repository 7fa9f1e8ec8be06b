// Bodies for tests of islands: bodies of a small scene at their first states, and their contact graph.
#pragma once

#include "fast/simulation/island/contact_graph.h"
#include "tests/fast/simulation/scenes.h"

namespace touchstone::fast::simulation {

inline constexpr double near = 0x1p-10, reach = 0.125;

struct IslandBodies {
  IslandBodies(std::vector<Body> given, const Vec3& applied) : bodies(std::move(given)), acceleration(applied) {
    for (const Body& body : bodies) motions.emplace_back(body, 0, applied);
  }

  IslandBody operator[](BodyId id) const {
    const BodyMotion& body = motions[id];
    return {id, &body, {&body.model(), body.state(0), body.fixed() ? Vec3(Vec3::Zero()) : acceleration}};
  }

  /// Of all bodies, with all contact pairs.
  ContactGraph graph(double near, double reach) const {
    ContactGraph graph(near, reach);
    const auto count = static_cast<BodyId>(bodies.size());
    for (BodyId id = 0; id < count; ++id) graph.add((*this)[id]);
    for (BodyId b = 0; b < count; ++b) {
      for (BodyId a = 0; a < b; ++a) {
        if (!motions[a].fixed() || !motions[b].fixed()) graph.link(a, b);
      }
    }
    return graph;
  }

  std::vector<Body> bodies;
  std::vector<BodyMotion> motions;
  Vec3 acceleration;
};

}  // namespace touchstone::fast::simulation
