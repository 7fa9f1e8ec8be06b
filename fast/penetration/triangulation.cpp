#include "fast/penetration/triangulation.h"

namespace touchstone::fast::penetration {
namespace {

constexpr int none = -1;

}  // namespace

void Triangulation::clear() {
  triangles_.clear();
  unused_.clear();
}

void Triangulation::start() {
  clear();
  triangles_ = {{{0, 1, 2}, {1, 2, 3}}, {{0, 3, 1}, {3, 2, 0}}, {{1, 3, 2}, {1, 3, 0}}, {{2, 3, 0}, {2, 1, 0}}};
}

int Triangulation::new_triangle(int a, int b, int c) {
  int t = size();
  if (unused_.empty()) {
    triangles_.emplace_back();
  } else {
    t = unused_.back();
    unused_.pop_back();
  }
  triangles_[static_cast<std::size_t>(t)] = {{a, b, c}, {}};
  return t;
}

void Triangulation::find_outline() {
  outline_.clear();
  for (const int t : visible_) {
    const Triangle& triangle = (*this)[t];
    for (std::size_t i = 0; i < 3; ++i) {
      if ((*this)[triangle.neighbours[i]].is_dead) continue;
      outline_.push_back({triangle.corners[i], triangle.corners[(i + 1) % 3], triangle.neighbours[i]});
    }
  }
}

/// Whether the outline is one cycle that has each corner once. Of edges with one tail the last is kept, so that a way
/// along the others ends too early, or never.
bool Triangulation::is_one_cycle(int corners) {
  starts_at_.assign(static_cast<std::size_t>(corners), none);
  for (std::size_t k = 0; k < outline_.size(); ++k) {
    starts_at_[static_cast<std::size_t>(outline_[k].tail)] = static_cast<int>(k);
  }
  if (outline_.size() < 3) return false;
  int at = 0;
  for (std::size_t length = 1; length <= outline_.size(); ++length) {
    at = starts_at_[static_cast<std::size_t>(outline_[static_cast<std::size_t>(at)].head)];
    if (at == none) return false;
    if (at == 0) return length == outline_.size();
  }
  return false;
}

const std::vector<int>& Triangulation::replace_visible(int apex) {
  fresh_.clear();
  find_outline();
  if (!is_one_cycle(apex)) {
    for (const int t : visible_) triangles_[static_cast<std::size_t>(t)].is_dead = false;
    return fresh_;
  }
  unused_.insert(unused_.end(), visible_.begin(), visible_.end());
  for (const Edge& edge : outline_) {
    const int t = new_triangle(edge.tail, edge.head, apex);
    fresh_.push_back(t);
    starts_at_[static_cast<std::size_t>(edge.tail)] = t;
    triangles_[static_cast<std::size_t>(t)].neighbours[0] = edge.beyond;
    Triangle& beyond = triangles_[static_cast<std::size_t>(edge.beyond)];
    for (std::size_t i = 0; i < 3; ++i) {
      if (beyond.corners[i] == edge.head && beyond.corners[(i + 1) % 3] == edge.tail) beyond.neighbours[i] = t;
    }
  }
  for (std::size_t k = 0; k < outline_.size(); ++k) {
    const int after = starts_at_[static_cast<std::size_t>(outline_[k].head)];
    triangles_[static_cast<std::size_t>(fresh_[k])].neighbours[1] = after;
    triangles_[static_cast<std::size_t>(after)].neighbours[2] = fresh_[k];
  }
  return fresh_;
}

}  // namespace touchstone::fast::penetration
