#include <algorithm>
#include <functional>

#include "app/adapter/paper/build.h"

namespace touchstone::app {
namespace {

using InSquare = std::function<bool(const Vec3& lo, const Vec3& hi)>;

/// A pixel is in the mask if `test` accepts its square, which is shrunk to its centre for a sampled mask.
Mask mask(const Raster& raster, bool sampled, const InSquare& test) {
  Mask rows(static_cast<std::size_t>(raster.rows), std::string(static_cast<std::size_t>(raster.columns), '0'));
  for (int j = 0; j < raster.rows; ++j) {
    for (int i = 0; i < raster.columns; ++i) {
      const Vec3 lo(raster.x + i * raster.pixel, raster.y + j * raster.pixel, 0), side(raster.pixel, raster.pixel, 0);
      const bool in = sampled ? test(lo + side / 2, lo + side / 2) : test(lo, lo + side);
      if (in) rows[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] = '1';
    }
  }
  return rows;
}

/// Intervals that intersect, along x and y.
InSquare rectangle(const Vec3& from, const Vec3& to) {
  return [=](const Vec3& lo, const Vec3& hi) {
    return lo.x() <= to.x() && from.x() <= hi.x() && lo.y() <= to.y() && from.y() <= hi.y();
  };
}

/// The point of the square that is nearest to the centre is within the radius.
InSquare disc(const Vec3& centre, double radius) {
  return [=](const Vec3& lo, const Vec3& hi) {
    const double x = std::clamp(centre.x(), lo.x(), hi.x()) - centre.x();
    const double y = std::clamp(centre.y(), lo.y(), hi.y()) - centre.y();
    return x * x + y * y <= radius * radius;
  };
}

/// A body with its image.
struct Seen {
  Body body;
  InSquare image;
};

Seen box(const Vec3& h, const Vec3& p) { return {body(Box{h}, p), rectangle(p - h, p + h)}; }

/// `meet`: the image of what both bodies have in common; null if they have no point in common.
PaperScene seen(const std::string& name, const Seen& A, const Seen& B, const Raster& raster, const InSquare& meet) {
  const InSquare none = [](const Vec3&, const Vec3&) { return false; };
  Pixels known;
  for (const Seen& one : {A, B}) {
    known.sampled.push_back(mask(raster, true, one.image));
    known.conservative.push_back(mask(raster, false, one.image));
  }
  known.meet_sampled = mask(raster, true, meet ? meet : none);
  known.meet_conservative = mask(raster, false, meet ? meet : none);
  for (int j = 0; j < raster.rows; ++j) {
    for (int i = 0; i < raster.columns; ++i) {
      const int from_i = i - raster.shift_x, from_j = j - raster.shift_y;
      const bool in_raster = from_i >= 0 && from_i < raster.columns && from_j >= 0 && from_j < raster.rows;
      const auto pixel = [](const Mask& mask, int column, int row) {
        return mask[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] == '1';
      };
      if (!in_raster || !pixel(known.sampled[0], i, j) || !pixel(known.sampled[1], from_i, from_j)) continue;
      if (known.overlap.count++ == 0) known.overlap.first = {i, j};
    }
  }
  PaperScene paper{scene(name, {A.body, B.body}), known};
  paper.scene.raster = raster;
  return paper;
}

}  // namespace

// No side of an image passes through a pixel's centre or along a square's side, so that rounding decides no pixel.
std::vector<PaperScene> pixel_on_paper() {
  const Vec3 a(2.5, 1.5, 0), b(3.5, 2.5, 0.5), h(1.2, 1.2, 1);
  const Seen A = box(h, a), B = box(h, b), above = box(h, b + Vec3(0, 0, 3));
  const InSquare both = rectangle(b - h, a + h);  // b is to the right of a, and farther up
  const Seen rod{body(Box{{0.3, 0.6, 2.2}}, {4, 2, 9}, quarter_about_x), rectangle({3.7, -0.2, 0}, {4.3, 4.2, 0})};
  const Seen ball{body(Sphere{1.3}, {2.1, 2.2, -9}), disc({2.1, 2.2, 0}, 1.3)};
  std::vector<PaperScene> all;
  for (const Raster& raster : {Raster{0, 0, 1, 7, 5}, Raster{-1.125, -2.125, 0.25, 40, 30}, Raster{2, 1, 0.5, 5, 6},
                               Raster{0, 0, 1, 7, 5, 1, 0}, Raster{0, 0, 1, 7, 5, 0, -1}}) {
    all.push_back(seen("boxes in each other", A, B, raster, both));
    all.push_back(seen("boxes above each other", A, above, raster, nullptr));
    all.push_back(seen("a ball, and a turned rod far above it", ball, rod, raster, nullptr));
  }
  return all;
}

}  // namespace touchstone::app
