#include "fast/pixel/depth_map.h"

#include <algorithm>
#include <cmath>

#include "fast/pixel/cut.h"

namespace touchstone::fast::pixel {
namespace {

DepthMap empty_map(const PosedPart& part, const Grid& grid) {
  DepthMap map;
  map.first_column = grid.x.first(part.box.lo.x(), part.error);
  map.end_column = std::max(map.first_column, grid.x.end(part.box.hi.x(), part.error));
  map.first_row = grid.y.first(part.box.lo.y(), part.error);
  map.end_row = std::max(map.first_row, grid.y.end(part.box.hi.y(), part.error));
  map.depths.resize(static_cast<std::size_t>(map.end_column - map.first_column) *
                    static_cast<std::size_t>(map.end_row - map.first_row));
  return map;
}

struct Extent {
  double lo, hi;
};

Extent extent(const Loop& loop, int axis) {
  Extent s{loop.front()[axis], loop.front()[axis]};
  for (const Vec3& p : loop) s = {std::min(s.lo, p[axis]), std::max(s.hi, p[axis])};
  return s;
}

/// The interval of an axis that a pixel represents.
using Range = Extent (*)(const Axis&, int);
Extent of_square(const Axis& axis, int i) { return {axis.line(i), axis.line(i + 1)}; }
Extent of_centre(const Axis& axis, int i) { return {axis.centre(i), axis.centre(i)}; }

/// Calls f(column, row, depths) wherever the face may be above the pixels' ranges.
template <class F>
void for_each_pixel(const Loop& face, const Grid& grid, double error, Range range, F&& f) {
  const Extent height = extent(face, 1);
  Loop scratch, in_row, in_pixel;
  for (int j = grid.y.first(height.lo, error); j < grid.y.end(height.hi, error); ++j) {
    const Extent y = range(grid.y, j);
    cut(face, 1, y.lo - error, y.hi + error, scratch, in_row);
    if (in_row.empty()) continue;
    const Extent width = extent(in_row, 0);
    for (int i = grid.x.first(width.lo, error); i < grid.x.end(width.hi, error); ++i) {
      const Extent x = range(grid.x, i);
      cut(in_row, 0, x.lo - error, x.hi + error, scratch, in_pixel);
      if (in_pixel.empty()) continue;
      const Extent z = extent(in_pixel, 2);
      f(i, j, Extent{z.lo - error, z.hi + error});
    }
  }
}

// The loop's corners are within `error` of the true face's. If (x, y) and everything within `error` of it (along the
// axes) is on one side of all edges as computed, the loop winds around it, so the loop's hull contains it with that
// margin, and so does the true face's projection. The error of an edge's (q − p) × (c − p) is at most 8u|q − p|₁ times
// the lengths involved, all below 2S, and `error` is 128 u S: doubling its share covers that. Underflow adds 2^-1070;
// overflow is not finite and proves nothing.
bool certainly_above(const Loop& face, double x, double y, double error) {
  int left = 0;
  int right = 0;
  for (std::size_t k = 0; k < face.size(); ++k) {
    const Vec3& p = face[k];
    const Vec3& q = face[k + 1 < face.size() ? k + 1 : 0];
    const double ex = q.x() - p.x();
    const double ey = q.y() - p.y();
    const double side = ex * (y - p.y()) - ey * (x - p.x());
    const double margin = 2 * error * (std::abs(ex) + std::abs(ey)) + 0x1p-1060;
    if (!std::isfinite(side)) return false;
    if (side > margin) ++left;
    if (side < -margin) ++right;
    if (left > 0 && right > 0) return false;
  }
  const int all = static_cast<int>(face.size());
  return left == all || right == all;
}

Loop loop_of(const PosedPart& part, const std::vector<int>& face) {
  Loop loop;
  for (const int i : face) loop.push_back(part.vertices[static_cast<std::size_t>(i)]);
  return loop;
}

void widen(Depths& known, const Extent& z) {
  known.lo = std::min(known.lo, z.lo);
  known.hi = std::max(known.hi, z.hi);
}

double least_distance(double x, const Extent& range, double error) {
  return std::max({range.lo - x - error, x - range.hi - error, 0.0});
}

/// √(r² − d²), without leaving the range.
double half_chord(double r, double d) { return d >= r ? 0 : std::sqrt(r - d) * std::sqrt(r + d); }

double length(double x, double y) {
  const double more = std::max(std::abs(x), std::abs(y));
  const double less = std::min(std::abs(x), std::abs(y));
  return more == 0 ? 0 : more * std::sqrt(1 + (less / more) * (less / more));
}

// A ball of radius r + error around the rounded centre contains the true one; one of r − error is contained in it. The
// distance d and the root have errors of some u(r + d), for which `error` has room.
template <class F>
void for_each_ball_pixel(const PosedPart& ball, DepthMap& map, const Grid& grid, Range range, F&& finish) {
  const Vec3& c = ball.vertices.front();
  for (int j = map.first_row; j < map.end_row; ++j) {
    const double dy = least_distance(c.y(), range(grid.y, j), ball.error);
    for (int i = map.first_column; i < map.end_column; ++i) {
      const double d = length(least_distance(c.x(), range(grid.x, i), ball.error), dy);
      if (d > ball.radius + ball.error) continue;
      const double reach = half_chord(ball.radius + ball.error, d) + ball.error;
      Depths& known = map.at(i, j);
      widen(known, {c.z() - reach, c.z() + reach});
      finish(known, i, j);
    }
  }
}

}  // namespace

DepthMap above_centres(const PosedPart& part, const std::vector<std::vector<int>>& faces, const Grid& grid) {
  DepthMap map = empty_map(part, grid);
  if (part.is_sphere()) {
    const Vec3& c = part.vertices.front();
    for_each_ball_pixel(part, map, grid, of_centre, [&](Depths& known, int i, int j) {
      const double d = length(grid.x.centre(i) - c.x(), grid.y.centre(j) - c.y()) + 2 * part.error;
      if (d >= part.radius - part.error) return;
      const double reach = half_chord(part.radius - part.error, d) - part.error;
      known.inner_lo = c.z() - reach;
      known.inner_hi = c.z() + reach;
    });
  }
  for (const std::vector<int>& face : faces) {
    const Loop loop = loop_of(part, face);
    for_each_pixel(loop, grid, part.error, of_centre, [&](int i, int j, const Extent& z) {
      Depths& known = map.at(i, j);
      widen(known, z);
      if (!certainly_above(loop, grid.x.centre(i), grid.y.centre(j), part.error)) return;
      known.inner_lo = std::min(known.inner_lo, z.hi);
      known.inner_hi = std::max(known.inner_hi, z.lo);
    });
  }
  return map;
}

DepthMap above_squares(const PosedPart& part, const std::vector<std::vector<int>>& faces, const Grid& grid) {
  DepthMap map = empty_map(part, grid);
  if (part.is_sphere()) for_each_ball_pixel(part, map, grid, of_square, [](Depths&, int, int) {});
  for (const std::vector<int>& face : faces) {
    for_each_pixel(loop_of(part, face), grid, part.error, of_square,
                   [&](int i, int j, const Extent& z) { widen(map.at(i, j), z); });
  }
  return map;
}

}  // namespace touchstone::fast::pixel
