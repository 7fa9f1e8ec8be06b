#include "properties/transforms/raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "properties/transforms/exact_sum.h"

namespace touchstone::properties {
namespace {

/// n times x, if it is exact in a double.
std::optional<double> times(int n, double x) {
  const double product = n * x;
  if (!std::isfinite(product) || std::fma(n, x, -product) != 0) return std::nullopt;
  return product;
}

/// −n, except for the least int, whose negative does not exist: both are beyond any raster.
int opposite(int n) { return -std::max(n, -std::numeric_limits<int>::max()); }

}  // namespace

std::optional<Scene> moved_by_pixels(Scene scene, const std::vector<std::size_t>& bodies, int right, int up) {
  if (!scene.raster) return std::nullopt;
  const std::optional<double> dx = times(right, scene.raster->pixel);
  const std::optional<double> dy = times(up, scene.raster->pixel);
  if (!dx || !dy) return std::nullopt;
  for (const std::size_t b : bodies) {
    if (b >= scene.bodies.size()) return std::nullopt;
    const std::optional<Vec3> p = exact_sum(scene.bodies[b].X_WB.p_WB, Vec3(*dx, *dy, 0));
    if (!p) return std::nullopt;
    scene.bodies[b].X_WB.p_WB = *p;
  }
  return scene;
}

Raster with_opposite_shift(Raster raster) {
  raster.shift_x = opposite(raster.shift_x);
  raster.shift_y = opposite(raster.shift_y);
  return raster;
}

std::optional<Raster> translated(Raster raster, const Vec3& t) {
  const std::optional<Vec3> corner = exact_sum(Vec3(raster.x, raster.y, 0), Vec3(t.x(), t.y(), 0));
  if (!corner) return std::nullopt;
  raster.x = corner->x();
  raster.y = corner->y();
  return raster;
}

std::optional<Raster> scaled(const Raster& raster, int k) {
  Raster result = raster;
  for (double* length : {&result.x, &result.y, &result.pixel}) *length = std::ldexp(*length, k);
  const auto undone = [k](double after, double before) {
    return std::isfinite(after) && std::ldexp(after, -k) == before;
  };
  if (!undone(result.x, raster.x) || !undone(result.y, raster.y) || !undone(result.pixel, raster.pixel))
    return std::nullopt;
  return result;
}

}  // namespace touchstone::properties
