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

/// What an impact makes stale is forgotten where it stands: each body counts how often it was dropped, and each entry
/// knows the counts of its time. None is ever on top, and the heap has room for as many stale entries as good ones.
class PairHeap {
 public:
  explicit PairHeap(std::size_t bodies) : drops_(bodies) {}

  bool empty() const { return heap_.empty(); }
  const Due& top() const { return heap_.front().due; }

  void put(const Due& due);
  void pop();
  void drop(BodyId body);  ///< all entries of the body

 private:
  static constexpr std::size_t few = 64;

  struct Entry {
    Due due;
    std::uint32_t drops_a = 0, drops_b = 0;
  };

  bool is_stale(const Entry& entry) const {
    return entry.drops_a != drops_[entry.due.a] || entry.drops_b != drops_[entry.due.b];
  }
  void remove_top();
  void clear_top();
  void clear();

  std::vector<Entry> heap_;
  std::vector<std::uint32_t> drops_;  ///< by body
  std::size_t full_ = few;            ///< so many entries, and it is time to clear what is stale
};

}  // namespace touchstone::fast::world
