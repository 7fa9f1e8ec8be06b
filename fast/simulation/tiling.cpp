#include "fast/simulation/tiling.h"

#include <algorithm>
#include <cmath>

namespace touchstone::fast::world {
namespace {

/// The floor, without a call of the C library. Far away all is in one row: right, only slower.
std::int64_t row(double per_metre, double x) {
  const double rows = std::clamp(x * per_metre, -0x1p60, 0x1p60);
  const auto towards_zero = static_cast<std::int64_t>(rows);
  return towards_zero - (rows < static_cast<double>(towards_zero) ? 1 : 0);
}

}  // namespace

Tiling::Tiling(double cell, std::size_t bodies) : filed_(bodies), level_(levels), found_(bodies + room) {
  while (side_ * side_ * side_ < 2 * static_cast<std::int64_t>(bodies)) side_ *= 2, ++shift_;
  for (int i = 0; i < levels; ++i) level_[static_cast<std::size_t>(i)].per_metre = std::ldexp(1 / cell, middle - i);
}

void Tiling::put(Cell& cell, BodyId id) {
  if (cell.count < room) {
    cell.bodies[cell.count++] = id;
  } else {
    filed_[id].after = cell.more;
    cell.more = id;
  }
}

/// What the last one leaves is filled from those beyond the room.
void Tiling::take(Cell& cell, BodyId id) {
  BodyId* const end = cell.bodies + cell.count;
  BodyId* const place = std::find(cell.bodies, end, id);
  if (place == end) {
    BodyId* link = &cell.more;
    while (*link != id) link = &filed_[*link].after;
    *link = filed_[id].after;
  } else if (cell.more != nobody) {
    *place = cell.more;
    cell.more = filed_[cell.more].after;
  } else {
    *place = cell.bodies[--cell.count];
  }
}

void Tiling::leave(Level& level, BodyId id) {
  const std::uint32_t at = filed_[id].at;
  level.all[at] = level.all.back();
  filed_[level.all[at]].at = at;
  level.all.pop_back();
}

void Tiling::enter(std::int32_t on, BodyId id) {
  Level& level = level_[static_cast<std::size_t>(on)];
  if (level.cells.empty()) {
    level.cells.resize(static_cast<std::size_t>(side_ * side_ * side_));
    used_.push_back(static_cast<std::size_t>(on));
  }
  filed_[id].level = on;
  filed_[id].at = static_cast<std::uint32_t>(level.all.size());
  level.all.push_back(id);
}

void Tiling::file(BodyId id, const Aabb& box) {
  const double extent = (box.hi - box.lo).maxCoeff() * (1 + 0x1p-50);
  const auto holds = [&](std::int32_t on) { return extent * level_[static_cast<std::size_t>(on)].per_metre <= 1; };
  Filed& filed = filed_[id];
  std::int32_t on = std::max(filed.level, 0);
  while (on > 0 && holds(on - 1)) --on;
  while (on + 1 < levels && !holds(on)) ++on;
  const double per_metre = level_[static_cast<std::size_t>(on)].per_metre;
  const std::uint32_t in = line(row(per_metre, box.lo.y()), row(per_metre, box.lo.z())) |
                           static_cast<std::uint32_t>(row(per_metre, box.lo.x()) & (side_ - 1));
  filed.box = box;
  if (filed.level == on && filed.cell == in) return;
  if (filed.level >= 0) take(level_[static_cast<std::size_t>(filed.level)].cells[filed.cell], id);
  if (filed.level != on) {
    if (filed.level >= 0) leave(level_[static_cast<std::size_t>(filed.level)], id);
    enter(on, id);
  }
  filed.cell = in;
  put(level_[static_cast<std::size_t>(on)].cells[in], id);
}

/// Appends to found_ whose lo may stand in [lo − cell, hi], where that of every box stands that meets this one;
/// rounding keeps that order. What is longer than the longest cells stands in a list.
std::size_t Tiling::look(const Level& level, const Aabb& box, std::size_t size) {
  const auto all_of_it = [&] {
    std::ranges::copy(level.all, found_.data() + size);
    return size + level.all.size();
  };
  if (level.all.size() <= few || &level == &level_.back()) return all_of_it();
  std::int64_t from[3], count[3];
  std::int64_t cells = 1;
  for (int i = 0; i < 3; ++i) {
    from[i] = row(level.per_metre, box.lo[i] - 1 / level.per_metre);
    count[i] = std::min(row(level.per_metre, box.hi[i]) - from[i] + 1, side_);
    cells *= count[i];
  }
  if (static_cast<std::int64_t>(level.all.size()) <= cells) return all_of_it();
  for (std::int64_t z = 0; z < count[2]; ++z)
    for (std::int64_t y = 0; y < count[1]; ++y) {
      const Cell* const on_line = level.cells.data() + line(from[1] + y, from[2] + z);
      for (std::int64_t x = 0; x < count[0]; ++x) {
        const Cell& cell = on_line[(from[0] + x) & (side_ - 1)];
        std::ranges::copy(cell.bodies, found_.data() + size);  // all of the room: no branch
        size += cell.count;
        for (BodyId id = cell.more; id != nobody; id = filed_[id].after) found_[size++] = id;
      }
    }
  return size;
}

/// All candidates first, their boxes asked for at once, then those that overlap: without branches, which nobody could
/// foresee.
std::span<const BodyId> Tiling::near(BodyId id) {
  std::size_t size = 0, kept = 0;
  const Aabb& a = filed_[id].box;
  for (const std::size_t used : used_) size = look(level_[used], a, size);
  for (std::size_t i = 0; i < size; ++i) __builtin_prefetch(&filed_[found_[i]]);
  for (std::size_t i = 0; i < size; ++i) {
    const BodyId other = found_[i];
    const Aabb& b = filed_[other].box;
    found_[kept] = other;
    const bool meets = (a.lo - b.hi).cwiseMax(b.lo - a.hi).maxCoeff() <= 0;
    kept += static_cast<std::size_t>(static_cast<int>(meets) & static_cast<int>(other != id));
  }
  return {found_.data(), kept};
}

}  // namespace touchstone::fast::world
