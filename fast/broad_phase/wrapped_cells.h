// The cells of the wrapped grid: levels of cells, wrapped like a torus onto a small table.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "fast/broad_phase/strategy.h"

namespace touchstone::fast {

/// A box in units of level 0's cells, as floats. Four lanes are compared at once, so the fourth must always overlap: lo
/// holds 0, and hi holds the id, which is less than 2^24 and so exact as a float.
struct alignas(16) CellBox {
  std::array<float, 4> lo{};
  std::array<float, 4> hi{};

  BodyId body() const { return static_cast<BodyId>(hi[3]); }
  float extent() const { return std::max({hi[0] - lo[0], hi[1] - lo[1], hi[2] - lo[2]}); }
  bool near(const CellBox& e) const;
};

/// One level's range of places in the table.
struct CellLevel {
  float cells_per_unit = 1;  ///< 4^-level; a unit is a cell of level 0
  std::array<float, 3> reach{};
  std::array<std::int32_t, 3> mask{};  ///< cells along each axis before it wraps, minus one
  std::array<int, 2> shift{};          ///< of y and z in a place's index
  std::uint32_t first_place = 0;
  std::uint32_t places = 0;

  std::uint32_t place_of(const CellBox& e) const;

  /// Makes reach at least e's extents. The factor covers the rounding of the difference and its own (2 · 2^-24).
  void widen(const CellBox& e);
};

/// Coordinates are x ↦ g(x) = (x − origin)/cell, rounded to float when stored. Both maps are monotone, so closed boxes
/// that overlap still overlap when either is mapped by one or both: no pair is missed.
class WrappedCells {
 public:
  std::vector<CellLevel> levels;

  /// Chooses cell size, levels and places for these bodies. `scratch` is overwritten; the caller lends it to avoid an
  /// allocation.
  void lay_out(const std::vector<Aabb>& boxes, const std::vector<BodyId>& ids, std::vector<std::uint32_t>& scratch);

  /// Bounds the margins from here on, so that near pairs number about 0.4 per body and 0.6 per pair: at uniform
  /// density, boxes that are k times as long overlap k³ times as many.
  void expect(std::size_t pairs, std::size_t bodies);

  /// Whether the box lies in the domain for which g was chosen.
  bool fits(const Aabb& box) const;

  /// g(box) with a margin for some frames like the one that led from `was` to `box`.
  CellBox fat(BodyId id, const Aabb& box, const Aabb& was) const;

  /// Whether g(box) lies in `fat`.
  bool holds(const CellBox& fat, const Aabb& box) const;

  CellLevel& level_of(const CellBox& e) { return levels[level_number(e)]; }
  std::uint32_t place_of(const CellBox& e) const { return levels[level_number(e)].place_of(e); }
  std::uint32_t places() const { return levels.back().first_place + levels.back().places; }

 private:
  CellBox exact(BodyId id, const Aabb& box) const;
  float margin(const CellBox& e, const Aabb& box, const Aabb& was) const;
  std::size_t level_number(const CellBox& e) const;
  double first_cell(const std::vector<Aabb>& boxes, const std::vector<BodyId>& ids);
  double crowding(const std::vector<Aabb>& boxes, const std::vector<BodyId>& ids,
                  std::vector<std::uint32_t>& scratch) const;
  void share_places(CellLevel& level, std::size_t bodies) const;

  Aabb domain_;
  double units_per_metre_ = 0;
  double least_cell_ = 0;
  double greatest_margin_ = 0;  ///< as a fraction of the body's extent
};

/// The floor of x ≥ 0.
inline std::int32_t whole(float x) { return static_cast<std::int32_t>(x); }

// ---- inline: executed for every body. The two ways to compare give the same results.

#ifdef __SSE2__
inline bool CellBox::near(const CellBox& e) const {
  const __m128 above = _mm_cmpgt_ps(_mm_load_ps(lo.data()), _mm_load_ps(e.hi.data()));
  const __m128 below = _mm_cmpgt_ps(_mm_load_ps(e.lo.data()), _mm_load_ps(hi.data()));
  return _mm_movemask_ps(_mm_or_ps(above, below)) == 0;
}
#else
inline bool CellBox::near(const CellBox& e) const {
  return lo[0] <= e.hi[0] && e.lo[0] <= hi[0] && lo[1] <= e.hi[1] && e.lo[1] <= hi[1] && lo[2] <= e.hi[2] &&
         e.lo[2] <= hi[2];
}
#endif

inline std::uint32_t CellLevel::place_of(const CellBox& e) const {
  const std::int32_t x = whole(e.lo[0] * cells_per_unit) & mask[0];
  const std::int32_t y = whole(e.lo[1] * cells_per_unit) & mask[1];
  const std::int32_t z = whole(e.lo[2] * cells_per_unit) & mask[2];
  return first_place + static_cast<std::uint32_t>(x + (y << shift[0]) + (z << shift[1]));
}

inline void CellLevel::widen(const CellBox& e) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    reach[axis] = std::max(reach[axis], (e.hi[axis] - e.lo[axis]) * (1 + 0x1p-22F));
}

inline bool WrappedCells::fits(const Aabb& box) const {
  return (domain_.lo.array() <= box.lo.array()).all() && (box.hi.array() <= domain_.hi.array()).all();
}

inline CellBox WrappedCells::exact(BodyId id, const Aabb& box) const {
  CellBox e;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t k = static_cast<std::size_t>(axis);
    e.lo[k] = static_cast<float>((box.lo[axis] - domain_.lo[axis]) * units_per_metre_);
    e.hi[k] = static_cast<float>((box.hi[axis] - domain_.lo[axis]) * units_per_metre_);
  }
  e.hi[3] = static_cast<float>(id);
  return e;
}

inline std::size_t WrappedCells::level_number(const CellBox& e) const {
  const float extent = e.extent();
  std::size_t l = 0;
  while (l + 1 < levels.size() && extent * levels[l].cells_per_unit > 1) ++l;
  return l;
}

inline CellBox WrappedCells::fat(BodyId id, const Aabb& box, const Aabb& was) const {
  CellBox e = exact(id, box);
  const float by = margin(e, box, was);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    e.lo[axis] = std::max(0.0F, e.lo[axis] - by);  // never negative, since whole() rounds towards 0
    e.hi[axis] += by;
  }
  return e;
}

inline bool WrappedCells::holds(const CellBox& fat, const Aabb& box) const {
  bool held = true;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t k = static_cast<std::size_t>(axis);
    held &= static_cast<double>(fat.lo[k]) <= (box.lo[axis] - domain_.lo[axis]) * units_per_metre_;
    held &= (box.hi[axis] - domain_.lo[axis]) * units_per_metre_ <= static_cast<double>(fat.hi[k]);
  }
  return held;
}

/// A body that keeps its speed leaves its margin after `frames` frames. Margins are bounded, in expect() and here (an
/// eighth of a cell is 0.28 of the distance between bodies), since they cost pairs that are near without overlapping.
/// If the bound is left within two frames, a margin does not pay. Eight frames are a choice: more frames find more
/// pairs that are near without overlapping, fewer search again more often.
inline float WrappedCells::margin(const CellBox& e, const Aabb& box, const Aabb& was) const {
  constexpr double frames = 8;
  const double extent = static_cast<double>(e.extent());
  const double bound = std::min(0.125 * std::max(1.0, extent), greatest_margin_ * extent);
  const double step =
      units_per_metre_ * std::max((box.lo - was.lo).cwiseAbs().maxCoeff(), (box.hi - was.hi).cwiseAbs().maxCoeff());
  return 2 * step <= bound ? static_cast<float>(std::min(frames * step, bound)) : 0;
}

}  // namespace touchstone::fast
