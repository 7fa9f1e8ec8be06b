// Axes are logarithmic and in whole decades, and names do not cover each other.
#include "app/report/chart.h"

#include <cmath>

#include "tests/catch.h"

namespace touchstone::app {
namespace {

TEST_CASE("An axis has whole decades and equal steps for equal ratios") {
  LogAxes axes{100, 300, 0, 200};
  for (const double value : {2.0, 150.0}) axes.include_x(value), axes.include_y(value);
  axes.close();
  CHECK(axes.x(1) == Approx(100));
  CHECK(axes.x(1000) == Approx(300));
  CHECK(axes.x(10) - axes.x(1) == Approx(axes.x(1000) - axes.x(100)));
  CHECK(axes.y(1) == Approx(200));
  CHECK(axes.y(1000) == Approx(0).margin(1e-9));
  CHECK(axes.y(0) == axes.bottom + LogAxes::below);
}

TEST_CASE("An axis of nothing or of one value can be drawn") {
  LogAxes axes{0, 100, 0, 100};
  axes.include_x_as_edge(8);
  axes.close();
  CHECK(std::isfinite(axes.x(8)));
  CHECK(std::isfinite(axes.y(1)));
}

TEST_CASE("Names are a line apart, and stay within the height if they fit") {
  const std::vector<double> heights = apart({50, 50, 50, 99, 2}, 0, 100);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    CHECK(heights[i] >= 0);
    CHECK(heights[i] <= 100);
    for (std::size_t j = 0; j < i; ++j) CHECK(std::abs(heights[i] - heights[j]) >= line_of_text - 1e-9);
  }
  CHECK(apart({}, 0, 100).empty());
}

}  // namespace
}  // namespace touchstone::app
