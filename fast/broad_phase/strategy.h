// What all broad-phase strategies have in common: bodies with boxes are inserted, moved and removed; pairs begin and
// end.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "model/frame.h"

namespace touchstone::fast {

/// The caller's id of a body. Less than 2^24, and preferably small: memory grows with the greatest id.
using BodyId = std::uint32_t;

/// a < b.
struct BodyPair {
  BodyId a = 0;
  BodyId b = 0;

  auto operator<=>(const BodyPair&) const = default;
};

/// Closed boxes: a shared boundary point is an overlap.
inline bool overlap(const Aabb& a, const Aabb& b) {
  return a.lo.x() <= b.hi.x() && b.lo.x() <= a.hi.x() && a.lo.y() <= b.hi.y() && b.lo.y() <= a.hi.y() &&
         a.lo.z() <= b.hi.z() && b.lo.z() <= a.hi.z();
}

/// Grows the capacity by an eighth: doubling could use nearly twice the memory needed.
inline void append(std::vector<BodyPair>& pairs, BodyPair pair) {
  if (pairs.size() == pairs.capacity()) pairs.reserve(pairs.size() + pairs.size() / 8 + 16);
  pairs.push_back(pair);
}

/// Which boxes overlap, from frame to frame. insert, move and remove collect changes; update() ends the frame.
///
/// Laws: after update(), pairs() are exactly the pairs of present boxes that overlap, each once; begun() and ended()
/// are what pairs() gained and lost since the previous update. None is sorted, but the same calls give the same order.
///
/// Errors: insert, move and remove throw InputError and change nothing if a number is NaN, infinite or beyond 2^1000,
/// if lo > hi, or if an id is too large, inserted twice, or not present.
///
/// Cost: a body whose box is announced again unchanged counts as one that did not move.
class BroadPhase {
 public:
  virtual ~BroadPhase() = default;

  void insert(BodyId id, const Aabb& box);
  void move(BodyId id, const Aabb& box);
  void remove(BodyId id);
  void update();

  const std::vector<BodyPair>& pairs() const { return pairs_; }
  const std::vector<BodyPair>& begun() const { return begun_; }
  const std::vector<BodyPair>& ended() const { return ended_; }

 protected:
  /// Updates pairs_, begun_ and ended_ from box_. Called only if something moved; begun_ and ended_ are empty on entry.
  virtual void refresh() = 0;

  bool present(BodyId id) const { return id < box_.size() && box_[id].lo.x() <= box_[id].hi.x(); }
  bool moved(BodyId id) const { return has_moved_[id] != 0; }
  std::size_t count() const { return count_; }

  /// Lists the present ids, ascending.
  void list_present(std::vector<BodyId>& ids) const;

  /// For strategies that search: moves the pairs that ended from pairs_ to ended_.
  void drop_ended();

  /// For strategies that search: a and b overlap now; the pair begins unless it overlapped before. Call once per pair
  /// and frame.
  void offer(BodyId a, BodyId b) {
    if (!overlap(was(a), was(b))) begin(a, b);
  }
  void begin(BodyId a, BodyId b);

  /// The box at the previous update.
  const Aabb& was(BodyId id) const { return moved(id) ? was_[id] : box_[id]; }

  /// By id. An absent body's box is empty (lo = +∞, hi = −∞) and overlaps nothing, so insertion and removal are moves.
  std::vector<Aabb> box_;
  std::vector<BodyId> moved_;  ///< ids whose box may differ from that at the previous update, each once

  std::vector<BodyPair> pairs_;
  std::vector<BodyPair> begun_;
  std::vector<BodyPair> ended_;

 private:
  void make_room(std::size_t ids);
  void put(BodyId id, const Aabb& box);

  std::vector<Aabb> was_;  ///< of bodies that moved: box_ at the previous update
  std::vector<std::uint8_t> has_moved_;
  std::size_t count_ = 0;
};

}  // namespace touchstone::fast
