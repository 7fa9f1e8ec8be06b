// The image-space data of a convex part: one interval of depths per pixel.
#pragma once

#include <vector>

#include "fast/pixel/posed_part.h"
#include "model/infinity.h"

namespace touchstone::fast::pixel {

/// Bounds on the depths [z0, z1] of a part above a square or a centre; empty if lo > hi.
struct Depths {
  static constexpr double none = infinity;

  double lo = none;  ///< if the part is above the pixel at all: lo ≤ z0 and z1 ≤ hi
  double hi = -none;
  double inner_lo = none;  ///< if it certainly is: z0 ≤ inner_lo and inner_hi ≤ z1; else ∓none
  double inner_hi = -none;

  bool maybe() const { return lo <= hi; }
  bool certain() const { return inner_lo < none; }
};

/// The pixels of a rectangle of the raster. Outside it there is nothing.
struct DepthMap {
  int first_column = 0, end_column = 0;
  int first_row = 0, end_row = 0;
  std::vector<Depths> depths;

  Depths& at(int column, int row) {
    const auto width = static_cast<std::size_t>(end_column - first_column);
    return depths[static_cast<std::size_t>(row - first_row) * width + static_cast<std::size_t>(column - first_column)];
  }
  const Depths& at(int column, int row) const { return const_cast<DepthMap&>(*this).at(column, row); }
  bool covers(int column, int row) const {
    return column >= first_column && column < end_column && row >= first_row && row < end_row;
  }
};

/// Depths above the pixels' centres. `maybe` and `certain` are proved by doubles; where they differ, exact arithmetic
/// has to decide.
DepthMap above_centres(const PosedPart& part, const std::vector<std::vector<int>>& faces, const Grid& grid);

/// Depths above the closed squares: lo and hi contain all depths, and each depth between them is within 2·part.error of
/// a point of the part that is within as much of the square. `inner_lo` and `inner_hi` are not set.
DepthMap above_squares(const PosedPart& part, const std::vector<std::vector<int>>& faces, const Grid& grid);

}  // namespace touchstone::fast::pixel
