#include "fast/broad_phase/sweep_and_prune.h"

namespace touchstone::fast {
namespace {

/// Beyond all coordinates, and different for each body, so that two bodies removed together also end their pair.
double waiting_place(BodyId id) { return 0x1p1001 * (1 + 0x1p-24 * id); }

}  // namespace

void SweepAndPrune::refresh() {
  list_new();
  swaps_ = 0;
  for (int axis = 0; axis < 3; ++axis) sort(axis);
  cut_off_absent();
}

void SweepAndPrune::list_new() {
  listed_.resize(box_.size(), 0);
  for (const BodyId id : moved_) {
    if (listed_[id] != 0 || !present(id)) continue;
    listed_[id] = 1;
    for (auto& list : lists_) {
      list.push_back({0, id, false});
      list.push_back({0, id, true});
    }
  }
}

void SweepAndPrune::sort(int axis) {
  std::vector<EndPoint>& list = lists_[static_cast<std::size_t>(axis)];
  const auto belongs_below = [](const EndPoint& x, const EndPoint& y) {
    return x.value < y.value || (x.value == y.value && !x.is_end && y.is_end);
  };
  for (EndPoint& e : list) {
    const Aabb& box = box_[e.body];
    e.value = !present(e.body) ? waiting_place(e.body) : e.is_end ? box.hi[axis] : box.lo[axis];
  }
  for (std::size_t i = 1; i < list.size(); ++i) {
    const EndPoint sinking = list[i];
    std::size_t at = i;
    for (; at > 0 && belongs_below(sinking, list[at - 1]); --at) {
      swapped(sinking, list[at - 1]);
      list[at] = list[at - 1];
    }
    list[at] = sinking;
    swaps_ += i - at;
  }
}

void SweepAndPrune::swapped(const EndPoint& now_below, const EndPoint& now_above) {
  if (now_below.is_end == now_above.is_end) return;
  const BodyId a = now_below.body;
  const BodyId b = now_above.body;
  const BodyPair pair = a < b ? BodyPair{a, b} : BodyPair{b, a};
  if (now_above.is_end) {
    if (!overlap(box_[a], box_[b]) || index_.holds(pairs_, pair)) return;
    index_.add(pairs_, pair);
    begun_.push_back(pair);
  } else if (index_.holds(pairs_, pair)) {
    index_.remove(pairs_, pair);
    ended_.push_back(pair);
  }
}

void SweepAndPrune::cut_off_absent() {
  for (auto& list : lists_) {
    while (!list.empty() && !present(list.back().body)) {
      listed_[list.back().body] = 0;
      list.pop_back();
    }
  }
}

}  // namespace touchstone::fast
