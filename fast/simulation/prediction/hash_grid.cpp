#include "fast/simulation/prediction/hash_grid.h"

#include <algorithm>
#include <cmath>

#include "fast/mark.h"

namespace touchstone::fast::simulation {
namespace {

/// The floor of x · per_metre, without a call of the C library. Clamping puts everything far away into one row, which
/// is correct but slower.
std::int64_t row(double per_metre, double x) {
  const double rows = std::clamp(x * per_metre, -0x1p60, 0x1p60);
  const auto towards_zero = static_cast<std::int64_t>(rows);
  return towards_zero - (rows < static_cast<double>(towards_zero) ? 1 : 0);
}

}  // namespace

HashGrid::HashGrid(double cell, std::size_t bodies) : proxies_(bodies), level_(levels), found_(bodies + room) {
  while (side_ * side_ * side_ < 2 * static_cast<std::int64_t>(bodies)) side_ *= 2, ++shift_;
  for (int i = 0; i < levels; ++i) level_[static_cast<std::size_t>(i)].per_metre = std::ldexp(1 / cell, middle - i);
}

void HashGrid::put(Cell& cell, BodyId id) {
  if (cell.count < room) {
    cell.bodies[cell.count++] = id;
  } else {
    proxies_[id].after = cell.more;
    cell.more = id;
  }
}

/// The gap is filled from the overflow chain, or else by the last entry of the cell.
void HashGrid::take(Cell& cell, BodyId id) {
  BodyId* const end = cell.bodies + cell.count;
  BodyId* const place = std::find(cell.bodies, end, id);
  if (place == end) {
    BodyId* link = &cell.more;
    while (*link != id) link = &proxies_[*link].after;
    *link = proxies_[id].after;
  } else if (cell.more != no_body) {
    *place = cell.more;
    cell.more = proxies_[cell.more].after;
  } else {
    *place = cell.bodies[--cell.count];
  }
}

void HashGrid::leave(Level& level, BodyId id) {
  const std::uint32_t at = proxies_[id].at;
  level.all[at] = level.all.back();
  proxies_[level.all[at]].at = at;
  level.all.pop_back();
}

void HashGrid::enter(std::int32_t on, BodyId id) {
  Level& level = level_[static_cast<std::size_t>(on)];
  if (level.cells.empty()) {
    level.cells.resize(static_cast<std::size_t>(side_ * side_ * side_));
    used_.push_back(static_cast<std::size_t>(on));
  }
  proxies_[id].level = on;
  proxies_[id].at = static_cast<std::uint32_t>(level.all.size());
  level.all.push_back(id);
}

void HashGrid::update_proxy(BodyId id, const Aabb& box) {
  const double extent = (box.hi - box.lo).maxCoeff() * (1 + 0x1p-50);
  const auto fits = [&](std::int32_t on) { return extent * level_[static_cast<std::size_t>(on)].per_metre <= 1; };
  Proxy& proxy = proxies_[id];
  std::int32_t on = std::max(proxy.level, 0);
  while (on > 0 && fits(on - 1)) --on;
  while (on + 1 < levels && !fits(on)) ++on;
  const double per_metre = level_[static_cast<std::size_t>(on)].per_metre;
  const std::uint32_t in = line(row(per_metre, box.lo.y()), row(per_metre, box.lo.z())) |
                           static_cast<std::uint32_t>(row(per_metre, box.lo.x()) & (side_ - 1));
  proxy.box = box;
  if (proxy.level == on && proxy.cell == in) return;
  if (proxy.level >= 0) take(level_[static_cast<std::size_t>(proxy.level)].cells[proxy.cell], id);
  if (proxy.level != on) {
    if (proxy.level >= 0) leave(level_[static_cast<std::size_t>(proxy.level)], id);
    enter(on, id);
  }
  proxy.cell = in;
  put(level_[static_cast<std::size_t>(on)].cells[in], id);
}

/// Appends to found_ the bodies whose `lo` may be in [lo − cell, hi], which contains the `lo` of every overlapping box,
/// since rounding is monotone. The last level, whose boxes may be longer than its cells, is scanned as a list. Returns
/// the new size.
std::size_t HashGrid::collect(const Level& level, const Aabb& box, std::size_t size) {
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
        std::ranges::copy(cell.bodies, found_.data() + size);  // copies all slots: no branch
        size += cell.count;
        for (BodyId id = cell.more; id != no_body; id = proxies_[id].after) found_[size++] = id;
      }
    }
  return size;
}

/// Collects all candidates, prefetches their boxes together, then keeps those that overlap. The filter has no branches,
/// since their outcome could not be predicted.
std::span<const BodyId> HashGrid::neighbours(BodyId id) {
  std::size_t size = 0, kept = 0;
  const Aabb& a = proxies_[id].box;
  for (const std::size_t used : used_) size = collect(level_[used], a, size);
  mark(Mark::proxy_query);
  mark(Mark::proxy_candidate, size);
  for (std::size_t i = 0; i < size; ++i) __builtin_prefetch(&proxies_[found_[i]]);
  for (std::size_t i = 0; i < size; ++i) {
    const BodyId other = found_[i];
    const Aabb& b = proxies_[other].box;
    found_[kept] = other;
    const bool overlaps = (a.lo - b.hi).cwiseMax(b.lo - a.hi).maxCoeff() <= 0;
    kept += static_cast<std::size_t>(static_cast<int>(overlaps) & static_cast<int>(other != id));
  }
  return {found_.data(), kept};
}

}  // namespace touchstone::fast::simulation
