#include "fast/simulation/tiling.h"

#include <algorithm>
#include <cmath>

namespace touchstone::fast::world {

Tiling::Tiling(double cell, std::size_t bodies) : box_(bodies), place_(bodies), level_(levels) {
  while (side_ * side_ * side_ < 2 * static_cast<std::int64_t>(bodies)) side_ *= 2, ++shift_;
  for (int i = 0; i < levels; ++i) level_[static_cast<std::size_t>(i)].per_metre = std::ldexp(1 / cell, middle - i);
}

/// The floor, without a call of the C library. Far away all is in one row: right, only slower.
std::int64_t Tiling::row(const Level& level, double x) const {
  const double rows = std::clamp(x * level.per_metre, -0x1p60, 0x1p60);
  const auto towards_zero = static_cast<std::int64_t>(rows);
  return towards_zero - (rows < static_cast<double>(towards_zero) ? 1 : 0);
}

std::uint32_t Tiling::index(std::int64_t x, std::int64_t y, std::int64_t z) const {
  const std::int64_t mask = side_ - 1;
  return static_cast<std::uint32_t>((((z & mask) << shift_ | (y & mask)) << shift_) | (x & mask));
}

void Tiling::put(Cell& cell, BodyId id) {
  if (cell.count < room) {
    cell.bodies[cell.count++] = id;
  } else {
    place_[id].after = cell.more;
    cell.more = id;
  }
}

/// What the last one leaves is filled from those beyond the room.
void Tiling::take(Cell& cell, BodyId id) {
  std::uint32_t* link = &cell.more;
  for (std::uint32_t i = 0; i < cell.count; ++i) {
    if (cell.bodies[i] != id) continue;
    if (cell.more == nobody) {
      cell.bodies[i] = cell.bodies[--cell.count];
    } else {
      cell.bodies[i] = cell.more;
      cell.more = place_[cell.more].after;
    }
    return;
  }
  while (*link != id) link = &place_[*link].after;
  *link = place_[id].after;
}

void Tiling::file(BodyId id, const Aabb& box) {
  const double extent = (box.hi - box.lo).maxCoeff() * (1 + 0x1p-50);
  int on = 0;
  while (on + 1 < levels && extent * level_[static_cast<std::size_t>(on)].per_metre > 1) ++on;
  Level& level = level_[static_cast<std::size_t>(on)];
  const std::uint32_t in = index(row(level, box.lo.x()), row(level, box.lo.y()), row(level, box.lo.z()));
  box_[id] = box;
  Place& place = place_[id];
  if (place.level == on && place.cell == in) return;
  if (place.level >= 0) {
    Level& old = level_[static_cast<std::size_t>(place.level)];
    take(old.cells[place.cell], id);
    old.all[place.at] = old.all.back();
    place_[old.all[place.at]].at = place.at;
    old.all.pop_back();
  }
  if (level.cells.empty()) {
    level.cells.resize(static_cast<std::size_t>(side_ * side_ * side_));
    used_.push_back(static_cast<std::size_t>(on));
  }
  place = {on, in, static_cast<std::uint32_t>(level.all.size()), nobody};
  put(level.cells[in], id);
  level.all.push_back(id);
}

/// Appends to found_ whose lo may stand in [lo − cell, hi], where that of every box stands that meets this one;
/// rounding keeps that order. What is longer than the longest cells stands in a list.
std::size_t Tiling::look(const Level& level, const Aabb& box, std::size_t size) {
  std::int64_t from[3], count[3];
  std::int64_t cells = 1;
  for (int i = 0; i < 3; ++i) {
    from[i] = row(level, box.lo[i] - 1 / level.per_metre);
    count[i] = std::min(row(level, box.hi[i]) - from[i] + 1, side_);
    cells *= count[i];
  }
  if (level.all.size() <= few || &level == &level_.back() || static_cast<std::int64_t>(level.all.size()) <= cells) {
    if (size + level.all.size() > found_.size()) found_.resize(2 * size + level.all.size());
    std::ranges::copy(level.all, found_.data() + size);
    return size + level.all.size();
  }
  for (std::int64_t z = 0; z < count[2]; ++z)
    for (std::int64_t y = 0; y < count[1]; ++y)
      for (std::int64_t x = 0; x < count[0]; ++x) {
        const Cell& cell = level.cells[index(from[0] + x, from[1] + y, from[2] + z)];
        if (size + room > found_.size()) found_.resize(2 * size + 64);
        for (std::uint32_t i = 0; i < room; ++i) found_[size + i] = cell.bodies[i];  // all of the room: no branch
        size += cell.count;
        for (std::uint32_t id = cell.more; id != nobody; id = place_[id].after) {
          if (size == found_.size()) found_.resize(2 * size);
          found_[size++] = id;
        }
      }
  return size;
}

/// All candidates first, then those that overlap: without branches, which nobody could foresee.
std::span<const BodyId> Tiling::near(BodyId id) {
  std::size_t size = 0, kept = 0;
  for (const std::size_t used : used_) size = look(level_[used], box_[id], size);
  const Aabb& a = box_[id];
  for (std::size_t i = 0; i < size; ++i) {
    const BodyId other = found_[i];
    const Aabb& b = box_[other];
    found_[kept] = other;
    kept += static_cast<std::size_t>(static_cast<int>(other != id) & static_cast<int>(a.lo.x() <= b.hi.x()) &
                                     static_cast<int>(b.lo.x() <= a.hi.x()) & static_cast<int>(a.lo.y() <= b.hi.y()) &
                                     static_cast<int>(b.lo.y() <= a.hi.y()) & static_cast<int>(a.lo.z() <= b.hi.z()) &
                                     static_cast<int>(b.lo.z() <= a.hi.z()));
  }
  return {found_.data(), kept};
}

}  // namespace touchstone::fast::world
