#include "fast/exact/nearest.h"

#include <array>
#include <cmath>
#include <optional>

#include "fast/exact/surrounded.h"
#include "fast/mark.h"

namespace touchstone::fast::exact {
namespace {

using Points = std::vector<Vector>;

/// The point y of aff(points) nearest to 0 by its weights, which do not yet sum to 1: y Σ weights = Σ weights · points.
/// `toward` is a positive multiple of y, or 0.
struct Projection {
  std::vector<Dyadic> weights;
  Vector toward;
};

Projection project_on_line(const Vector& p, const Vector& q) {
  const Vector e = q - p;
  const Dyadic at_p = dot(q, e);
  const Dyadic at_q = -dot(p, e);
  return {{at_p, at_q}, at_p * p + at_q * q};
}

Projection project_on_plane(const Vector& p, const Vector& q, const Vector& r) {
  const Vector n = cross(q - p, r - p);
  const int side = dot(n, p).sign();
  return {{dot(cross(q, r), n), dot(cross(r, p), n), dot(cross(p, q), n)}, side == 0 ? Vector{} : side > 0 ? n : -n};
}

Projection project_in_space(const Points& p) {
  const Dyadic a = dot(p[1], cross(p[2], p[3]));
  const Dyadic b = -dot(p[0], cross(p[2], p[3]));
  const Dyadic c = dot(p[0], cross(p[1], p[3]));
  const Dyadic d = -dot(p[0], cross(p[1], p[2]));
  if (a.sign() >= 0) return {{a, b, c, d}, {}};
  return {{-a, -b, -c, -d}, {}};
}

Projection project(const Points& p) {
  switch (p.size()) {
    case 1:
      return {{Dyadic(1)}, p[0]};
    case 2:
      return project_on_line(p[0], p[1]);
    case 3:
      return project_on_plane(p[0], p[1], p[2]);
    default:
      return project_in_space(p);
  }
}

bool all_positive(const std::vector<Dyadic>& weights) {
  for (const Dyadic& w : weights) {
    if (w.sign() <= 0) return false;
  }
  return true;
}

bool none_beyond(const Vector& toward, const Vector& through, const Points& all) {
  for (const Vector& p : all) {
    if (dot(toward, p - through).sign() < 0) return false;
  }
  return true;
}

struct Held {
  std::vector<VertexPair> pairs;
  Points points;
};

Held subset(const Held& all, unsigned members) {
  Held some;
  for (std::size_t i = 0; i < all.pairs.size(); ++i) {
    if ((members >> i & 1U) == 0) continue;
    some.pairs.push_back(all.pairs[i]);
    some.points.push_back(all.points[i]);
  }
  return some;
}

/// Leaves the least set of points whose hull contains the point of the hull that is nearest to 0. That point is inside
/// the hull of exactly one such set, and the other points are not beyond the plane through it: the signs of these two
/// conditions find the set.
Projection reduce(Held& held) {
  const unsigned all = (1U << held.pairs.size()) - 1;
  for (int size = 1;; ++size) {
    for (unsigned members = 1; members <= all; ++members) {
      if (__builtin_popcount(members) != size) continue;
      Held some = subset(held, members);
      Projection found = project(some.points);
      if (!all_positive(found.weights) || !none_beyond(found.toward, some.points.front(), held.points)) continue;
      held = std::move(some);
      return found;
    }
  }
}

/// |y|² for the least set: y·p for any of its points p, as y is perpendicular to all their differences.
void set_squared(Nearest& answer, const Points& points) {
  Dyadic sum = 0;
  for (const Dyadic& w : answer.weights) sum = sum + w;
  Vector y;  // · sum
  for (std::size_t i = 0; i < points.size(); ++i) y = y + answer.weights[i] * points[i];
  answer.squared_times = dot(y, points.front());
  answer.squared_over = sum;
}

}  // namespace

Nearest nearest(Difference& difference, std::vector<VertexPair> start) {
  Held held;
  const auto hold = [&](const VertexPair& pair) {
    held.pairs.push_back(pair);
    held.points.push_back(difference(pair));
  };
  for (const VertexPair& pair : start) hold(pair);
  while (true) {
    Projection found = reduce(held);
    Nearest answer;
    answer.normal = found.toward;
    answer.pairs = held.pairs;
    answer.weights = found.weights;
    if (found.toward.is_zero()) {
      classify_contact(difference, answer);
      return answer;
    }
    const VertexPair beyond = difference.support(found.toward);
    if (dot(found.toward, difference(beyond) - held.points.front()).sign() >= 0) {
      set_squared(answer, held.points);
      return answer;
    }
    hold(beyond);
    mark(Mark::exact_step);
  }
}

}  // namespace touchstone::fast::exact
