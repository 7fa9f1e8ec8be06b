// What an image-space test keeps of a convex part: one interval of depths a pixel.
#pragma once

#include <limits>
#include <vector>

#include "fast/pixel/posed_part.h"

namespace touchstone::fast::pixels {

/// What is known about the depths [z0, z1] of a part above a square or a centre; none where lo > hi.
struct Depths {
  static constexpr double none = std::numeric_limits<double>::infinity();

  double lo = none;  ///< lo ≤ z0 and z1 ≤ hi, if the part is there at all
  double hi = -none;
  double inner_lo = none;  ///< z0 ≤ inner_lo and inner_hi ≤ z1, if the part is there for certain; else ∓none
  double inner_hi = -none;

  bool maybe() const { return lo <= hi; }
  bool certain() const { return inner_lo < none; }
};

/// The pixels of a raster's rectangle. Outside nothing is there.
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

/// Above the centres. Where the part is there, or not, for certain, doubles have proved it; the rest is for exact
/// arithmetic.
DepthMap above_centres(const PosedPart& part, const std::vector<std::vector<int>>& faces, const Grid& grid);

/// Above the closed squares: lo and hi hold all depths, and each depth in them is within 2·part.error of a point of the
/// part within as much of the square. `inner` is not filled in.
DepthMap above_squares(const PosedPart& part, const std::vector<std::vector<int>>& faces, const Grid& grid);

}  // namespace touchstone::fast::pixels
