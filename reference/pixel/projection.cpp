#include "reference/pixel/projection.h"

#include <algorithm>
#include <array>

namespace touchstone::reference {
namespace {

using Point = std::array<mpq_class, 2>;

mpq_class turn(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Counter-clockwise hull (Andrew 1979); for a segment its two ends.
std::vector<Point> plane_hull(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Point> hull;
  const auto chain = [&](auto from, auto to) {
    const std::size_t base = hull.size();
    for (; from != to; ++from) {
      while (hull.size() >= base + 2 && turn(hull[hull.size() - 2], hull.back(), *from) <= 0) hull.pop_back();
      hull.push_back(*from);
    }
    hull.pop_back();  // the next chain starts with it
  };
  chain(points.begin(), points.end());
  chain(points.rbegin(), points.rend());
  return hull;
}

}  // namespace

Projection::Projection(const std::vector<Triple>& points) : empty_(points.empty()) {
  if (empty_) return;
  std::vector<Point> plane;
  for (const Triple& p : points) plane.push_back({p[0], p[1]});
  const auto by_y = [](const Point& p, const Point& q) { return p[1] < q[1]; };
  const auto [left, right] = std::minmax_element(plane.begin(), plane.end());
  const auto [low, high] = std::minmax_element(plane.begin(), plane.end(), by_y);
  add(1, 0, -(*left)[0]);
  add(-1, 0, (*right)[0]);
  add(0, 1, -(*low)[1]);
  add(0, -1, (*high)[1]);
  const std::vector<Point> hull = plane_hull(plane);
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point& p = hull[i];
    const Point& q = hull[(i + 1) % hull.size()];
    const mpq_class a = p[1] - q[1];
    const mpq_class b = q[0] - p[0];
    add(a, b, -a * p[0] - b * p[1]);
  }
}

void Projection::add(const mpq_class& a, const mpq_class& b, const mpq_class& c) {
  mpz_class common = a.get_den();
  common = lcm(common, b.get_den());
  common = lcm(common, c.get_den());
  const auto whole = [&](const mpq_class& x) { return mpz_class(x.get_num() * (common / x.get_den())); };
  sides_.push_back({whole(a), whole(b), whole(c)});
}

bool Projection::intersects(const Rectangle& square) const {
  const auto reaches = [&](const HalfPlane& side) {
    const long x = side.a > 0 ? square.x_hi : square.x_lo;
    const long y = side.b > 0 ? square.y_hi : square.y_lo;
    return side.a * x + side.b * y + side.c >= 0;
  };
  return !empty_ && std::all_of(sides_.begin(), sides_.end(), reaches);
}

}  // namespace touchstone::reference
