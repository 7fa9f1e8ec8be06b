#include "app/motion/overlap.h"

#include <optional>
#include <variant>
#include <vector>

#include "app/report/body_name.h"
#include "fast/bounds.h"
#include "fast/broad_phase.h"
#include "fast/motion/quaternion.h"
#include "fast/simulation/prediction/pair_time_of_impact.h"
#include "model/input_error.h"
#include "reference/exact_pose.h"
#include "reference/penetration.h"

namespace touchstone::app {
namespace {

/// Each convex part as a body of its own, and the index of the body that it belongs to.
struct Parts {
  Scene scene;
  std::vector<int> owner;
};

Vec3 nearest(const reference::RationalVec3& v) { return {v.x.nearest(), v.y.nearest(), v.z.nearest()}; }

Pose posed(const Pose& X_WB, const Pose& X_BP) {
  using namespace fast::motion;
  return {nearest(reference::in_world(X_WB, X_BP.p_WB)), product(unit(X_WB.q_WB), unit(X_BP.q_WB))};
}

Parts parts_of(const Scene& scene) {
  Parts parts;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    if (const auto* compound = std::get_if<Compound>(&body.shape)) {
      for (const auto& [X_BP, shape] : compound->parts) {
        Body& part = parts.scene.bodies.emplace_back();
        part.shape = std::visit([](const auto& convex) { return Shape(convex); }, shape);
        part.X_WB = posed(body.X_WB, X_BP);
      }
    } else {
      parts.scene.bodies.push_back(body);
    }
    parts.owner.resize(parts.scene.bodies.size(), static_cast<int>(i));
  }
  return parts;
}

bool stand_as_written(const Scene& scene, std::size_t a, std::size_t b) {
  const std::vector<double>& since = scene.motion->start_times;
  if (since.empty() || since[a] == since[b]) return true;
  const Body& first = scene.bodies[since[a] < since[b] ? a : b];
  return is_fixed(first) && first.velocity == Velocity{};
}

bool asked(const Scene& scene, int a, int b) {
  const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
  return a != b && !(is_fixed(scene.bodies[i]) && is_fixed(scene.bodies[j])) && stand_as_written(scene, i, j);
}

bool is_compound(const Body& body) { return std::holds_alternative<Compound>(body.shape); }

double greatest_sum(const Aabb& box) { return box.lo.cwiseAbs().cwiseMax(box.hi.cwiseAbs()).sum(); }

/// The depth (m) up to which two bodies count as touching. A user who wants balls to touch rounds each coordinate a few
/// times, by u = 2⁻⁵³ of it, and so does the placing of a part in the world. Hence 32u of all coordinates, which is no
/// less than the clearance of `fast` where it has closed forms. For all other pairs any depth is overlap, as in `fast`
/// and `reference`.
double touching(const Body& A, const Aabb& box_A, const Body& B, const Aabb& box_B) {
  using fast::simulation::BodyMotion;
  const bool as_written = !is_compound(A) && !is_compound(B) &&
                          !has_closed_form(BodyMotion(A, 0, Vec3::Zero()), BodyMotion(B, 0, Vec3::Zero()));
  return as_written ? 0 : 0x1p-48 * (greatest_sum(box_A) + greatest_sum(box_B));
}

struct Overlap {
  int a, b;
  double depth;
};

/// The first two bodies that overlap, with the depth of their deepest parts.
std::optional<Overlap> first_overlap(const Scene& scene) {
  const Parts parts = parts_of(scene);
  const Bounds boxes = fast::bounds(parts.scene);
  std::optional<Overlap> first;
  Scene pair;
  for (const auto& [p, q] : fast::overlapping_pairs(boxes)) {
    const auto i = static_cast<std::size_t>(p), j = static_cast<std::size_t>(q);
    const int a = parts.owner[i], b = parts.owner[j];
    if (!asked(scene, a, b) || (first && (a != first->a || b != first->b))) continue;
    pair.bodies = {parts.scene.bodies[i], parts.scene.bodies[j]};
    const double depth = reference::penetration(pair).depth.lo;
    if (!(depth > (first ? first->depth : 0))) continue;
    const Body &A = scene.bodies[static_cast<std::size_t>(a)], &B = scene.bodies[static_cast<std::size_t>(b)];
    if (depth > touching(A, boxes[i], B, boxes[j])) first = {a, b, depth};
  }
  return first;
}

}  // namespace

void refuse_overlap(const Scene& scene) {
  const std::optional<Overlap> found = first_overlap(scene);
  if (!found) return;
  throw InputError(body_name(scene, found->a), fmt::format("overlaps {} at the start by {:.6g} m: move them apart",
                                                           body_name(scene, found->b), found->depth));
}

}  // namespace touchstone::app
