#include "fast/simulation/prediction/event_queue.h"

#include <algorithm>

namespace touchstone::fast::simulation {
namespace {

/// Puts the least event on top.
constexpr auto later = [](const auto& x, const auto& y) { return y.pair_event < x.pair_event; };

}  // namespace

void EventQueue::put(const PairEvent& pair_event) {
  if (heap_.size() >= full_) clear();
  heap_.push_back({pair_event, drops_[pair_event.a], drops_[pair_event.b]});
  std::ranges::push_heap(heap_, later);
}

void EventQueue::pop() {
  remove_top();
  clear_top();
}

void EventQueue::drop(BodyId body) {
  ++drops_[body];
  clear_top();
}

void EventQueue::remove_top() {
  std::ranges::pop_heap(heap_, later);
  heap_.pop_back();
}

void EventQueue::clear_top() {
  while (!heap_.empty() && is_stale(heap_.front())) remove_top();
}

void EventQueue::clear() {
  std::erase_if(heap_, [this](const Entry& entry) { return is_stale(entry); });
  std::ranges::make_heap(heap_, later);
  full_ = std::max(few, 2 * heap_.size());
}

}  // namespace touchstone::fast::simulation
