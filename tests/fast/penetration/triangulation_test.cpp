// A surface that grows stays closed, and an outline that is not one cycle changes nothing.
#include "fast/penetration/triangulation.h"

#include <algorithm>
#include <set>

#include "tests/catch.h"

namespace touchstone::fast::penetration {
namespace {

/// Each edge belongs to two triangles, in opposite directions, that are neighbours there. Returns their number.
int check_closed(const Triangulation& surface) {
  int alive = 0;
  std::set<std::pair<int, int>> edges;
  for (int t = 0; t < surface.size(); ++t) {
    if (surface[t].is_dead) continue;
    ++alive;
    for (std::size_t i = 0; i < 3; ++i) {
      const int tail = surface[t].corners[i], head = surface[t].corners[(i + 1) % 3];
      CHECK(edges.insert({tail, head}).second);
      const Triangulation::Triangle& next = surface[surface[t].neighbours[i]];
      CHECK_FALSE(next.is_dead);
      bool is_back = false;
      for (std::size_t k = 0; k < 3; ++k) {
        is_back = is_back || (next.corners[k] == head && next.corners[(k + 1) % 3] == tail && next.neighbours[k] == t);
      }
      CHECK(is_back);
    }
  }
  for (const auto& [tail, head] : edges) CHECK(edges.count({head, tail}) == 1);
  return alive;
}

TEST_CASE("a corner above one triangle, above two, and above all but one") {
  Triangulation surface;
  CHECK(surface.empty());
  surface.start();
  CHECK(check_closed(surface) == 4);
  CHECK(surface.insert(4, 0, [](int) { return false; }).size() == 3);
  CHECK(check_closed(surface) == 6);
  const int first = surface.insert(5, 1, [](int t) { return t == 2; }).front();
  CHECK(check_closed(surface) == 8);
  surface.insert(6, first, [&](int t) { return t != 3; });
  CHECK(check_closed(surface) == 4);
}

TEST_CASE("if everything is visible, or the outline meets itself, nothing changes") {
  Triangulation surface;
  surface.start();
  CHECK(surface.insert(4, 0, [](int) { return true; }).empty());
  CHECK(check_closed(surface) == 4);
  surface.insert(4, 0, [](int) { return false; });
  surface.insert(5, 1, [](int) { return false; });
  const int triangles = check_closed(surface);
  int refused = 0;
  for (int from = 0; from < surface.size(); ++from) {
    for (unsigned visible = 0; visible < 1U << surface.size(); ++visible) {
      if (surface[from].is_dead) continue;
      Triangulation copy = surface;
      const bool grows = !copy.insert(6, from, [&](int t) { return (visible >> t & 1U) != 0; }).empty();
      const int now = check_closed(copy);
      if (grows) continue;
      ++refused;
      CHECK(now == triangles);
    }
  }
  CHECK(refused > 0);
}

}  // namespace
}  // namespace touchstone::fast::penetration
