// The normals n of all planes that separate A and B at a common point x form a cone. A − B has volume (unless both are
// points), so the cone's extreme rays are facet normals of A − B at 0: normals of a face of A through x, of a face of B
// through x, or the cross product of an edge of A and an edge of B, both through x. All of these are tried. The sum of
// those that separate lies in the cone's interior, so its plane contains only the least faces of A and B around x. If
// none separates, the bodies have common interior: they overlap.
#include "reference/distance/touching_only.h"

#include <algorithm>

#include "reference/hull/faces.h"

namespace touchstone::reference {
namespace {

/// The normals of the faces that contain x, and the edges between two such faces. An edge that only lies on a line
/// through x does no harm.
struct Neighbourhood {
  std::vector<IntegerVec> normals;
  std::vector<IntegerVec> edges;
};

/// x lies strictly between the vertices `around_x`, so a supporting plane contains x exactly if it contains all of
/// them.
Neighbourhood neighbourhood(const PosedCore& core, const std::vector<int>& around_x) {
  Neighbourhood here;
  const auto& faces = core.faces();
  std::vector<bool> holds_x(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const int face = static_cast<int>(f);
    const EnclosureVec around = enclosed_normal(core, face);
    const auto away = [&](int v) { return dot(around, core.enclosed(v) - core.enclosed(faces[f][0])).sup() < 0; };
    if (std::any_of(around_x.begin(), around_x.end(), away)) continue;
    const IntegerVec normal = exact_normal(core, face);
    const auto on = [&](int v) { return dot(normal, core.exact(v) - core.exact(faces[f][0])) == 0; };
    holds_x[f] = std::all_of(around_x.begin(), around_x.end(), on);
    if (holds_x[f]) here.normals.push_back(normal);
  }
  if (here.normals.empty()) return here;
  for (const Edge& e : edges_of(faces)) {
    if (holds_x[static_cast<std::size_t>(e.left)] && holds_x[static_cast<std::size_t>(e.right)]) {
      here.edges.push_back(core.exact(e.head) - core.exact(e.tail));
    }
  }
  return here;
}

bool none_below(const PosedCore& core, const IntegerVec& n, int from) {
  const EnclosureVec around = enclosure(n);
  for (int i = 0; i < core.size(); ++i) {
    if (side(core, n, around, i, from) < 0) return false;
  }
  return true;
}

std::vector<int> ties(const PosedCore& core, const IntegerVec& n, int from) {
  const EnclosureVec around = enclosure(n);
  std::vector<int> on;
  for (int i = 0; i < core.size(); ++i) {
    if (side(core, n, around, i, from) == 0) on.push_back(i);
  }
  return on;
}

}  // namespace

std::vector<IntegerVec> separating_normals(const PosedPair& pair, const std::vector<std::pair<int, int>>& pairs) {
  const int a = pairs[0].first;
  const int b = pairs[0].second;
  std::vector<int> around_x_A;
  std::vector<int> around_x_B;
  for (const auto& [i, j] : pairs) {
    around_x_A.push_back(i);
    around_x_B.push_back(j);
  }
  const Neighbourhood near_A = neighbourhood(pair.A, around_x_A);
  const Neighbourhood near_B = neighbourhood(pair.B, around_x_B);

  std::vector<IntegerVec> separating;
  const auto try_normal = [&](const IntegerVec& n) {
    if (is_zero(n) || dot(n, pair.difference(a, b)) != 0) return;
    if (none_below(pair.B, -n, b) && none_below(pair.A, n, a)) separating.push_back(n);
  };
  for (const IntegerVec& n : near_A.normals) try_normal(-n);
  for (const IntegerVec& n : near_B.normals) try_normal(n);
  for (const IntegerVec& e : near_A.edges) {
    for (const IntegerVec& f : near_B.edges) {
      const IntegerVec n = cross(e, f);
      try_normal(n);
      try_normal(-n);
    }
  }
  return separating;
}

std::optional<SupportingPlane> supporting_plane(const PosedPair& pair, const std::vector<std::pair<int, int>>& pairs) {
  if (pair.A.is_point() && pair.B.is_point()) return SupportingPlane{{1, 0, 0}, {0}, {0}};
  IntegerVec sum;
  for (const IntegerVec& n : separating_normals(pair, pairs)) sum = sum + n;
  if (is_zero(sum)) return std::nullopt;
  return SupportingPlane{sum, ties(pair.A, sum, pairs[0].first), ties(pair.B, sum, pairs[0].second)};
}

}  // namespace touchstone::reference
