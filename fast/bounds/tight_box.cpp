#include "fast/bounds/tight_box.h"

#include <array>
#include <variant>

#include "fast/lin_canny/rotation.h"
#include "fast/outward/outward.h"

namespace touchstone::fast {
namespace {

using outward::Grower;

void list_climbs(const Compound& compound, std::vector<Climb>& climbs);

template <class Solid>
void list_climbs(const Solid&, std::vector<Climb>&) {}

void list_climbs(const Polytope& polytope, std::vector<Climb>& climbs) {
  climbs.emplace_back(std::make_shared<const lin_canny::Hull>(polytope));
}

void list_climbs(const Compound& compound, std::vector<Climb>& climbs) {
  for (const Part& part : compound.parts)
    std::visit([&](const auto& solid) { list_climbs(solid, climbs); }, part.shape);
}

/// The pose of a shape: X for its points, and the same as `poses` and R for the climb.
struct RigidTransform {
  outward::Motion X;
  std::span<const Pose> poses;
  Mat3 R;
};

template <class Solid>
void grow_next(Grower& grower, const Solid& solid, const RigidTransform& transform, std::vector<Climb>::iterator&) {
  grow(grower, solid, transform.X);
}

void grow_next(Grower& grower, const Polytope&, const RigidTransform& transform, std::vector<Climb>::iterator& next) {
  for (const int v : next->climb(transform.poses, transform.R)) grow(grower, next->hull().vertex(v), transform.X);
  ++next;
}

void grow_next(Grower& grower, const Compound& compound, const RigidTransform& body,
               std::vector<Climb>::iterator& next) {
  for (const Part& part : compound.parts) {
    const std::array<Pose, 2> poses{body.poses.front(), part.X_BP};
    const RigidTransform transform{composed(body.X, outward::motion(part.X_BP)), poses,
                                   body.R * lin_canny::rotation(part.X_BP.q_WB)};
    std::visit([&](const auto& solid) { grow_next(grower, solid, transform, next); }, part.shape);
  }
}

}  // namespace

TightBox::TightBox(const Shape& shape) : shape_(shape) {
  std::visit([&](const auto& solid) { list_climbs(solid, climbs_); }, shape_);
}

Aabb TightBox::at(const Pose& X_WB) {
  const RigidTransform transform{outward::motion(X_WB), {&X_WB, 1}, lin_canny::rotation(X_WB.q_WB)};
  Grower grower;
  auto next = climbs_.begin();
  std::visit([&](const auto& solid) { grow_next(grower, solid, transform, next); }, shape_);
  return grower.box();
}

}  // namespace touchstone::fast
