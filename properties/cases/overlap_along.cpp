#include "properties/cases/overlap_along.h"

#include <algorithm>
#include <limits>

namespace touchstone::properties {

using oracle::Point;
using oracle::Real;

Real overlap_along(const Point& n, const Body& A, const Body& B) {
  const auto farthest = [](const Body& body, const Point& d) {
    const auto* ball = std::get_if<Sphere>(&body.shape);
    Real most = -std::numeric_limits<Real>::infinity();
    for (const Point& p : oracle::world_points(body, 0)) most = std::max(most, d.dot(p));
    return most + (ball != nullptr ? ball->radius : 0);
  };
  return farthest(B, n) + farthest(A, -n);
}

}  // namespace touchstone::properties
