#include "fast/broad_phase/pair_index.h"

namespace touchstone::fast {

/// Fibonacci hashing of both ids; uses the high bits, which are mixed best.
std::size_t PairIndex::home(BodyPair pair) const {
  const std::uint64_t key = (std::uint64_t{pair.a} << 32U) | pair.b;
  return static_cast<std::size_t>((key * 0x9e3779b97f4a7c15U) >> 32U) & (position_.size() - 1);
}

std::size_t PairIndex::find(const std::vector<BodyPair>& pairs, BodyPair pair) const {
  std::size_t slot = home(pair);
  while (position_[slot] != empty && pairs[position_[slot]] != pair) slot = (slot + 1) & (position_.size() - 1);
  return slot;
}

bool PairIndex::holds(const std::vector<BodyPair>& pairs, BodyPair pair) const {
  return !position_.empty() && position_[find(pairs, pair)] != empty;
}

void PairIndex::add(std::vector<BodyPair>& pairs, BodyPair pair) {
  if (position_.size() < 2 * (pairs.size() + 1)) grow(pairs);
  position_[find(pairs, pair)] = static_cast<std::uint32_t>(pairs.size());
  pairs.push_back(pair);
}

void PairIndex::remove(std::vector<BodyPair>& pairs, BodyPair pair) {
  const std::size_t slot = find(pairs, pair);
  const std::uint32_t at = position_[slot];
  position_[find(pairs, pairs.back())] = at;
  position_[slot] = empty;
  pairs[at] = pairs.back();
  pairs.pop_back();
  close_gap(pairs, slot);
}

/// Moves later entries of the run back into the gap unless their home slot is behind it.
void PairIndex::close_gap(const std::vector<BodyPair>& pairs, std::size_t gap) {
  const std::size_t mask = position_.size() - 1;
  for (std::size_t slot = (gap + 1) & mask; position_[slot] != empty; slot = (slot + 1) & mask) {
    const std::size_t way = (slot - home(pairs[position_[slot]])) & mask;
    if (way >= ((slot - gap) & mask)) {
      position_[gap] = position_[slot];
      position_[slot] = empty;
      gap = slot;
    }
  }
}

void PairIndex::grow(const std::vector<BodyPair>& pairs) {
  position_.assign(position_.empty() ? 16 : 2 * position_.size(), empty);
  for (std::uint32_t i = 0; i < pairs.size(); ++i) position_[find(pairs, pairs[i])] = i;
}

}  // namespace touchstone::fast
