// The bodies of a scene as corners and edges in the world frame.
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "model/scene.h"
#include "oracle/truth/world_points.h"

namespace touchstone::app {

/// One convex part, in W: points and the edges between them, or a ball.
struct WirePart {
  int body = 0;
  oracle::Points points;
  std::set<std::pair<int, int>> edges;
  double radius = 0;
};

/// Ordered by body, then by part.
std::vector<WirePart> wire_parts(const Scene& scene);

}  // namespace touchstone::app
