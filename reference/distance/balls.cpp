#include "reference/distance/balls.h"

#include <optional>

namespace touchstone::reference {
namespace {

/// A rational common point of one or two balls. If two balls intersect and neither contains the other's centre, the
/// point on the line of centres with equal power to both is in both.
std::optional<Triple> common_point(const std::vector<Ball>& balls) {
  const Triple& a = balls.front().centre;
  const Triple& b = balls.back().centre;
  const mpq_class& x = balls.front().squared_radius;
  const mpq_class& y = balls.back().squared_radius;
  const Triple ba = minus(a, b);
  const mpq_class D = dot(ba, ba);
  if (D <= y) return a;
  if (D <= x) return b;
  const mpq_class beyond = D - x - y;  // they intersect if √D ≤ √x + √y, that is D − x − y ≤ 2√(xy)
  if (beyond > 0 && beyond * beyond > 4 * x * y) return std::nullopt;
  return plus(b, mpq_class((D - x + y) / (2 * D)), ba);
}

/// Tests within the flat that is orthogonal to `left_out`, which are orthogonal to each other.
bool within_flat(const std::vector<Ball>& balls, const std::vector<HalfSpace>& sides, std::vector<Triple> left_out) {
  const std::optional<Triple> q = common_point(balls);
  if (!q) return false;
  bool in_all = true;
  for (const HalfSpace& side : sides) {
    if (dot(side.normal, *q) <= side.offset) continue;
    in_all = false;
    Triple along = side.normal;  // the plane's normal within the flat
    for (const Triple& n : left_out) along = plus(along, mpq_class(-dot(side.normal, n) / dot(n, n)), n);
    const mpq_class squared = dot(along, along);
    if (squared == 0) return false;  // the whole flat is outside the half-space
    std::vector<Ball> cut;
    for (const Ball& ball : balls) {
      const mpq_class gap = side.offset - dot(side.normal, ball.centre);
      cut.push_back(
          {plus(ball.centre, mpq_class(gap / squared), along), mpq_class(ball.squared_radius - gap * gap / squared)});
    }
    if (cut.front().squared_radius < 0 || cut.back().squared_radius < 0) continue;
    left_out.push_back(along);
    if (within_flat(cut, sides, left_out)) return true;
    left_out.pop_back();
  }
  return in_all;
}

}  // namespace

bool have_common_point(const std::vector<Ball>& balls, const std::vector<HalfSpace>& sides) {
  return within_flat(balls, sides, {});
}

}  // namespace touchstone::reference
