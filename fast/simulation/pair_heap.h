// The heap of the notes: pairs of bodies, the one that may meet first on top.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "fast/broad_phase/strategy.h"

namespace touchstone::fast::world {

/// Nothing happens between a and b (a < b) before `time`. Ordered by time, then by bodies: ties are no accident.
struct Due {
  double time = 0;  ///< s
  BodyId a = 0, b = 0;

  auto operator<=>(const Due&) const = default;
};

/// At most one entry a pair, and each body knows its own: what an impact makes stale is taken out at once, so no entry
/// that is popped is stale.
class PairHeap {
 public:
  explicit PairHeap(std::size_t bodies) : of_body_(bodies) {}

  bool empty() const { return heap_.empty(); }
  const Due& top() const { return heap_.front().due; }

  void put(const Due& due);  ///< requires that the pair has no entry
  void pop();
  void drop(BodyId body);  ///< all entries of the body

 private:
  struct Entry {
    Due due;
    std::uint32_t slot = 0;
  };

  void remove(std::uint32_t slot);
  void forget(BodyId body, std::uint32_t slot);
  void place(std::size_t at, const Entry& entry);
  void rise(std::size_t at, const Entry& entry);
  void sink(std::size_t at, const Entry& entry);

  std::vector<Entry> heap_;
  std::vector<std::uint32_t> place_;                 ///< by slot: where in the heap
  std::vector<std::uint32_t> free_;                  ///< slots
  std::vector<std::vector<std::uint32_t>> of_body_;  ///< slots of its entries
};

}  // namespace touchstone::fast::world
