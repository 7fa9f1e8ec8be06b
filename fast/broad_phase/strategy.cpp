#include "fast/broad_phase/strategy.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "model/infinity.h"
#include "model/input_error.h"

namespace touchstone::fast {
namespace {

// A float holds each smaller id exactly (fast/broad_phase/wrapped_cells.h).
constexpr BodyId id_limit = BodyId{1} << 24U;

// So that differences of two coordinates, and their sums with an extent, stay finite.
constexpr double greatest_coordinate = 0x1p1000;

Aabb nothing() { return {Vec3::Constant(infinity), Vec3::Constant(-infinity)}; }

std::string place(BodyId id) { return "body " + std::to_string(id); }

void check(BodyId id, const Aabb& box) {
  for (int axis = 0; axis < 3; ++axis) {
    // Written so that NaN fails too.
    if (!(std::abs(box.lo[axis]) <= greatest_coordinate && std::abs(box.hi[axis]) <= greatest_coordinate))
      throw InputError(place(id), "a box's coordinates must be numbers of at most 2^1000");
    if (box.lo[axis] > box.hi[axis]) throw InputError(place(id), "a box's lo must not exceed its hi");
  }
}

}  // namespace

inline void BroadPhase::put(BodyId id, const Aabb& box) {
  if (has_moved_[id] == 0) {
    moved_.push_back(id);
    has_moved_[id] = 1;
    was_[id] = box_[id];
  }
  box_[id] = box;
}

void BroadPhase::insert(BodyId id, const Aabb& box) {
  if (id >= id_limit) throw InputError(place(id), "ids must be less than 2^24");
  if (present(id)) throw InputError(place(id), "is already there");
  check(id, box);
  if (id >= box_.size()) {
    make_room(id + 1);
  }
  put(id, box);
  ++count_;
}

void BroadPhase::move(BodyId id, const Aabb& box) {
  if (!present(id)) throw InputError(place(id), "is not there, so it cannot move");
  if (box.lo == box_[id].lo && box.hi == box_[id].hi) return;
  check(id, box);
  put(id, box);
}

void BroadPhase::remove(BodyId id) {
  if (!present(id)) throw InputError(place(id), "is not there, so it cannot be removed");
  put(id, nothing());
  --count_;
}

/// Grows the capacity by an eighth: doubling could use nearly twice the memory needed.
void BroadPhase::make_room(std::size_t ids) {
  if (ids > box_.capacity()) {
    const std::size_t room = std::max(ids, box_.capacity() + box_.capacity() / 8);
    box_.reserve(room);
    was_.reserve(room);
    has_moved_.reserve(room);
    moved_.reserve(room);
  }
  box_.resize(ids, nothing());
  was_.resize(ids, nothing());
  has_moved_.resize(ids, 0);
}

void BroadPhase::update() {
  begun_.clear();
  ended_.clear();
  if (!moved_.empty()) refresh();
  for (const BodyId id : moved_) has_moved_[id] = 0;
  moved_.clear();
}

void BroadPhase::list_present(std::vector<BodyId>& ids) const {
  ids.clear();
  for (BodyId id = 0; id < box_.size(); ++id)
    if (present(id)) ids.push_back(id);
}

void BroadPhase::drop_ended() {
  std::size_t kept = 0;
  for (const BodyPair pair : pairs_) {
    if ((moved(pair.a) || moved(pair.b)) && !overlap(box_[pair.a], box_[pair.b]))
      append(ended_, pair);
    else
      pairs_[kept++] = pair;
  }
  pairs_.resize(kept);
}

void BroadPhase::begin(BodyId a, BodyId b) {
  const BodyPair pair = a < b ? BodyPair{a, b} : BodyPair{b, a};
  append(pairs_, pair);
  append(begun_, pair);
}

}  // namespace touchstone::fast
