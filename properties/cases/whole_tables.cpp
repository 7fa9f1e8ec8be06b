#include "properties/cases/whole_tables.h"

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace touchstone::properties {
namespace {

constexpr double filled = 0x1p-48;  // of the volume

struct Extent {
  Vec3 lo, hi;

  double volume() const { return (hi - lo).prod(); }
  bool overlaps(const Extent& other) const {
    return (lo.array() < other.hi.array() && other.lo.array() < hi.array()).all();
  }
};

std::optional<Extent> extent_of(const Part& part) {
  const auto* box = std::get_if<Box>(&part.shape);
  const Quaternion& q = part.X_BP.q_WB;
  if (box == nullptr || q.x != 0 || q.y != 0 || q.z != 0) return std::nullopt;
  return Extent{part.X_BP.p_WB - box->half_extents, part.X_BP.p_WB + box->half_extents};
}

std::optional<Box> box_filled_by(const Compound& compound) {
  std::vector<Extent> parts;
  Extent around{Vec3::Constant(std::numeric_limits<double>::infinity()),
                Vec3::Constant(-std::numeric_limits<double>::infinity())};
  double volume = 0;
  for (const Part& part : compound.parts) {
    const std::optional<Extent> extent = extent_of(part);
    if (!extent) return std::nullopt;
    for (const Extent& other : parts) {
      if (extent->overlaps(other)) return std::nullopt;
    }
    parts.push_back(*extent);
    around = {around.lo.cwiseMin(extent->lo), around.hi.cwiseMax(extent->hi)};
    volume += extent->volume();
  }
  const bool is_in_the_middle = (around.lo + around.hi).isZero(0);
  if (!is_in_the_middle || std::abs(volume - around.volume()) > filled * volume) return std::nullopt;
  return Box{(around.hi - around.lo) / 2};
}

}  // namespace

Scene with_whole_tables(const Scene& scene) {
  Scene whole = scene;
  for (Body& body : whole.bodies) {
    const auto* compound = std::get_if<Compound>(&body.shape);
    const std::optional<Box> box = compound && is_fixed(body) ? box_filled_by(*compound) : std::nullopt;
    if (box) body.shape = *box;
  }
  return whole;
}

}  // namespace touchstone::properties
