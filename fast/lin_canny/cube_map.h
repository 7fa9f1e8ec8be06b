// Cells of a cube around the origin, for tables by direction.
#pragma once

#include <algorithm>
#include <cstddef>

#include "model/shape.h"

namespace touchstone::fast::lin_canny {

/// Each face of the cube [-1, 1]³ has n × n square cells. All directions whose ray leaves the cube in one cell belong
/// to it, as far as doubles can tell: at the border of two cells rounding chooses either.
class CubeMap {
 public:
  CubeMap() = default;
  explicit CubeMap(int n) : n_(n) {}

  std::size_t cell_count() const { return static_cast<std::size_t>(6 * n_ * n_); }

  /// Of cells whose next rows are beside them, but for the borders of the cube's faces.
  std::size_t row_length() const { return static_cast<std::size_t>(n_); }

  /// Of d with max |d_i| = 1. Requires n > 0.
  std::size_t cell(const Vec3& d) const {
    int axis = 0;
    d.cwiseAbs().maxCoeff(&axis);
    const int face = 2 * axis + (d[axis] < 0 ? 1 : 0);
    return static_cast<std::size_t>((face * n_ + place(d[(axis + 1) % 3])) * n_ + place(d[(axis + 2) % 3]));
  }

  /// Through the middle of a cell; max |d_i| = 1.
  Vec3 direction(std::size_t cell) const {
    const int at = static_cast<int>(cell);
    const int face = at / (n_ * n_), axis = face / 2;
    Vec3 d;
    d[axis] = face % 2 == 0 ? 1 : -1;
    d[(axis + 1) % 3] = middle(at / n_ % n_);
    d[(axis + 2) % 3] = middle(at % n_);
    return d;
  }

 private:
  int place(double x) const { return std::min(static_cast<int>((x + 1) / 2 * n_), n_ - 1); }
  double middle(int place) const { return (2 * place + 1.0) / n_ - 1; }

  int n_ = 0;
};

}  // namespace touchstone::fast::lin_canny
