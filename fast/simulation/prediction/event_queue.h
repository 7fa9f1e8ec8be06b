// The event queue of the lecture notes: a heap of pairs of bodies, ordered by a lower bound of their time of impact.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "fast/broad_phase/strategy.h"

namespace touchstone::fast::simulation {

/// Bodies a and b (a < b) do not touch before `time`. Ordered by time, then by bodies, so that ties have one order.
struct PairEvent {
  double time = 0;  ///< s
  BodyId a = 0, b = 0;

  auto operator<=>(const PairEvent&) const = default;
};

/// Dropping a body's entries leaves them in place as stale ones: each body counts how often it was dropped, and each
/// entry keeps the counts at its insertion. A stale entry is never on top. Stale entries are cleared out when the heap
/// has twice as many entries as were valid after the last clearing.
class EventQueue {
 public:
  explicit EventQueue(std::size_t bodies) : drops_(bodies) {}

  bool empty() const { return heap_.empty(); }
  const PairEvent& top() const { return heap_.front().pair_event; }

  void put(const PairEvent& pair_event);
  void pop();
  void drop(BodyId body);  ///< drops all of the body's entries

 private:
  static constexpr std::size_t few = 64;

  struct Entry {
    PairEvent pair_event;
    std::uint32_t drops_a = 0, drops_b = 0;
  };

  bool is_stale(const Entry& entry) const {
    return entry.drops_a != drops_[entry.pair_event.a] || entry.drops_b != drops_[entry.pair_event.b];
  }
  void remove_top();
  void clear_top();
  void clear();

  std::vector<Entry> heap_;
  std::vector<std::uint32_t> drops_;  ///< by body
  std::size_t full_ = few;            ///< at this many entries, stale ones are cleared out
};

}  // namespace touchstone::fast::simulation
