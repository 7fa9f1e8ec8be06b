#include "fast/broad_phase/wrapped_grid.h"

#include <algorithm>
#include <limits>

#include "fast/mark.h"

namespace touchstone::fast {
namespace {

// No slot: of a body that is absent, or past a chain's end.
constexpr std::uint32_t none = 0xffffffff;

// After so many sorts the cells are laid out again: bodies may have gathered or grown. A choice: less often keeps cells
// that no longer fit; more often spends more time on the layout, which costs a few passes over all boxes.
constexpr int sorts_per_layout = 64;

// How many steps ahead in a list its targets are prefetched. A choice: far enough to cover the latency of main memory,
// and so near that what is fetched stays in the cache until it is used.
constexpr std::size_t look_ahead = 12;

void prefetch([[maybe_unused]] const void* what) {
#ifdef __GNUC__
  __builtin_prefetch(what);
#endif
}

/// max(0, a − b). If a float x ≥ 0 is ≤ a − b exactly, then x ≤ the result: rounding is monotone and keeps x.
float below(float a, float b) { return std::max(0.0F, a - b); }

/// Whether e overlaps fewer rows than there are places; a body much longer than a level's cells does not.
bool few_rows(const CellBox& e, const CellLevel& level) {
  const auto cells = [&](std::size_t axis) {
    return static_cast<double>((e.hi[axis] - e.lo[axis] + level.reach[axis]) * level.cells_per_unit + 2);
  };
  return cells(1) * cells(2) < level.places;
}

}  // namespace

void WrappedGrid::refresh() {
  slot_.resize(box_.size(), none);
  escapes_.resize(box_.size(), 0);
  list_escaped();
  if (must_rebuild()) {
    rebuild();
  } else {
    mark(Mark::grid_update);
    scan_near();
    scan_pairs();
    for (const BodyId id : escaped_) update_entry(id);
    for (const BodyId id : escaped_)
      if (present(id)) find_escaped(id);
  }
  for (const BodyId id : escaped_) escapes_[id] = 0;
}

/// Stops early once it is clear that the grid will be rebuilt.
void WrappedGrid::list_escaped() {
  escaped_.clear();
  for (std::size_t i = 0; i < moved_.size() && !many_escaped(); ++i) {
    const BodyId id = moved_[i];
    const std::uint32_t ahead = slot_[moved_[std::min(i + look_ahead, moved_.size() - 1)]];
    if (ahead != none) prefetch(&entries_[ahead]);
    const bool stays = present(id) && slot_[id] != none && cells_.holds(entries_[slot_[id]], box_[id]);
    if (stays) continue;
    escaped_.push_back(id);
    escapes_[id] = 1;
  }
}

bool WrappedGrid::must_rebuild() const {
  if (cells_.levels.empty() || many_escaped() || 16 * (entries_.size() - chains_.first_slot) > count()) return true;
  return !std::all_of(escaped_.begin(), escaped_.end(),
                      [this](BodyId id) { return !present(id) || cells_.fits(box_[id]); });
}

// ---- the two lists

inline void WrappedGrid::prefetch_boxes(std::size_t i) const {
  const BodyPair ahead = near_[std::min(i + look_ahead, near_.size() - 1)];
  prefetch(&box_[ahead.a]);
  prefetch(&box_[ahead.b]);
}

/// Drops the pairs of bodies that escaped: these are searched again.
void WrappedGrid::scan_near() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < near_.size(); ++i) {
    prefetch_boxes(i);
    const BodyPair pair = near_[i];
    if (escapes_[pair.a] != 0 || escapes_[pair.b] != 0) continue;
    if ((moved(pair.a) || moved(pair.b)) && overlap(box_[pair.a], box_[pair.b]))
      begin(pair.a, pair.b);
    else
      near_[kept++] = pair;
  }
  near_.resize(kept);
}

void WrappedGrid::scan_pairs() {
  drop_ended();
  for (const BodyPair pair : ended_)
    if (escapes_[pair.a] == 0 && escapes_[pair.b] == 0) append(near_, pair);
}

// ---- all bodies

void WrappedGrid::rebuild() {
  mark(Mark::grid_rebuild);
  cells_.expect(pairs_.size(), count());
  for (const BodyPair pair : pairs_)
    if (!overlap(box_[pair.a], box_[pair.b])) append(ended_, pair);
  pairs_.clear();
  near_.clear();
  sort_into_cells();
  find_all();
  separate_overlapping();
}

void WrappedGrid::sort_into_cells() {
  list_present(ids_);
  std::fill(slot_.begin(), slot_.end(), none);
  const std::size_t in_chains = ids_.size() / 5 + 1;  // upper bound until the next sort
  entries_.reserve(ids_.size() + in_chains);
  entries_.resize(ids_.size());
  chains_.links.reserve(in_chains);
  chains_.links.clear();
  chains_.first_slot = ids_.size();
  if (ids_.empty()) return cells_.levels.clear();
  const bool still_fits = !cells_.levels.empty() && ++sorts_ < sorts_per_layout && 2 * ids_.size() > laid_out_for_ &&
                          ids_.size() < 2 * laid_out_for_ &&
                          std::all_of(ids_.begin(), ids_.end(), [this](BodyId id) { return cells_.fits(box_[id]); });
  if (!still_fits) {
    mark(Mark::grid_layout);
    cells_.lay_out(box_, ids_, start_);
    laid_out_for_ = ids_.size();
    sorts_ = 0;
  }
  start_.assign(cells_.places() + 1, 0);
  chains_.last.assign(cells_.places(), none);
  for (CellLevel& level : cells_.levels) level.reach = {};
  for (const BodyId id : ids_) {
    const CellBox e = cells_.fat(id, box_[id], was(id));
    CellLevel& level = cells_.level_of(e);
    level.widen(e);
    ++start_[level.place_of(e)];
  }
  std::uint32_t end = 0;
  for (std::uint32_t& start : start_) {
    end += start;
    start = end;
  }
  for (const BodyId id : ids_) {
    const CellBox e = cells_.fat(id, box_[id], was(id));
    slot_[id] = --start_[cells_.place_of(e)];
    entries_[slot_[id]] = e;
  }
}

void WrappedGrid::find_all() {
  const auto& levels = cells_.levels;
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const CellLevel& own = levels[l];
    const std::uint32_t last = start_[own.first_place + own.places];
    for (std::uint32_t i = start_[own.first_place]; i < last; ++i) {
      const CellBox& a = entries_[i];
      const auto visit = [&](const CellBox& b) {
        append(near_, {std::min(a.body(), b.body()), std::max(a.body(), b.body())});
      };
      // On its own level a body queries only those that begin after it along x; ties are broken by the order of
      // entries.
      for_each_near<false>(a, a.lo[0], own, [&](const CellBox& b) {
        if (b.lo[0] > a.lo[0] || (b.lo[0] == a.lo[0] && &b > &a)) visit(b);
      });
      for (std::size_t m = l + 1; m < levels.size(); ++m)
        for_each_near<false>(a, below(a.lo[0], levels[m].reach[0]), levels[m], visit);
    }
  }
}

/// In a pass of its own, so that the boxes can be prefetched.
void WrappedGrid::separate_overlapping() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < near_.size(); ++i) {
    prefetch_boxes(i);
    const BodyPair pair = near_[i];
    if (overlap(box_[pair.a], box_[pair.b])) {
      append(pairs_, pair);
      if (!overlap(was(pair.a), was(pair.b))) append(begun_, pair);
    } else {
      near_[kept++] = pair;
    }
  }
  near_.resize(kept);
}

template <bool with_chains, class Visit>
inline void WrappedGrid::for_each_near(const CellBox& e, float least_x, const CellLevel& level,
                                       const Visit& visit) const {
  const CellBox* entries = entries_.data();
  const std::uint32_t* start = start_.data();
  const float scale = level.cells_per_unit;
  const std::int32_t x0 = whole(least_x * scale);
  const std::int32_t x1 = std::min(whole(e.hi[0] * scale), x0 + level.mask[0]);
  const std::int32_t y0 = whole(below(e.lo[1], level.reach[1]) * scale);
  const std::int32_t y1 = whole(e.hi[1] * scale);
  const std::int32_t z0 = whole(below(e.lo[2], level.reach[2]) * scale);
  const std::int32_t z1 = whole(e.hi[2] * scale);
  const std::int32_t first_x = x0 & level.mask[0];
  const std::int32_t run = std::min(x1 - x0, level.mask[0] - first_x);  // cells before the row wraps, minus one
  const std::int32_t wrapped = x1 - x0 - run;                           // cells after that

  for (std::int32_t z = z0; z <= z1; ++z) {
    for (std::int32_t y = y0; y <= y1; ++y) {
      const std::uint32_t row = level.first_place + static_cast<std::uint32_t>(((y & level.mask[1]) << level.shift[0]) +
                                                                               ((z & level.mask[2]) << level.shift[1]));
      const auto test_entry = [&](const CellBox& b) {
        // Rows that wrap onto one another share their places; only the row of b's own cell counts.
        if (b.near(e) && whole(b.lo[1] * scale) == y && whole(b.lo[2] * scale) == z) visit(b);
      };
      const auto scan_run = [&](std::uint32_t from, std::uint32_t to) {
        for (const CellBox* b = entries + start[from]; b != entries + start[to]; ++b) test_entry(*b);
        if constexpr (with_chains) {
          for (std::uint32_t place = from; place < to; ++place)
            for (std::uint32_t b = chains_.last[place]; b != none; b = chains_.before(b)) test_entry(entries[b]);
        }
      };
      const std::uint32_t from = row + static_cast<std::uint32_t>(first_x);
      scan_run(from, from + static_cast<std::uint32_t>(run) + 1);
      if (wrapped > 0) scan_run(row, row + static_cast<std::uint32_t>(wrapped));
    }
  }
}

// ---- bodies that left their fat box

void WrappedGrid::update_entry(BodyId id) {
  if (!present(id)) return leave(id);
  const CellBox e = cells_.fat(id, box_[id], was(id));
  CellLevel& level = cells_.level_of(e);
  level.widen(e);
  const std::uint32_t place = level.place_of(e);
  if (slot_[id] != none && cells_.place_of(entries_[slot_[id]]) == place) {
    entries_[slot_[id]] = e;
    return;
  }
  leave(id);
  mark(Mark::grid_chain);
  slot_[id] = static_cast<std::uint32_t>(entries_.size());
  entries_.push_back(e);
  chains_.links.push_back(chains_.last[place]);
  chains_.last[place] = slot_[id];
}

/// Its entry stays until the next sort, but overlaps nothing.
void WrappedGrid::leave(BodyId id) {
  if (slot_[id] == none) return;
  if (slot_[id] >= chains_.first_slot) {
    mark(Mark::grid_unchain);
    std::uint32_t* link = &chains_.last[cells_.place_of(entries_[slot_[id]])];
    while (*link != slot_[id]) link = &chains_.before(*link);
    *link = chains_.before(slot_[id]);
  }
  constexpr float nowhere = std::numeric_limits<float>::infinity();
  entries_[slot_[id]].lo = {nowhere, nowhere, nowhere, 0};
  slot_[id] = none;
}

template <class Visit>
void WrappedGrid::for_each_in(const CellLevel& level, const Visit& visit) const {
  const std::uint32_t past = level.first_place + level.places;
  for (std::uint32_t i = start_[level.first_place]; i < start_[past]; ++i) visit(entries_[i]);
  for (std::uint32_t place = level.first_place; place < past; ++place)
    for (std::uint32_t b = chains_.last[place]; b != none; b = chains_.before(b)) visit(entries_[b]);
}

void WrappedGrid::find_escaped(BodyId a) {
  const CellBox e = entries_[slot_[a]];
  const auto visit = [&](const CellBox& b) {
    const BodyPair pair{std::min(a, b.body()), std::max(a, b.body())};
    const bool other_finds_it = b.body() == a || (escapes_[b.body()] != 0 && b.body() < a);
    if (other_finds_it) return;
    if (overlap(box_[pair.a], box_[pair.b]))
      offer(pair.a, pair.b);
    else
      append(near_, pair);
  };
  for (const CellLevel& level : cells_.levels) {
    if (few_rows(e, level)) {
      for_each_near<true>(e, below(e.lo[0], level.reach[0]), level, visit);
    } else {
      mark(Mark::grid_long_body);
      for_each_in(level, [&](const CellBox& b) {
        if (b.near(e)) visit(b);
      });
    }
  }
}

}  // namespace touchstone::fast
