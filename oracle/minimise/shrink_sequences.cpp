// Shorter sequences: fewer frames, fewer placements, simpler poses.
#include <algorithm>

#include "model/sequence.h"
#include "oracle/minimise/shrink.h"

namespace touchstone::oracle::shrink {
namespace {

/// Drops the removals of bodies that are not there, which a shortened sequence may contain.
Scene legal(Scene sequence) {
  std::vector<bool> there(sequence.bodies.size(), false);
  for (SequenceFrame& frame : sequence.frames) {
    std::erase_if(frame, [&](const Placement& p) { return !p.X_WB && !there[static_cast<std::size_t>(p.body)]; });
    for (const Placement& p : frame) there[static_cast<std::size_t>(p.body)] = p.X_WB.has_value();
  }
  return sequence;
}

std::optional<Scene> without_frames(Scene sequence, std::size_t from, std::size_t count) {
  if (from + count > sequence.frames.size() || count == sequence.frames.size()) return std::nullopt;
  const auto begin = sequence.frames.begin() + static_cast<std::ptrdiff_t>(from);
  sequence.frames.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
  return legal(std::move(sequence));
}

/// Joins frames f and f + 1. For a body in both, the later placement counts.
std::optional<Scene> joined(Scene sequence, std::size_t f) {
  if (f + 1 >= sequence.frames.size()) return std::nullopt;
  SequenceFrame& later = sequence.frames[f + 1];
  for (const Placement& placement : sequence.frames[f]) {
    if (std::ranges::count(later, placement.body, &Placement::body) == 0) later.push_back(placement);
  }
  sequence.frames.erase(sequence.frames.begin() + static_cast<std::ptrdiff_t>(f));
  return legal(std::move(sequence));
}

std::optional<Scene> without_placement(Scene sequence, std::size_t f, std::size_t k) {
  if (f >= sequence.frames.size() || k >= sequence.frames[f].size()) return std::nullopt;
  sequence.frames[f].erase(sequence.frames[f].begin() + static_cast<std::ptrdiff_t>(k));
  return legal(std::move(sequence));
}

template <class Change>
std::optional<Scene> with_pose(Scene sequence, std::size_t f, std::size_t k, Change change) {
  if (f >= sequence.frames.size() || k >= sequence.frames[f].size() || !sequence.frames[f][k].X_WB) return std::nullopt;
  change(*sequence.frames[f][k].X_WB);
  return sequence;
}

/// Resets the bodies' own poses, which a sequence does not use.
std::optional<Scene> own_poses_gone(Scene sequence) {
  for (Body& body : sequence.bodies) body.X_WB = {};
  return sequence;
}

std::optional<Scene> none_turned(Scene sequence) {
  for (Pose* X_WB : poses(sequence)) X_WB->q_WB = {};
  return sequence;
}

}  // namespace

std::vector<Move> fewer_frames(const Scene& sequence) {
  std::vector<Move> moves;
  const std::size_t count = sequence.frames.size();
  for (std::size_t chunk = count / 2; chunk > 0; chunk /= 2) {
    for (std::size_t end = count; end >= chunk; end -= chunk) {  // the last placements are needed least
      moves.push_back([=](const Scene& s) { return without_frames(s, end - chunk, chunk); });
    }
  }
  for (std::size_t f = 0; f + 1 < count; ++f) {
    moves.push_back([f](const Scene& s) { return joined(s, f); });
  }
  return moves;
}

std::vector<Move> fewer_placements(const Scene& sequence) {
  std::vector<Move> moves;
  for (std::size_t f = sequence.frames.size(); f-- > 0;) {
    for (std::size_t k = sequence.frames[f].size(); k-- > 0;) {
      moves.push_back([=](const Scene& s) { return without_placement(s, f, k); });
    }
  }
  return moves;
}

std::vector<Move> shrink_places(const Scene& sequence) {
  if (!is_sequence(sequence)) return {};
  std::vector<Move> moves = {own_poses_gone, none_turned};
  for (std::size_t f = 0; f < sequence.frames.size(); ++f) {
    for (std::size_t k = 0; k < sequence.frames[f].size(); ++k) {
      moves.push_back([=](const Scene& s) { return with_pose(s, f, k, [](Pose& X) { X = {}; }); });
      moves.push_back([=](const Scene& s) { return with_pose(s, f, k, [](Pose& X) { X.q_WB = {}; }); });
      for (int axis = 0; axis < 3; ++axis) {
        moves.push_back([=](const Scene& s) { return with_pose(s, f, k, [axis](Pose& X) { X.p_WB[axis] = 0; }); });
      }
    }
  }
  return moves;
}

}  // namespace touchstone::oracle::shrink
