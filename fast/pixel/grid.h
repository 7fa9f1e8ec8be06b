// A raster's lines and centres in doubles.
#pragma once

#include <algorithm>
#include <cmath>

#include "model/scene.h"

namespace touchstone::fast::pixel {

/// One axis. A computed line or centre is within 2^-51 of the greatest coordinate on the raster: three roundings.
struct Axis {
  double start = 0;
  double pixel = 1;
  int count = 1;

  double line(int i) const { return start + i * pixel; }
  double centre(int i) const { return start + (i + 0.5) * pixel; }
  double greatest() const { return std::max(std::abs(start), std::abs(line(count))); }

  /// The pixels that [lo, hi] may overlap: from the first to one past the last. One more on each side covers rounding,
  /// which moves the quotient by less than a pixel unless pixels are below the rounding of x, and `slack` covers that.
  int first(double lo, double slack) const { return index((lo - slack - start) / pixel - 1); }
  int end(double hi, double slack) const { return index((hi + slack - start) / pixel + 2); }

 private:
  int index(double i) const { return static_cast<int>(std::clamp(std::floor(i), 0.0, static_cast<double>(count))); }
};

struct Grid {
  explicit Grid(const Raster& raster)
      : x{raster.x, raster.pixel, raster.columns}, y{raster.y, raster.pixel, raster.rows} {}

  Axis x;
  Axis y;
};

}  // namespace touchstone::fast::pixel
