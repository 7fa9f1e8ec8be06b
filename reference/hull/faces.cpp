#include "reference/hull/faces.h"

#include <algorithm>
#include <tuple>

namespace touchstone::reference {
namespace {

bool surely_nonzero(const EnclosureVec& v) {
  const auto excludes_zero = [](const Enclosure& x) { return x.inf() > 0 || x.sup() < 0; };
  return excludes_zero(v.x) || excludes_zero(v.y) || excludes_zero(v.z);
}

}  // namespace

std::vector<Edge> edges_of(const std::vector<std::vector<int>>& faces) {
  struct HalfEdge {
    int low, high;
    bool backward;
    int face;
  };
  std::vector<HalfEdge> halves;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    int tail = faces[f].back();
    for (const int head : faces[f]) {
      halves.push_back({std::min(tail, head), std::max(tail, head), tail > head, static_cast<int>(f)});
      tail = head;
    }
  }
  std::sort(halves.begin(), halves.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.low, a.high, a.backward) < std::tie(b.low, b.high, b.backward);
  });
  std::vector<Edge> edges;
  edges.reserve(halves.size() / 2);
  for (std::size_t i = 0; i + 1 < halves.size(); i += 2) {
    edges.push_back({halves[i].low, halves[i].high, halves[i].face, halves[i + 1].face});
  }
  return edges;
}

// The corners after the first two may be collinear with them: the first one that is not gives the normal.
IntegerVec exact_normal(const PosedCore& core, int face) {
  const std::vector<int>& corners = core.faces()[static_cast<std::size_t>(face)];
  const IntegerVec& origin = core.exact(corners[0]);
  const IntegerVec first = core.exact(corners[1]) - origin;
  IntegerVec normal;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    normal = cross(first, core.exact(corners[i]) - origin);
    if (!is_zero(normal)) break;
  }
  return normal;
}

EnclosureVec enclosed_normal(const PosedCore& core, int face) {
  const std::vector<int>& corners = core.faces()[static_cast<std::size_t>(face)];
  const EnclosureVec& origin = core.enclosed(corners[0]);
  const EnclosureVec first = core.enclosed(corners[1]) - origin;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const EnclosureVec normal = cross(first, core.enclosed(corners[i]) - origin);
    if (surely_nonzero(normal)) return normal;
  }
  return enclosure(exact_normal(core, face));
}

}  // namespace touchstone::reference
