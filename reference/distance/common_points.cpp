#include "reference/distance/common_points.h"

namespace touchstone::reference {
namespace {

void add_ends_within(const Segment& edge, const std::vector<HalfSpace>& sides, std::vector<Triple>& points) {
  const Triple along = minus(edge.to, edge.from);
  mpq_class begin = 0;
  mpq_class end = 1;
  for (const HalfSpace& side : sides) {
    const mpq_class rise = dot(side.normal, along);
    const mpq_class room = side.offset - dot(side.normal, edge.from);
    if (rise == 0 && room < 0) return;
    if (rise == 0) continue;
    const mpq_class at = room / rise;
    if (rise > 0 && at < end) end = at;
    if (rise < 0 && at > begin) begin = at;
    if (begin > end) return;
  }
  points.push_back(plus(edge.from, begin, along));
  if (begin != end) points.push_back(plus(edge.from, end, along));
}

}  // namespace

std::vector<Triple> common_points(const Hull& A, const Hull& B) {
  std::vector<Triple> points;
  for (const Segment& edge : A.edges) add_ends_within(edge, B.sides, points);
  for (const Segment& edge : B.edges) add_ends_within(edge, A.sides, points);
  return points;
}

}  // namespace touchstone::reference
