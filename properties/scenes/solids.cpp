#include "properties/scenes/solids.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace touchstone::properties {
namespace {

Vec3 at(const Eigen::Vector2i& corner, int times, double z) {
  return {static_cast<double>(corner.x()) * times, static_cast<double>(corner.y()) * times, z};
}

std::vector<Vec3> ring(const Polygon& polygon, int times, double z) {
  std::vector<Vec3> points;
  for (const Eigen::Vector2i& corner : polygon) points.push_back(at(corner, times, z));
  return points;
}

std::vector<int> counting(int from, int count) {
  std::vector<int> face;
  for (int i = 0; i < count; ++i) face.push_back(from + i);
  return face;
}

std::vector<int> counting_down(int from, int count) {
  std::vector<int> face = counting(from, count);
  std::ranges::reverse(face);
  return face;
}

}  // namespace

Polygon some_polygon(Random& random) {
  static const std::vector<Polygon> shapes = {
      {{-1, -1}, {2, -1}, {-1, 2}},
      {{-2, -1}, {1, -1}, {1, 2}},
      {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}},
      {{-2, -1}, {2, -1}, {2, 1}, {-2, 1}},
      {{1, 0}, {0, 1}, {-1, 0}, {0, -1}},
      {{-2, -1}, {2, -1}, {1, 1}, {-1, 1}},
      {{-1, -2}, {2, -1}, {2, 1}, {0, 2}, {-2, 1}},
      {{1, 0}, {1, 1}, {0, 1}, {-1, 0}, {-1, -1}, {0, -1}},
      {{2, -1}, {2, 1}, {1, 2}, {-1, 2}, {-2, 1}, {-2, -1}, {-1, -2}, {1, -2}},
  };
  Polygon polygon = random.pick(shapes);
  const int times = random.between(1, 2);
  for (Eigen::Vector2i& corner : polygon) corner *= times;
  return polygon;
}

Polygon lattice_circle(int n) {
  Polygon points;
  const int radius = static_cast<int>(std::sqrt(static_cast<double>(n))) + 1;
  for (int x = -radius; x <= radius; ++x) {
    for (int y = -radius; y <= radius; ++y) {
      if (x * x + y * y == n) points.emplace_back(x, y);
    }
  }
  // Counter-clockwise from the negative x axis: the lower half by increasing x, the upper half by decreasing x. Uses no
  // angles, so nothing is rounded.
  std::ranges::sort(points, [](const Eigen::Vector2i& a, const Eigen::Vector2i& b) {
    const bool a_low = a.y() < 0 || (a.y() == 0 && a.x() < 0), b_low = b.y() < 0 || (b.y() == 0 && b.x() < 0);
    if (a_low != b_low) return a_low;
    return a_low ? a.x() < b.x() : a.x() > b.x();
  });
  return points;
}

Polytope frustum(const Polygon& polygon, int bottom, double lo, int top, double hi) {
  const int n = static_cast<int>(polygon.size());
  Polytope solid{ring(polygon, bottom, lo), {counting_down(0, n), counting(n, n)}};
  for (const Vec3& v : ring(polygon, top, hi)) solid.vertices.push_back(v);
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    solid.faces.push_back({i, next, n + next, n + i});
  }
  return solid;
}

Polytope prism(const Polygon& polygon, double lo, double hi) { return frustum(polygon, 1, lo, 1, hi); }

Polytope pyramid(const Polygon& base, double lo, double hi) {
  const int n = static_cast<int>(base.size());
  Polytope solid{ring(base, 1, lo), {counting_down(0, n)}};
  solid.vertices.emplace_back(0, 0, hi);
  for (int i = 0; i < n; ++i) solid.faces.push_back({i, (i + 1) % n, n});
  return solid;
}

Polytope bipyramid(const Polygon& polygon, double lo, double hi) {
  const int n = static_cast<int>(polygon.size());
  Polytope solid{ring(polygon, 1, 0), {}};
  solid.vertices.emplace_back(0, 0, hi);
  solid.vertices.emplace_back(0, 0, lo);
  for (int i = 0; i < n; ++i) {
    solid.faces.push_back({i, (i + 1) % n, n});
    solid.faces.push_back({(i + 1) % n, i, n + 1});
  }
  return solid;
}

Polytope roof(double x0, double x1, double hi, const Vec3& base_lo, const Vec3& base_hi) {
  const double lo = base_lo.z();
  return {{{base_lo.x(), base_lo.y(), lo},
           {base_hi.x(), base_lo.y(), lo},
           {base_hi.x(), base_hi.y(), lo},
           {base_lo.x(), base_hi.y(), lo},
           {x0, 0, hi},
           {x1, 0, hi}},
          {{3, 2, 1, 0}, {0, 1, 5, 4}, {2, 3, 4, 5}, {1, 2, 5}, {3, 0, 4}}};
}

Polytope tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  Polytope solid{{a, b, c, d}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  if ((b - a).cross(c - a).dot(d - a) > 0) return solid;
  for (std::vector<int>& face : solid.faces) std::swap(face[1], face[2]);
  return solid;
}

Polytope block(const Vec3& lo, const Vec3& hi) {
  Polytope solid;
  for (int i = 0; i < 8; ++i) {
    solid.vertices.emplace_back((i & 1 ? hi : lo).x(), (i & 2 ? hi : lo).y(), (i & 4 ? hi : lo).z());
  }
  solid.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return solid;
}

Polytope mapped(Polytope polytope, const IntMat3& M) {
  const Mat3 map = M.cast<double>();
  for (Vec3& v : polytope.vertices) v = (map * v).eval();
  if (map.determinant() < 0) {
    for (std::vector<int>& face : polytope.faces) std::ranges::reverse(face);
  }
  return polytope;
}

Polytope shifted(Polytope polytope, const Vec3& t) {
  for (Vec3& v : polytope.vertices) v += t;
  return polytope;
}

IntMat3 some_axes(Random& random) {
  IntMat3 M = IntMat3::Zero();
  const int x = random.below(3);
  const int y = (x + random.between(1, 2)) % 3;
  M(x, 0) = random.sign();
  M(y, 1) = random.sign();
  M(3 - x - y, 2) = random.sign();
  return M;
}

IntMat3 some_shear(Random& random) {
  IntMat3 M = IntMat3::Identity();
  M(0, 2) = random.between(-1, 1);
  M(1, 2) = random.between(-1, 1);
  return M;
}

}  // namespace touchstone::properties
