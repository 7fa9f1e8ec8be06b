#include "fast/penetration.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <variant>

#include "fast/exact/nearest.h"
#include "fast/lin_canny/proximity.h"
#include "fast/penetration/depth_bracket.h"
#include "fast/penetration/exact_depth.h"
#include "fast/rounding.h"
#include "model/input_error.h"

namespace touchstone::fast {
namespace {

constexpr const char* no_depth_of_compounds = "the depth of a union of parts is not defined here";

using namespace lin_canny;
using penetration::DepthBracket;

// The width of a bracket in rounding errors ε: 4 of lo, 4 of hi, and less than 1 by which the search may end early. A
// wider one would allow a depth that is off by more than rounding.
constexpr double explained_by_rounding = 9;

struct PosedBody {
  PosedBody(const Solid& solid, const Pose& X_WB) : convex(solid.parts().front()), pose(X_WB) {}

  Convex core() const {
    Convex core = convex;
    core.radius = 0;
    return core;
  }
  bool is_point() const { return convex.core.vertex_count() == 1; }

  const Convex& convex;
  CachedPose pose;
};

/// The depth of cores with a common interior point, if doubles prove and bound it.
std::optional<DepthBracket> of_clear_overlap(const PosedBody& A, const PosedBody& B, penetration::DepthMemory& memory) {
  const Vec3& p_WO = A.pose.X_WB.p_WB;
  const PosedHull placed_A = posed_hull(A.convex, A.pose, p_WO), placed_B = posed_hull(B.convex, B.pose, p_WO);
  if (!fit_doubles(placed_A, placed_B)) return {};
  const DepthBracket found = depth_bracket(placed_A, placed_B, memory);
  const bool is_narrow = found.hi - found.lo <= explained_by_rounding * rounding(placed_A, placed_B);
  return found.lo > 0 && is_narrow ? std::optional(found) : std::nullopt;
}

exact::Difference difference_of(const PosedBody& A, const PosedBody& B) {
  return {{std::span(&A.pose.X_WB, 1), A.convex.core.vertices()},
          {std::span(&B.pose.X_WB, 1), B.convex.core.vertices()}};
}

/// Of cores that touch or overlap, exactly. Two points that are one have no direction: x.
DepthBracket exactly(const PosedBody& A, const PosedBody& B) {
  if (A.is_point() && B.is_point()) return {0, 0, 0, Vec3::UnitX()};
  exact::Difference difference = difference_of(A, B);
  const penetration::ExactDepth found = penetration::exact_depth(difference);
  return {found.depth.lo, found.depth.lo, found.depth.hi, found.n};
}

/// Whether the planes perpendicular to n, a unit vector from B to A, separate the cores by `gap`, within rounding.
bool separates(const PosedBody& A, const PosedBody& B, const Vec3& n, double gap) {
  const Vec3& p_WO = A.pose.X_WB.p_WB;
  const PosedHull placed_A = posed_hull(A.convex, A.pose, p_WO), placed_B = posed_hull(B.convex, B.pose, p_WO);
  if (!fit_doubles(placed_A, placed_B) || n.isZero(0)) return false;
  return penetration::height_along(placed_A, placed_B, n) <= 4 * rounding(placed_A, placed_B) - gap;
}

/// The negative distance of cores that are apart. Witness points that are nearly one, or far from the origin of W, give
/// no direction; the exact one does.
DepthBracket of_cores_apart(const PosedBody& A, const PosedBody& B, const Proximity& nearest) {
  Vec3 n = (nearest.p_WCa - nearest.p_WCb).stableNormalized();
  if (!separates(A, B, n, nearest.enclosure.lo)) {
    exact::Difference difference = difference_of(A, B);
    n = -exact::direction(exact::nearest(difference, {{0, 0}}).normal).normalized();
  }
  return {-nearest.enclosure.hi, -nearest.distance, -nearest.enclosure.lo, n};
}

}  // namespace

struct PenetrationPair::Kept {
  Solid A, B;
  penetration::DepthMemory memory;
};

PenetrationPair::PenetrationPair(const Shape& A, const Shape& B)
    : kept_(new Kept{Solid(A, Solid::Preparation::vertices), Solid(B, Solid::Preparation::vertices), {}}) {
  for (const auto& [shape, name] : {std::pair(&A, "A"), std::pair(&B, "B")}) {
    if (std::holds_alternative<Compound>(*shape)) throw InputError(name, no_depth_of_compounds);
  }
}

PenetrationPair::~PenetrationPair() = default;

PenetrationDepth PenetrationPair::at(const Pose& X_WA, const Pose& X_WB) {
  const PosedBody A(kept_->A, X_WA), B(kept_->B, X_WB);
  std::optional<DepthBracket> cores = of_clear_overlap(A, B, kept_->memory);
  PenetrationDepth found;
  found.answer.verdict = cores ? Verdict::overlapping : proximity(A.convex, A.pose, B.convex, B.pose).verdict;
  found.answer.depth = 0;
  if (found.answer.verdict != Verdict::overlapping) return found;

  const double radius = A.convex.radius + B.convex.radius;
  if (!cores && radius > 0) {
    const Proximity nearest = proximity(A.core(), A.pose, B.core(), B.pose);
    if (nearest.verdict == Verdict::separated) cores = of_cores_apart(A, B, nearest);
  }
  if (!cores) cores = exactly(A, B);
  if (!std::isfinite(cores->height + radius)) throw std::range_error("the depth is beyond the range of doubles");
  const double rounding = 4 * u * (std::abs(cores->height) + radius);
  found.enclosure = {std::max(0.0, cores->lo + radius - rounding), cores->hi + radius + rounding};
  found.answer.depth = std::clamp(cores->height + radius, found.enclosure.lo, found.enclosure.hi);
  found.answer.nhat_BA_W = cores->n;
  return found;
}

PenetrationDepth penetration_depth(const Scene& scene) {
  if (scene.bodies.size() < 2) throw InputError("bodies", "expected two");
  for (std::size_t i = 0; i < 2; ++i) {
    if (!std::holds_alternative<Compound>(scene.bodies[i].shape)) continue;
    throw InputError("bodies[" + std::to_string(i) + "].shape", no_depth_of_compounds);
  }
  const Body &A = scene.bodies[0], &B = scene.bodies[1];
  return PenetrationPair(A.shape, B.shape).at(A.X_WB, B.X_WB);
}

}  // namespace touchstone::fast
