#include "fast/pixel.h"

#include <memory>

#include "fast/mark.h"
#include "fast/pixel/bit_mask.h"
#include "fast/pixel/depth_map.h"
#include "fast/pixel/exact_column.h"
#include "model/input_error.h"

namespace touchstone::fast {
namespace {

using namespace pixel;

exact::Dyadic exact_centre(double start, double pixel, int i) {
  return exact::Dyadic(start) + exact::Dyadic(i + 0.5) * exact::Dyadic(pixel);
}

/// The projection of a convex part onto the raster.
class Seen {
 public:
  Seen(Part part, const Raster& raster) : part_(std::move(part)), raster_(raster) {
    mark(Mark::pixel_seen);
    const Grid grid(raster);
    const PosedPart placed = posed(part_, grid);
    static const std::vector<std::vector<int>> none;
    const auto* polytope = std::get_if<Polytope>(&part_.shape);
    centres = above_centres(placed, polytope ? polytope->faces : none, grid);
    squares = above_squares(placed, polytope ? polytope->faces : none, grid);
  }

  DepthMap centres;
  DepthMap squares;

  std::optional<Column> exactly_above(int i, int j) const {
    if (!exact_) exact_ = std::make_unique<ExactPart>(part_);
    return exact_->above(exact_centre(raster_.x, raster_.pixel, i), exact_centre(raster_.y, raster_.pixel, j));
  }

 private:
  Part part_;
  const Raster& raster_;
  mutable std::unique_ptr<ExactPart> exact_;
};

template <class F>
void for_each(const DepthMap& map, F&& f) {
  for (int j = map.first_row; j < map.end_row; ++j) {
    for (int i = map.first_column; i < map.end_column; ++i) f(i, j, map.at(i, j));
  }
}

std::vector<Seen> seen(const Body& body, const Raster& raster) {
  std::vector<Seen> parts;
  for (Part& part : parts_of(body)) parts.emplace_back(std::move(part), raster);
  return parts;
}

BitMask sampled(const std::vector<Seen>& parts, const Raster& raster) {
  BitMask mask(raster.columns, raster.rows);
  for (const Seen& part : parts) {
    for_each(part.centres, [&](int i, int j, const Depths& known) {
      if (known.certain() || (known.maybe() && part.exactly_above(i, j))) mask.set(i, j);
    });
  }
  return mask;
}

BitMask conservative(const std::vector<Seen>& parts, const Raster& raster) {
  BitMask mask(raster.columns, raster.rows);
  for (const Seen& part : parts) {
    for_each(part.squares, [&](int i, int j, const Depths& known) {
      if (known.maybe()) mask.set(i, j);
    });
  }
  return mask;
}

bool may_meet(const Depths& a, const Depths& b) { return a.lo <= b.hi && b.lo <= a.hi && a.maybe() && b.maybe(); }

bool certainly_meet(const Depths& a, const Depths& b) {
  return a.certain() && b.certain() && a.inner_lo <= b.inner_hi && b.inner_lo <= a.inner_hi;
}

bool meet_above_centre(const Seen& A, const Seen& B, int i, int j) {
  if (certainly_meet(A.centres.at(i, j), B.centres.at(i, j))) return true;
  if (!may_meet(A.centres.at(i, j), B.centres.at(i, j))) return false;
  const std::optional<Column> a = A.exactly_above(i, j);
  const std::optional<Column> b = a ? B.exactly_above(i, j) : std::nullopt;
  return b && meet(*a, *b);
}

void add_meetings(const Seen& A, const Seen& B, BitMask& sampled, BitMask& conservative) {
  for_each(A.centres, [&](int i, int j, const Depths&) {
    if (B.centres.covers(i, j) && meet_above_centre(A, B, i, j)) sampled.set(i, j);
  });
  for_each(A.squares, [&](int i, int j, const Depths& of_A) {
    if (B.squares.covers(i, j) && may_meet(of_A, B.squares.at(i, j))) conservative.set(i, j);
  });
}

}  // namespace

Pixels pixels(const Scene& scene) {
  if (!scene.raster) throw InputError("raster", "missing; expected one to ask about pixels");
  const Raster& raster = *scene.raster;
  Pixels answer;
  std::vector<std::vector<Seen>> bodies;
  std::vector<BitMask> masks;
  for (const Body& body : scene.bodies) {
    bodies.push_back(seen(body, raster));
    masks.push_back(sampled(bodies.back(), raster));
    answer.sampled.push_back(masks.back().text());
    answer.conservative.push_back(conservative(bodies.back(), raster).text());
  }
  BitMask meet_sampled(raster.columns, raster.rows);
  BitMask meet_conservative(raster.columns, raster.rows);
  if (bodies.size() >= 2) {
    answer.overlap = overlap(masks[0], masks[1], raster.shift_x, raster.shift_y);
    for (const Seen& a : bodies[0]) {
      for (const Seen& b : bodies[1]) add_meetings(a, b, meet_sampled, meet_conservative);
    }
  }
  answer.meet_sampled = meet_sampled.text();
  answer.meet_conservative = meet_conservative.text();
  return answer;
}

}  // namespace touchstone::fast
