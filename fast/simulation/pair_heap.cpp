#include "fast/simulation/pair_heap.h"

#include <algorithm>

namespace touchstone::fast::world {

void PairHeap::put(const Due& due) {
  if (free_.empty()) {
    free_.push_back(static_cast<std::uint32_t>(place_.size()));
    place_.push_back(0);
  }
  const std::uint32_t slot = free_.back();
  free_.pop_back();
  of_body_[due.a].push_back(slot);
  of_body_[due.b].push_back(slot);
  heap_.emplace_back();
  rise(heap_.size() - 1, {due, slot});
}

void PairHeap::pop() { remove(heap_.front().slot); }

void PairHeap::drop(BodyId body) {
  while (!of_body_[body].empty()) remove(of_body_[body].back());
}

/// The last entry takes its place.
void PairHeap::remove(std::uint32_t slot) {
  const std::size_t at = place_[slot];
  forget(heap_[at].due.a, slot);
  forget(heap_[at].due.b, slot);
  free_.push_back(slot);
  const Entry last = heap_.back();
  heap_.pop_back();
  if (at == heap_.size()) return;
  if (at > 0 && last.due < heap_[(at - 1) / 2].due) {
    rise(at, last);
  } else {
    sink(at, last);
  }
}

void PairHeap::forget(BodyId body, std::uint32_t slot) {
  std::vector<std::uint32_t>& slots = of_body_[body];
  *std::ranges::find(slots, slot) = slots.back();
  slots.pop_back();
}

void PairHeap::place(std::size_t at, const Entry& entry) {
  heap_[at] = entry;
  place_[entry.slot] = static_cast<std::uint32_t>(at);
}

void PairHeap::rise(std::size_t at, const Entry& entry) {
  while (at > 0 && entry.due < heap_[(at - 1) / 2].due) {
    place(at, heap_[(at - 1) / 2]);
    at = (at - 1) / 2;
  }
  place(at, entry);
}

void PairHeap::sink(std::size_t at, const Entry& entry) {
  for (std::size_t child = 2 * at + 1; child < heap_.size(); child = 2 * at + 1) {
    if (child + 1 < heap_.size() && heap_[child + 1].due < heap_[child].due) ++child;
    if (entry.due < heap_[child].due) break;
    place(at, heap_[child]);
    at = child;
  }
  place(at, entry);
}

}  // namespace touchstone::fast::world
