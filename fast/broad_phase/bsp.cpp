#include "fast/broad_phase/bsp.h"

#include <algorithm>

#include "model/infinity.h"

namespace touchstone::fast {
namespace {

// A region with at most this many bodies is not split: all pairs are tested. A choice: a split copies the bodies on its
// plane to both sides, and 66 tests cost about as much.
constexpr std::size_t undivided_region = 12;

bool holds(const Aabb& half_open, const Vec3& p) {
  return (half_open.lo.array() <= p.array()).all() && (p.array() < half_open.hi.array()).all();
}

}  // namespace

void Bsp::refresh() {
  drop_ended();
  list_present(list_);
  split(0, {Vec3::Constant(-infinity), Vec3::Constant(infinity)});
}

void Bsp::split(std::size_t first, const Aabb& region) {
  const std::size_t last = list_.size();
  if (last - first <= undivided_region) return report(first, region);

  const auto centre = [this](std::size_t i) -> Vec3 { return box_[list_[i]].lo / 2 + box_[list_[i]].hi / 2; };
  Vec3 least = centre(first);
  Vec3 greatest = least;
  for (std::size_t i = first; i < last; ++i) {
    least = least.cwiseMin(centre(i));
    greatest = greatest.cwiseMax(centre(i));
  }
  int axis = 0;
  (greatest - least).maxCoeff(&axis);
  centres_.clear();
  for (std::size_t i = first; i < last; ++i) centres_.push_back(centre(i)[axis]);
  const auto middle = centres_.begin() + static_cast<std::ptrdiff_t>(centres_.size() / 2);
  std::nth_element(centres_.begin(), middle, centres_.end());
  const double plane = *middle;

  const auto is_below = [&](BodyId id) { return box_[id].lo[axis] < plane; };
  const auto is_above = [&](BodyId id) { return box_[id].hi[axis] >= plane; };
  std::size_t below = 0;
  std::size_t above = 0;
  for (std::size_t i = first; i < last; ++i) {
    below += is_below(list_[i]) ? 1 : 0;
    above += is_above(list_[i]) ? 1 : 0;
  }
  const std::size_t n = last - first;
  if (below == n || above == n || 2 * (below + above) > 3 * n) return report(first, region);

  const auto descend = [&](const auto& belongs, const Aabb& part) {
    for (std::size_t i = first; i < last; ++i)
      if (belongs(list_[i])) list_.push_back(list_[i]);
    // The part's bodies are now at the end of the list.
    split(last, part);
    list_.resize(last);
  };
  Aabb part = region;
  part.hi[axis] = plane;
  descend(is_below, part);
  part = region;
  part.lo[axis] = plane;
  descend(is_above, part);
}

void Bsp::report(std::size_t first, const Aabb& region) {
  for (std::size_t i = first; i < list_.size(); ++i) {
    const Aabb& a = box_[list_[i]];
    for (std::size_t j = i + 1; j < list_.size(); ++j) {
      const Aabb& b = box_[list_[j]];
      if (overlap(a, b) && holds(region, a.lo.cwiseMax(b.lo))) offer(list_[i], list_[j]);
    }
  }
}

}  // namespace touchstone::fast
