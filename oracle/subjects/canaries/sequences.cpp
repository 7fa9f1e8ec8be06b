// Canaries that carry pairs from frame to frame incorrectly.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <set>

#include "model/sequence.h"
#include "oracle/subjects/canaries/lie.h"

namespace touchstone::oracle::subjects {
namespace {

using Pair = std::pair<int, int>;
using FrameBoxes = std::map<int, Aabb>;  ///< of the bodies present in the frame

std::vector<FrameBoxes> boxes_of(Subject& truthful, const Scene& sequence) {
  std::vector<FrameBoxes> all;
  for (const Places& there : places(sequence)) {
    FrameBoxes& now = all.emplace_back();
    for (std::size_t i = 0; i < there.size(); ++i) {
      if (!there[i]) continue;
      Scene alone;
      alone.bodies = {sequence.bodies[i]};
      alone.bodies[0].X_WB = *there[i];
      with(truthful.bounds(alone), [&](const Bounds& said) { now[static_cast<int>(i)] = said[0]; });
    }
  }
  return all;
}

enum class Fault { end_point_mis_sorted, flag_not_cleared, tie_mis_ordered, removed_keep_pairs };

/// Textbook sweep and prune with one fault: three sorted lists of end points, and a flag for each pair and axis that is
/// set or cleared when a lower and an upper end point are exchanged.
class FaultySweep {
 public:
  explicit FaultySweep(Fault fault) : fault_(fault) {}

  PairSet after(const FrameBoxes& boxes) {
    drop_removed(boxes);
    for (const auto& [body, box] : boxes) {
      if (!listed_.insert(body).second) continue;
      for (auto& list : lists_) {
        list.push_back({body, false, 0});
        list.push_back({body, true, 0});
      }
    }
    for (int axis = 0; axis < 3; ++axis) sort(axis, boxes);
    PairSet pairs;
    for (const auto& [pair, flags] : meets_) {
      if (flags[0] && flags[1] && flags[2]) pairs.push_back(pair);
    }
    return pairs;
  }

 private:
  struct EndPoint {
    int body = 0;
    bool is_end = false;
    double value = 0;
  };

  bool belongs_below(const EndPoint& x, const EndPoint& y) const {
    if (x.value != y.value) return x.value < y.value;
    return fault_ != Fault::tie_mis_ordered && !x.is_end && y.is_end;
  }

  void drop_removed(const FrameBoxes& boxes) {
    const auto gone = [&](int body) { return !boxes.contains(body); };
    for (auto& list : lists_) std::erase_if(list, [&](const EndPoint& e) { return gone(e.body); });
    std::erase_if(listed_, gone);
    if (fault_ == Fault::removed_keep_pairs) return;
    std::erase_if(meets_, [&](const auto& entry) { return gone(entry.first.first) || gone(entry.first.second); });
  }

  void sort(int axis, const FrameBoxes& boxes) {
    std::vector<EndPoint>& list = lists_[static_cast<std::size_t>(axis)];
    for (EndPoint& e : list) e.value = e.is_end ? boxes.at(e.body).hi[axis] : boxes.at(e.body).lo[axis];
    const bool last_stays = fault_ == Fault::end_point_mis_sorted && axis == 1 && list.size() > 4;
    for (std::size_t i = 1; i + (last_stays ? 1 : 0) < list.size(); ++i) {
      for (std::size_t at = i; at > 0 && belongs_below(list[at], list[at - 1]); --at) {
        swapped(axis, list[at], list[at - 1]);
        std::swap(list[at], list[at - 1]);
      }
    }
  }

  void swapped(int axis, const EndPoint& now_below, const EndPoint& now_above) {
    if (now_below.is_end == now_above.is_end || now_below.body == now_above.body) return;
    const bool meets = now_above.is_end;
    if (!meets && fault_ == Fault::flag_not_cleared && axis == 2) return;
    meets_[std::minmax(now_below.body, now_above.body)][static_cast<std::size_t>(axis)] = meets;
  }

  Fault fault_;
  std::array<std::vector<EndPoint>, 3> lists_;
  std::set<int> listed_;
  std::map<Pair, std::array<bool, 3>> meets_;
};

/// Computes `begun` and `ended` so that they are consistent with the reported pairs.
void with_events(PairHistory& history) {
  PairSet before;
  for (PairFrame& frame : history) {
    frame.begun = frame.ended = PairSet{};
    std::ranges::set_difference(frame.pairs, before, std::back_inserter(*frame.begun));
    std::ranges::set_difference(before, frame.pairs, std::back_inserter(*frame.ended));
    before = frame.pairs;
  }
}

Lies sequences(Lie<PairHistory> lie) {
  Lies lies;
  lies.pair_history = std::move(lie);
  return lies;
}

Lies sweep_with(Fault fault) {
  return sequences([fault](Subject& truthful, const Scene& sequence, PairHistory& said) {
    FaultySweep sweep(fault);
    const std::vector<FrameBoxes> boxes = boxes_of(truthful, sequence);
    for (std::size_t f = 0; f < said.size(); ++f) said[f].pairs = sweep.after(boxes[f]);
    with_events(said);
  });
}

/// A hierarchical grid, one level for each power of two, that never compares a level with the one two above it.
void level_skipped(Subject& truthful, const Scene& sequence, PairHistory& said) {
  const std::vector<FrameBoxes> boxes = boxes_of(truthful, sequence);
  const auto level = [](const Aabb& box) { return std::ilogb((box.hi - box.lo).maxCoeff()); };
  for (std::size_t f = 0; f < said.size(); ++f) {
    std::erase_if(said[f].pairs, [&](const Pair& pair) {
      return std::abs(level(boxes[f].at(pair.first)) - level(boxes[f].at(pair.second))) == 2;
    });
  }
  with_events(said);
}

void begun_lost(Subject&, const Scene&, PairHistory& said) {
  for (PairFrame& frame : said) {
    if (frame.begun && !frame.begun->empty()) frame.begun->pop_back();
  }
}

void begins_again(Subject&, const Scene&, PairHistory& said) {
  for (PairFrame& frame : said) frame.begun = frame.pairs;
}

void a_frame_late(Subject&, const Scene&, PairHistory& said) {
  for (std::size_t f = said.size(); f-- > 0;) said[f].pairs = f == 0 ? PairSet{} : said[f - 1].pairs;
  with_events(said);
}

void frame_left_out(Subject&, const Scene&, PairHistory& said) {
  std::erase_if(said, [first = true](const PairFrame& frame) mutable {
    const bool still = !first && frame.begun == PairSet{} && frame.ended == PairSet{};
    first = false;
    return still;
  });
}

// Adds the pairs whose boxes are apart by less than about three times what is granted.
void add_near(const FrameBoxes& boxes, double near, PairSet& pairs) {
  for (const auto& [i, a] : boxes) {
    for (const auto& [j, b] : boxes) {
      const double gap = std::max((a.lo - b.hi).maxCoeff(), (b.lo - a.hi).maxCoeff());
      if (i < j && gap > 0 && gap <= near) pairs.emplace_back(i, j);
    }
  }
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

Lies slightly_generous(int truthful_answers) {
  const auto asked = std::make_shared<int>(0);
  constexpr double near = 1300;
  Lies lies;
  lies.broad_phase = [=](Subject& truthful, const Scene& scene, PairSet& said) {
    if (++*asked <= truthful_answers) return;
    with(truthful.bounds(scene), [&](const Bounds& all) {
      FrameBoxes boxes;
      for (std::size_t i = 0; i < all.size(); ++i) boxes[static_cast<int>(i)] = all[i];
      add_near(boxes, near * rounding_of_length(scene), said);
    });
  };
  lies.pair_history = [=](Subject& truthful, const Scene& sequence, PairHistory& said) {
    if (++*asked <= truthful_answers) return;
    const std::vector<FrameBoxes> boxes = boxes_of(truthful, sequence);
    for (std::size_t f = 0; f < said.size(); ++f) add_near(boxes[f], near * rounding, said[f].pairs);
  };
  return lies;
}

}  // namespace

std::vector<Canary> canaries_about_sequences() {
  return {
      lying("canary.end_point_mis_sorted", "leaves the last end point of one list where it was",
            [] { return sweep_with(Fault::end_point_mis_sorted); }),
      lying("canary.flag_not_cleared", "never clears the flag of one axis",
            [] { return sweep_with(Fault::flag_not_cleared); }),
      lying("canary.tie_mis_ordered", "leaves end points that tie in the order in which they came",
            [] { return sweep_with(Fault::tie_mis_ordered); }),
      lying("canary.removed_keep_pairs", "keeps the pairs of a body that was taken away",
            [] { return sweep_with(Fault::removed_keep_pairs); }),
      lying("canary.level_skipped", "compares no boxes that differ by two levels of size",
            [] { return sequences(level_skipped); }),
      lying("canary.begun_lost", "loses one pair that begins in a frame", [] { return sequences(begun_lost); }),
      lying("canary.begins_again", "reports all pairs as begun in every frame", [] { return sequences(begins_again); }),
      lying("canary.a_frame_late", "reports the pairs of the frame before", [] { return sequences(a_frame_late); }),
      lying("canary.frame_left_out", "has no entry for a frame in which nothing changes",
            [] { return sequences(frame_left_out); }),
      lying("canary.slightly_generous", "reports pairs whose boxes are apart by three times what is granted",
            [] { return slightly_generous(0); }),
      lying("canary.slightly_generous_later", "reports such pairs in each answer but its first",
            [] { return slightly_generous(1); }),
  };
}

}  // namespace touchstone::oracle::subjects
