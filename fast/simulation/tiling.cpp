#include "fast/simulation/tiling.h"

#include <algorithm>
#include <cmath>

namespace touchstone::fast::world {

Tiling::Tiling(double cell, std::size_t bodies) : box_(bodies), place_(bodies), level_(levels) {
  while (side_ * side_ * side_ < 2 * static_cast<std::int64_t>(bodies)) side_ *= 2, ++shift_;
  for (int i = 0; i < levels; ++i) level_[static_cast<std::size_t>(i)].per_metre = std::ldexp(1 / cell, middle - i);
}

/// Far away all is in one row: right, only slower. A rounded product keeps the order of rows, which is all that counts.
std::int64_t Tiling::row(const Level& level, double x) const {
  return static_cast<std::int64_t>(std::floor(std::clamp(x * level.per_metre, -0x1p60, 0x1p60)));
}

std::uint32_t Tiling::cell(std::int64_t x, std::int64_t y, std::int64_t z) const {
  const std::int64_t mask = side_ - 1;
  return static_cast<std::uint32_t>((((z & mask) << shift_ | (y & mask)) << shift_) | (x & mask));
}

void Tiling::take(BodyId id) {
  Place& place = place_[id];
  if (place.level < 0) return;
  Level& level = level_[static_cast<std::size_t>(place.level)];
  (place.before == nobody ? level.first[place.cell] : place_[place.before].after) = place.after;
  if (place.after != nobody) place_[place.after].before = place.before;
  level.all[place.at] = level.all.back();
  place_[level.all[place.at]].at = place.at;
  level.all.pop_back();
}

void Tiling::file(BodyId id, const Aabb& box) {
  const double extent = (box.hi - box.lo).maxCoeff() * (1 + 0x1p-50);
  int on = 0;
  while (on + 1 < levels && extent * level_[static_cast<std::size_t>(on)].per_metre > 1) ++on;
  Level& level = level_[static_cast<std::size_t>(on)];
  const std::uint32_t in = cell(row(level, box.lo.x()), row(level, box.lo.y()), row(level, box.lo.z()));
  box_[id] = box;
  Place& place = place_[id];
  if (place.level == on && place.cell == in) return;
  take(id);
  if (level.first.empty()) level.first.assign(static_cast<std::size_t>(side_ * side_ * side_), nobody);
  place = {on, in, static_cast<std::uint32_t>(level.all.size()), nobody, level.first[in]};
  if (place.after != nobody) place_[place.after].before = id;
  level.first[in] = id;
  level.all.push_back(id);
}

/// The lo of a box that meets this one stands in [lo − cell, hi]; rounding keeps that order. What is longer than the
/// longest cells stands in a list.
template <class Meet>
void Tiling::look(const Level& level, const Aabb& box, const Meet& meet) const {
  std::int64_t from[3], count[3];
  std::int64_t cells = 1;
  for (int i = 0; i < 3; ++i) {
    from[i] = row(level, box.lo[i] - 1 / level.per_metre);
    count[i] = std::min(row(level, box.hi[i]) - from[i] + 1, side_);
    cells *= count[i];
  }
  if (level.all.size() <= few || &level == &level_.back() || static_cast<std::int64_t>(level.all.size()) <= cells) {
    for (const BodyId id : level.all) meet(id);
    return;
  }
  for (std::int64_t z = 0; z < count[2]; ++z)
    for (std::int64_t y = 0; y < count[1]; ++y)
      for (std::int64_t x = 0; x < count[0]; ++x)
        for (std::uint32_t id = level.first[cell(from[0] + x, from[1] + y, from[2] + z)]; id != nobody;
             id = place_[id].after)
          meet(id);
}

void Tiling::near(BodyId id, std::vector<BodyId>& found) const {
  const Aabb& box = box_[id];
  for (const Level& level : level_) {
    if (level.all.empty()) continue;
    look(level, box, [&](BodyId other) {
      if (other != id && overlap(box, box_[other])) found.push_back(other);
    });
  }
}

}  // namespace touchstone::fast::world
