// Shorter films: fewer frames, fewer placements, plainer places.
#include <algorithm>

#include "model/film.h"
#include "oracle/smaller.h"

namespace touchstone::oracle::smaller {
namespace {

/// Nobody is taken away who is not there: what a shorter film leaves without sense goes too.
Scene legal(Scene film) {
  std::vector<bool> there(film.bodies.size(), false);
  for (Frame& frame : film.frames) {
    std::erase_if(frame, [&](const Placement& p) { return !p.X_WB && !there[static_cast<std::size_t>(p.body)]; });
    for (const Placement& p : frame) there[static_cast<std::size_t>(p.body)] = p.X_WB.has_value();
  }
  return film;
}

std::optional<Scene> without_frames(Scene film, std::size_t from, std::size_t count) {
  if (from + count > film.frames.size() || count == film.frames.size()) return std::nullopt;
  const auto begin = film.frames.begin() + static_cast<std::ptrdiff_t>(from);
  film.frames.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
  return legal(std::move(film));
}

/// Frames f and f + 1 in one: of a body that both name, what the later one says.
std::optional<Scene> joined(Scene film, std::size_t f) {
  if (f + 1 >= film.frames.size()) return std::nullopt;
  Frame& later = film.frames[f + 1];
  for (const Placement& placement : film.frames[f]) {
    if (std::ranges::count(later, placement.body, &Placement::body) == 0) later.push_back(placement);
  }
  film.frames.erase(film.frames.begin() + static_cast<std::ptrdiff_t>(f));
  return legal(std::move(film));
}

std::optional<Scene> without_placement(Scene film, std::size_t f, std::size_t k) {
  if (f >= film.frames.size() || k >= film.frames[f].size()) return std::nullopt;
  film.frames[f].erase(film.frames[f].begin() + static_cast<std::ptrdiff_t>(k));
  return legal(std::move(film));
}

template <class Change>
std::optional<Scene> with_pose(Scene film, std::size_t f, std::size_t k, Change change) {
  if (f >= film.frames.size() || k >= film.frames[f].size() || !film.frames[f][k].X_WB) return std::nullopt;
  change(*film.frames[f][k].X_WB);
  return film;
}

/// No body of a film stands at its own pose.
std::optional<Scene> own_poses_gone(Scene film) {
  for (Body& body : film.bodies) body.X_WB = {};
  return film;
}

std::optional<Scene> none_turned(Scene film) {
  for (Pose* X_WB : poses(film)) X_WB->q_WB = {};
  return film;
}

}  // namespace

std::vector<Move> fewer_frames(const Scene& film) {
  std::vector<Move> moves;
  const std::size_t count = film.frames.size();
  for (std::size_t chunk = count / 2; chunk > 0; chunk /= 2) {
    for (std::size_t end = count; end >= chunk; end -= chunk) {  // what comes last is needed least
      moves.push_back([=](const Scene& s) { return without_frames(s, end - chunk, chunk); });
    }
  }
  for (std::size_t f = 0; f + 1 < count; ++f) {
    moves.push_back([f](const Scene& s) { return joined(s, f); });
  }
  return moves;
}

std::vector<Move> fewer_placements(const Scene& film) {
  std::vector<Move> moves;
  for (std::size_t f = film.frames.size(); f-- > 0;) {
    for (std::size_t k = film.frames[f].size(); k-- > 0;) {
      moves.push_back([=](const Scene& s) { return without_placement(s, f, k); });
    }
  }
  return moves;
}

std::vector<Move> plainer_places(const Scene& film) {
  if (!is_film(film)) return {};
  std::vector<Move> moves = {own_poses_gone, none_turned};
  for (std::size_t f = 0; f < film.frames.size(); ++f) {
    for (std::size_t k = 0; k < film.frames[f].size(); ++k) {
      moves.push_back([=](const Scene& s) { return with_pose(s, f, k, [](Pose& X) { X = {}; }); });
      moves.push_back([=](const Scene& s) { return with_pose(s, f, k, [](Pose& X) { X.q_WB = {}; }); });
      for (int axis = 0; axis < 3; ++axis) {
        moves.push_back([=](const Scene& s) { return with_pose(s, f, k, [axis](Pose& X) { X.p_WB[axis] = 0; }); });
      }
    }
  }
  return moves;
}

}  // namespace touchstone::oracle::smaller
