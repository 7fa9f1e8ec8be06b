#include "fast/simulation/pair_heap.h"

#include <algorithm>

namespace touchstone::fast::world {
namespace {

/// The least one on top.
constexpr auto later = [](const auto& x, const auto& y) { return y.due < x.due; };

}  // namespace

void PairHeap::put(const Due& due) {
  if (heap_.size() >= full_) clear();
  heap_.push_back({due, drops_[due.a], drops_[due.b]});
  std::ranges::push_heap(heap_, later);
}

void PairHeap::pop() {
  remove_top();
  clear_top();
}

void PairHeap::drop(BodyId body) {
  ++drops_[body];
  clear_top();
}

void PairHeap::remove_top() {
  std::ranges::pop_heap(heap_, later);
  heap_.pop_back();
}

void PairHeap::clear_top() {
  while (!heap_.empty() && is_stale(heap_.front())) remove_top();
}

void PairHeap::clear() {
  std::erase_if(heap_, [this](const Entry& entry) { return is_stale(entry); });
  std::ranges::make_heap(heap_, later);
  full_ = std::max(few, 2 * heap_.size());
}

}  // namespace touchstone::fast::world
