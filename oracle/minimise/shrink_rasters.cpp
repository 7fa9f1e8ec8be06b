// Smaller rasters: fewer columns and rows from either side, and no shift.
#include "oracle/minimise/shrink.h"

namespace touchstone::oracle::shrink {
namespace {

/// Removes `first` columns or rows at the start and `last` at the end.
std::optional<Scene> cropped(Scene scene, bool columns, int first, int last) {
  if (!scene.raster) return std::nullopt;
  Raster& raster = *scene.raster;
  int& count = columns ? raster.columns : raster.rows;
  if (first + last >= count) return std::nullopt;
  count -= first + last;
  (columns ? raster.x : raster.y) += first * raster.pixel;
  return scene;
}

std::optional<Scene> without_raster(Scene scene) {
  scene.raster.reset();
  return scene;
}

std::optional<Scene> with_shift(Scene scene, int x, int y) {
  if (!scene.raster) return std::nullopt;
  scene.raster->shift_x = x;
  scene.raster->shift_y = y;
  return scene;
}

}  // namespace

std::vector<Move> fewer_pixels(const Scene& scene) {
  if (!scene.raster) return {};
  const Raster raster = *scene.raster;
  std::vector<Move> moves = {without_raster, [](const Scene& s) { return with_shift(s, 0, 0); }};
  for (const bool columns : {true, false}) {
    for (int less = (columns ? raster.columns : raster.rows) / 2; less > 0; less /= 2) {
      moves.push_back([=](const Scene& s) { return cropped(s, columns, 0, less); });
      moves.push_back([=](const Scene& s) { return cropped(s, columns, less, 0); });
    }
  }
  moves.push_back([raster](const Scene& s) { return with_shift(s, 0, raster.shift_y); });
  moves.push_back([raster](const Scene& s) { return with_shift(s, raster.shift_x, 0); });
  moves.push_back([raster](const Scene& s) { return with_shift(s, raster.shift_x / 2, raster.shift_y / 2); });
  return moves;
}

}  // namespace touchstone::oracle::shrink
