#include "oracle/judge/words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace touchstone::oracle::words {
namespace {

std::string direction(const reference::Certificate& c) {
  return text(Vec3(c.direction.x.nearest(), c.direction.y.nearest(), c.direction.z.nearest()));
}

std::string vertex_pairs(const reference::Certificate& c) {
  std::string all;
  for (std::size_t i = 0; i < c.pairs.size(); ++i) {
    all += fmt::format("{}({}, {})", i == 0 ? "" : ", ", c.pairs[i].first, c.pairs[i].second);
    if (i < c.weights.size()) all += fmt::format(" × {}", c.weights[i].nearest());
  }
  return all;
}

}  // namespace

std::string text(double x) { return fmt::format("{}", x); }

std::string text(const Vec3& v) { return fmt::format("({}, {}, {})", v.x(), v.y(), v.z()); }

std::string text(const Interval& i) { return i.lo == i.hi ? text(i.lo) : fmt::format("[{}, {}]", i.lo, i.hi); }

std::string text(const Aabb& box) { return text(box.lo) + " to " + text(box.hi); }

std::string text(const Feature& feature) {
  return fmt::format("vertices {{{}}} of part {}", fmt::join(feature.vertices, ", "), feature.part);
}

std::string text(const PairSet& pairs) {
  std::string all = "{";
  for (const auto& [i, j] : pairs) all += fmt::format("{}({}, {})", all.size() == 1 ? "" : ", ", i, j);
  return all + "}";
}

std::string text(Verdict verdict) {
  switch (verdict) {
    case Verdict::separated:
      return "separated";
    case Verdict::touching:
      return "touching";
    case Verdict::overlapping:
      return "overlapping";
  }
  return "unknown";
}

std::string text(const reference::Certificate& c) {
  const std::string parts = c.part_A == 0 && c.part_B == 0 ? "" : fmt::format(" (parts {} and {})", c.part_A, c.part_B);
  switch (c.cores) {
    case Verdict::separated:
      return fmt::format(
          "cores apart{}: n = {} is the nearest difference a − b to 0. It is the mix of the vertex pairs {}, and "
          "n·(a − b) ≥ n·n for all vertices a of A and b of B.",
          parts, direction(c), vertex_pairs(c));
    case Verdict::touching:
      return fmt::format(
          "cores touch{}: n·(a − b) ≥ 0 with n = {} for all vertices a of A and b of B, so no interior point is "
          "common; "
          "the mix of the vertex pairs {} is 0, so a point is.",
          parts, direction(c), vertex_pairs(c));
    case Verdict::overlapping:
      return fmt::format(
          "cores overlap{}: the mix of the vertex pairs {} is 0 and their differences a − b span space, so 0 is inside "
          "A − B.",
          parts, vertex_pairs(c));
  }
  return "";
}

}  // namespace touchstone::oracle::words
