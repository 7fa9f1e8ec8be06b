#include "fast/broad_phase/wrapped_grid.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace touchstone::fast {
namespace {

constexpr std::uint32_t none = 0xffffffff;

// A body's place when it has none is `none`; its slot is `none` when it stands in a chain.
constexpr float infinity = std::numeric_limits<float>::infinity();

constexpr std::size_t most_levels = 12;
// Measured best on the coherent and the ratio world at 1,000 to 100,000 bodies (1.6 to 3 tried): wider cells mean more
// box tests, narrower ones more rows, and a row costs more than a test.
constexpr double cells_per_distance = 2.25;

// The mean number of bodies in a body's cell. Evenly spread bodies have 1 + cells_per_distance³ ≈ 12.4; some are borne.
constexpr double crowd_allowed = 32;
constexpr double greatest_units = 0x1p20;

// After so many the cell size is chosen anew: bodies may have gathered or grown.
constexpr int rebuilds_per_layout = 64;

/// The floor of x ≥ 0.
std::int32_t whole(float x) { return static_cast<std::int32_t>(x); }

/// max(0, a − b). If a float x ≥ 0 is ≤ a − b exactly, then x ≤ the result: rounding is monotone and keeps x.
float below(float a, float b) { return std::max(0.0F, a - b); }

}  // namespace

// ---- whether two entries overlap: the two ways give the same answers

#ifdef __SSE2__
inline bool WrappedGrid::Entry::near(const Entry& e) const {
  const __m128 above = _mm_cmpgt_ps(_mm_load_ps(lo.data()), _mm_load_ps(e.hi.data()));
  const __m128 below = _mm_cmpgt_ps(_mm_load_ps(e.lo.data()), _mm_load_ps(hi.data()));
  return _mm_movemask_ps(_mm_or_ps(above, below)) == 0;
}
#else
inline bool WrappedGrid::Entry::near(const Entry& e) const {
  return lo[0] <= e.hi[0] && e.lo[0] <= hi[0] && lo[1] <= e.hi[1] && e.lo[1] <= hi[1] && lo[2] <= e.hi[2] &&
         e.lo[2] <= hi[2];
}
#endif

// ---- where a body stands (inline: on every body's path)

inline WrappedGrid::Entry WrappedGrid::entry_of(BodyId id) const {
  Entry e;
  const Aabb& box = box_[id];
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t k = static_cast<std::size_t>(axis);
    e.lo[k] = static_cast<float>((box.lo[axis] - domain_.lo[axis]) * units_per_metre_);
    e.hi[k] = static_cast<float>((box.hi[axis] - domain_.lo[axis]) * units_per_metre_);
  }
  e.hi[3] = static_cast<float>(id);
  return e;
}

inline std::size_t WrappedGrid::level_of(const Entry& e) const {
  const float extent = std::max({e.hi[0] - e.lo[0], e.hi[1] - e.lo[1], e.hi[2] - e.lo[2]});
  std::size_t l = 0;
  while (l + 1 < levels_.size() && extent * levels_[l].cells_per_unit > 1) ++l;
  return l;
}

inline std::uint32_t WrappedGrid::place_of(const Entry& e, const Level& level) const {
  const std::int32_t x = whole(e.lo[0] * level.cells_per_unit) & level.mask[0];
  const std::int32_t y = whole(e.lo[1] * level.cells_per_unit) & level.mask[1];
  const std::int32_t z = whole(e.lo[2] * level.cells_per_unit) & level.mask[2];
  return level.first_place + static_cast<std::uint32_t>(x + (y << level.shift[0]) + (z << level.shift[1]));
}

/// The factor makes up for the rounding of the difference and its own (2 · 2^-24), so reach is no less than hi − lo
/// exactly.
inline void WrappedGrid::widen(Level& level, const Entry& e) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    level.reach[axis] = std::max(level.reach[axis], (e.hi[axis] - e.lo[axis]) * (1 + 0x1p-22F));
}

inline bool WrappedGrid::fits(const Aabb& box) const {
  return (domain_.lo.array() <= box.lo.array()).all() && (box.hi.array() <= domain_.hi.array()).all();
}

// ---- a frame

void WrappedGrid::refresh() {
  drop_ended();
  slot_.resize(box_.size(), none);
  place_.resize(box_.size(), none);
  next_.resize(box_.size(), none);
  if (must_rebuild()) {
    rebuild();
    find_all();
    return;
  }
  for (const BodyId id : moved_) treat_moved(id);
  for (const BodyId id : moved_)
    if (present(id)) find_moved(id);
}

bool WrappedGrid::must_rebuild() const {
  if (levels_.empty() || 4 * moved_.size() > count() || 16 * chained_ > count()) return true;
  return !std::all_of(moved_.begin(), moved_.end(), [this](BodyId id) { return !present(id) || fits(box_[id]); });
}

// ---- how space is divided

void WrappedGrid::configure() {
  domain_ = box_[ids_.front()];
  Vec3 mean = Vec3::Zero();
  const double n = static_cast<double>(ids_.size());
  for (const BodyId id : ids_) {
    domain_.lo = domain_.lo.cwiseMin(box_[id].lo);
    domain_.hi = domain_.hi.cwiseMax(box_[id].hi);
    mean += (box_[id].hi - box_[id].lo) / n;
  }
  const Vec3 room = domain_.hi - domain_.lo;
  const double widest = std::max(room.maxCoeff(), 0x1p-900);
  // By how far bodies are apart; a flat world is as thick as a body.
  const Vec3 share = (room / widest).cwiseMax(mean / widest).cwiseMax(0x1p-20);
  double cell = cells_per_distance * widest * std::cbrt(share.prod() / n);
  const double least_cell = std::max(mean.maxCoeff(), widest / greatest_units * 2);
  cell = std::max(cell, least_cell / 2);
  // Room for what moves about, so that f need not change every frame.
  domain_.lo -= Vec3::Constant(widest / 16);
  domain_.hi += Vec3::Constant(widest / 16);
  units_per_metre_ = 1 / cell;
  while (cell / 2 > least_cell && crowding() > crowd_allowed) {
    cell /= 2;
    units_per_metre_ = 1 / cell;
  }
  configured_for_ = ids_.size();
  rebuilds_ = 0;
  lay_out_levels();
}

/// The mean number of bodies in a body's cell, when the cells are hashed onto about n places.
double WrappedGrid::crowding() {
  start_.assign(std::bit_ceil(ids_.size()), 0);
  for (const BodyId id : ids_) {
    const Entry e = entry_of(id);
    const std::uint64_t cell = (std::uint64_t{static_cast<std::uint32_t>(whole(e.lo[0]))} << 42U) ^
                               (std::uint64_t{static_cast<std::uint32_t>(whole(e.lo[1]))} << 21U) ^
                               static_cast<std::uint32_t>(whole(e.lo[2]));
    ++start_[((cell * 0x9e3779b97f4a7c15U) >> 32U) & (start_.size() - 1)];
  }
  double squares = 0;
  for (const std::uint32_t here : start_) squares += static_cast<double>(here) * here;
  return squares / static_cast<double>(ids_.size());
}

void WrappedGrid::lay_out_levels() {
  levels_.assign(1, {});
  std::array<std::size_t, most_levels> bodies{};
  for (const BodyId id : ids_) {
    const Entry e = entry_of(id);
    const float extent = std::max({e.hi[0] - e.lo[0], e.hi[1] - e.lo[1], e.hi[2] - e.lo[2]});
    while (levels_.size() < most_levels && extent * levels_.back().cells_per_unit > 1) {
      levels_.push_back({});
      levels_.back().cells_per_unit = levels_[levels_.size() - 2].cells_per_unit / 4;
    }
    ++bodies[level_of(e)];
  }
  std::uint32_t first = 0;
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    Level& level = levels_[l];
    level.first_place = first;
    // The places are handed out to the axes a doubling at a time, to the one with most cells left to tell apart.
    int bits = static_cast<int>(std::bit_width((bodies[l] / 2) | 1U));
    std::array<int, 3> log{};
    std::array<double, 3> cells{};
    for (int axis = 0; axis < 3; ++axis)
      cells[static_cast<std::size_t>(axis)] =
          (domain_.hi[axis] - domain_.lo[axis]) * units_per_metre_ * static_cast<double>(level.cells_per_unit);
    for (; bits > 0; --bits) {
      const std::size_t axis = static_cast<std::size_t>(std::max_element(cells.begin(), cells.end()) - cells.begin());
      cells[axis] /= 2;
      ++log[axis];
    }
    for (std::size_t axis = 0; axis < 3; ++axis) level.mask[axis] = (1 << log[axis]) - 1;
    level.shift = {log[0], log[0] + log[1]};
    level.places = 1U << static_cast<unsigned>(log[0] + log[1] + log[2]);
    first += level.places;
  }
  start_.assign(first + 1, 0);
  chain_.assign(first, none);
}

// ---- all bodies

void WrappedGrid::rebuild() {
  list_present(ids_);
  std::fill(slot_.begin(), slot_.end(), none);
  std::fill(place_.begin(), place_.end(), none);
  entries_.resize(ids_.size());
  chained_ = 0;
  if (ids_.empty()) return levels_.clear();
  const bool still_fits = !levels_.empty() && ++rebuilds_ < rebuilds_per_layout && 2 * ids_.size() > configured_for_ &&
                          ids_.size() < 2 * configured_for_ &&
                          std::all_of(ids_.begin(), ids_.end(), [this](BodyId id) { return fits(box_[id]); });
  if (!still_fits) configure();

  std::fill(start_.begin(), start_.end(), 0);
  std::fill(chain_.begin(), chain_.end(), none);
  for (Level& level : levels_) level.reach = {};
  for (const BodyId id : ids_) {
    const Entry e = entry_of(id);
    Level& level = levels_[level_of(e)];
    widen(level, e);
    place_[id] = place_of(e, level);
    ++start_[place_[id]];
  }
  std::uint32_t end = 0;
  for (std::uint32_t& start : start_) {
    end += start;
    start = end;
  }
  for (const BodyId id : ids_) {
    slot_[id] = --start_[place_[id]];
    entries_[slot_[id]] = entry_of(id);
  }
}

void WrappedGrid::find_all() {
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    const Level& own = levels_[l];
    const std::uint32_t last = start_[own.first_place + own.places];
    for (std::uint32_t i = start_[own.first_place]; i < last; ++i) {
      const Entry& a = entries_[i];
      const auto meet = [&](const Entry& b) {
        if (overlap(box_[a.body()], box_[b.body()])) offer(a.body(), b.body());
      };
      // On its own level a body asks only for those that begin after it along x; ties go by the order of entries.
      for_each_near<false>(a, a.lo[0], own, [&](const Entry& b) {
        if (b.lo[0] > a.lo[0] || (b.lo[0] == a.lo[0] && &b > &a)) meet(b);
      });
      for (std::size_t m = l + 1; m < levels_.size(); ++m)
        for_each_near<false>(a, below(a.lo[0], levels_[m].reach[0]), levels_[m], meet);
    }
  }
}

template <bool with_chains, class Meet>
inline void WrappedGrid::for_each_near(const Entry& e, float least_x, const Level& level, const Meet& meet) const {
  const Entry* entries = entries_.data();
  const std::uint32_t* start = start_.data();
  const float scale = level.cells_per_unit;
  const std::int32_t x0 = whole(least_x * scale);
  const std::int32_t x1 = std::min(whole(e.hi[0] * scale), x0 + level.mask[0]);
  const std::int32_t y0 = whole(below(e.lo[1], level.reach[1]) * scale);
  const std::int32_t y1 = whole(e.hi[1] * scale);
  const std::int32_t z0 = whole(below(e.lo[2], level.reach[2]) * scale);
  const std::int32_t z1 = whole(e.hi[2] * scale);
  const std::int32_t first_x = x0 & level.mask[0];
  const std::int32_t run = std::min(x1 - x0, level.mask[0] - first_x);  // cells before the row wraps, less one
  const std::int32_t wrapped = x1 - x0 - run;                           // cells after that

  for (std::int32_t z = z0; z <= z1; ++z) {
    for (std::int32_t y = y0; y <= y1; ++y) {
      const std::uint32_t row = level.first_place + static_cast<std::uint32_t>(((y & level.mask[1]) << level.shift[0]) +
                                                                               ((z & level.mask[2]) << level.shift[1]));
      const auto look_at = [&](const Entry& b) {
        // Rows that wrap onto one another share their places; only the row that b stands in counts.
        if (b.near(e) && whole(b.lo[1] * scale) == y && whole(b.lo[2] * scale) == z) meet(b);
      };
      const auto look_through = [&](std::uint32_t from, std::uint32_t to) {
        for (const Entry* b = entries + start[from]; b != entries + start[to]; ++b) look_at(*b);
        if constexpr (with_chains) {
          for (std::uint32_t place = from; place < to; ++place)
            for (BodyId b = chain_[place]; b != none; b = next_[b]) look_at(entry_of(b));
        }
      };
      const std::uint32_t from = row + static_cast<std::uint32_t>(first_x);
      look_through(from, from + static_cast<std::uint32_t>(run) + 1);
      if (wrapped > 0) look_through(row, row + static_cast<std::uint32_t>(wrapped));
    }
  }
}

// ---- moved bodies only

void WrappedGrid::treat_moved(BodyId id) {
  if (!present(id)) return leave(id);
  const Entry e = entry_of(id);
  Level& level = levels_[level_of(e)];
  widen(level, e);
  const std::uint32_t place = place_of(e, level);
  if (place_[id] != place) {
    leave(id);
    place_[id] = place;
    next_[id] = chain_[place];
    chain_[place] = id;
    ++chained_;
  } else if (slot_[id] != none) {
    entries_[slot_[id]] = e;
  }
}

/// Its entry stays, but overlaps nothing.
void WrappedGrid::leave(BodyId id) {
  if (slot_[id] != none) {
    entries_[slot_[id]].lo = {infinity, infinity, infinity, 0};
    slot_[id] = none;
  } else if (place_[id] != none) {
    BodyId* link = &chain_[place_[id]];
    while (*link != id) link = &next_[*link];
    *link = next_[id];
    --chained_;
  }
  place_[id] = none;
}

/// A body much longer than a level's cells would ask for more rows than there are places.
double WrappedGrid::rows(const Entry& e, const Level& level) const {
  const auto cells = [&](std::size_t axis) {
    return (e.hi[axis] - e.lo[axis] + level.reach[axis]) * level.cells_per_unit + 2;
  };
  return static_cast<double>(cells(1)) * static_cast<double>(cells(2));
}

template <class Meet>
void WrappedGrid::for_each_in(const Level& level, const Meet& meet) const {
  const std::uint32_t past = level.first_place + level.places;
  for (std::uint32_t i = start_[level.first_place]; i < start_[past]; ++i)
    if (slot_[entries_[i].body()] == i) meet(entries_[i]);
  for (std::uint32_t place = level.first_place; place < past; ++place)
    for (BodyId b = chain_[place]; b != none; b = next_[b]) meet(entry_of(b));
}

void WrappedGrid::find_moved(BodyId a) {
  const Entry e = entry_of(a);
  const auto meet = [&](const Entry& b) {
    const bool other_finds_it = b.body() == a || (moved(b.body()) && b.body() < a);
    if (!other_finds_it && overlap(box_[a], box_[b.body()])) offer(a, b.body());
  };
  for (const Level& level : levels_) {
    if (rows(e, level) < level.places)
      for_each_near<true>(e, below(e.lo[0], level.reach[0]), level, meet);
    else
      for_each_in(level, meet);
  }
}

}  // namespace touchstone::fast
