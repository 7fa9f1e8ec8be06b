#include "fast/broad_phase/all_pairs.h"

namespace touchstone::fast {

void AllPairs::refresh() {
  drop_ended();
  for (const BodyId a : moved_) {
    for (BodyId b = 0; b < box_.size(); ++b) {
      const bool other_finds_it = b == a || (moved(b) && b < a);
      if (!other_finds_it && overlap(box_[a], box_[b])) offer(a, b);
    }
  }
}

}  // namespace touchstone::fast
