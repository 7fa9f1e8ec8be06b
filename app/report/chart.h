// What the plots share: logarithmic axes, their grid, and names that do not cover each other.
#pragma once

#include <string>
#include <vector>

namespace touchstone::app {

/// Both axes are logarithmic. Values that are not positive lie below the vertical axis, infinite ones above it.
struct LogAxes {
  double left = 0, right = 0, top = 0, bottom = 0;          ///< px: edges of the plot's area
  double x0 = 1e300, x1 = -1e300, y0 = 1e300, y1 = -1e300;  ///< decades at the edges

  static constexpr double below = 16;  ///< px: from the lower edge to the values that are not positive
  static constexpr double above = 14;  ///< px: from the upper edge to the infinite ones

  /// Widens a range to contain the value; to whole decades, unless the value itself is to be an edge. Requires a
  /// positive value.
  void include_x(double value);
  void include_x_as_edge(double value);
  void include_y(double value);  ///< and finite

  /// Ranges that contain nothing become one or two decades about 1.
  void close();

  double x(double value) const;
  double y(double value) const;

  /// Lines and numbers for each decade of the vertical axis.
  std::string rows() const;
  /// Lines and numbers for each decade of the horizontal axis, `under` px under the lower edge.
  std::string columns(double under) const;
  std::string column(double value, const std::string& name, double under) const;
};

/// The heights at which names stand that would best be at `wanted`: at least a line apart, between top and bottom if
/// there is room.
std::vector<double> apart(const std::vector<double>& wanted, double top, double bottom);

inline constexpr double line_of_text = 12;  ///< px

}  // namespace touchstone::app
