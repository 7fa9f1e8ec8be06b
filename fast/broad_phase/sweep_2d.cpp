#include "fast/broad_phase/sweep_2d.h"

#include <algorithm>
#include <tuple>

#include "model/infinity.h"

namespace touchstone::fast {
namespace {

constexpr double never = -infinity;

}  // namespace

void Sweep2d::refresh() {
  drop_ended();
  list_present(ids_);
  if (ids_.size() < 2) return;
  choose_axes();
  plant_tree();
  order_events();
  for (const Event& event : events_) {
    if (!event.is_end) report_overlaps(event.body);
    put(event.body, event.is_end ? never : box_[event.body].hi[tree_axis_]);
  }
}

/// Leaves out the axis along which the bodies are spread least.
void Sweep2d::choose_axes() {
  Aabb all = box_[ids_.front()];
  for (const BodyId id : ids_) {
    all.lo = all.lo.cwiseMin(box_[id].lo);
    all.hi = all.hi.cwiseMax(box_[id].hi);
  }
  int least = 0;
  (all.hi - all.lo).minCoeff(&least);
  sweep_axis_ = (least + 1) % 3;
  tree_axis_ = (least + 2) % 3;
}

void Sweep2d::plant_tree() {
  std::sort(ids_.begin(), ids_.end(), [this](BodyId a, BodyId b) {
    return std::make_tuple(box_[a].lo[tree_axis_], a) < std::make_tuple(box_[b].lo[tree_axis_], b);
  });
  leaf_.resize(box_.size());
  for (std::uint32_t i = 0; i < ids_.size(); ++i) leaf_[ids_[i]] = i;
  leaves_ = 1;
  while (leaves_ < ids_.size()) leaves_ *= 2;
  greatest_end_.assign(2 * leaves_, never);
}

void Sweep2d::order_events() {
  events_.clear();
  for (const BodyId id : ids_) {
    events_.push_back({box_[id].lo[sweep_axis_], id, false});
    events_.push_back({box_[id].hi[sweep_axis_], id, true});
  }
  std::sort(events_.begin(), events_.end(), [](const Event& x, const Event& y) {
    return std::tie(x.at, x.is_end, x.body) < std::tie(y.at, y.is_end, y.body);
  });
}

void Sweep2d::put(BodyId id, double end) {
  std::size_t node = leaves_ + leaf_[id];
  greatest_end_[node] = end;
  for (node /= 2; node > 0; node /= 2)
    greatest_end_[node] = std::max(greatest_end_[2 * node], greatest_end_[2 * node + 1]);
}

void Sweep2d::report_overlaps(BodyId id) {
  const double hi = box_[id].hi[tree_axis_];
  const auto last =
      std::partition_point(ids_.begin(), ids_.end(), [&](BodyId other) { return box_[other].lo[tree_axis_] <= hi; });
  descend(1, 0, leaves_, static_cast<std::size_t>(last - ids_.begin()), id);
}

/// The leaves below `node` are first … first + width − 1; those from `last` on begin too late.
void Sweep2d::descend(std::size_t node, std::size_t first, std::size_t width, std::size_t last, BodyId id) {
  if (first >= last || greatest_end_[node] < box_[id].lo[tree_axis_]) return;
  if (width == 1) {
    if (overlap(box_[ids_[first]], box_[id])) offer(ids_[first], id);
    return;
  }
  descend(2 * node, first, width / 2, last, id);
  descend(2 * node + 1, first + width / 2, width / 2, last, id);
}

}  // namespace touchstone::fast
