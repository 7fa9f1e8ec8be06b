#include "app/overlap.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "app/body_name.h"
#include "fast/bounds.h"
#include "fast/broad_phase.h"
#include "fast/motion/quaternion.h"
#include "model/input_error.h"
#include "reference/exact_pose.h"
#include "reference/penetration.h"

namespace touchstone::app {
namespace {

/// Every convex part as a body of its own, and whose it is.
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

bool is_fixed(const Body& body) { return std::holds_alternative<Fixed>(body.mass); }

bool stand_as_written(const Scene& scene, std::size_t a, std::size_t b) {
  const std::vector<double>& since = scene.flight->since;
  if (since.empty() || since[a] == since[b]) return true;
  const Body& first = scene.bodies[since[a] < since[b] ? a : b];
  return is_fixed(first) && first.velocity == Velocity{};
}

bool asked(const Scene& scene, int a, int b) {
  const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
  return a != b && !(is_fixed(scene.bodies[i]) && is_fixed(scene.bodies[j])) && stand_as_written(scene, i, j);
}

/// Bodies with vertices alone, whose poses are not ours: what they are is what is written, and flat faces can be
/// written to touch exactly.
bool is_exact(const Body& body) {
  return std::holds_alternative<Box>(body.shape) || std::holds_alternative<Polytope>(body.shape);
}

double greatest_sum(const Aabb& box) { return box.lo.cwiseAbs().cwiseMax(box.hi.cwiseAbs()).sum(); }

/// How deep two others may be that are meant to touch (m). Who places a ball rounds a few times in each coordinate, by
/// u = 2⁻⁵³ of it; 32u of all of them is no less than what `fast` grants a ball (fast/simulation/meeting.h).
double rounding(const Aabb& a, const Aabb& b) { return 0x1p-48 * (greatest_sum(a) + greatest_sum(b)); }

struct Overlap {
  int a, b;
  double depth;
};

std::optional<Overlap> deepest(const Scene& scene) {
  const Parts parts = parts_of(scene);
  const Bounds boxes = fast::bounds(parts.scene);
  std::optional<Overlap> most;
  Scene pair;
  for (const auto& [p, q] : fast::overlapping_pairs(boxes)) {
    const auto i = static_cast<std::size_t>(p), j = static_cast<std::size_t>(q);
    const int a = parts.owner[i], b = parts.owner[j];
    if (!asked(scene, a, b)) continue;
    const Body &A = scene.bodies[static_cast<std::size_t>(a)], &B = scene.bodies[static_cast<std::size_t>(b)];
    const double touching = is_exact(A) && is_exact(B) ? 0 : rounding(boxes[i], boxes[j]);
    pair.bodies = {parts.scene.bodies[i], parts.scene.bodies[j]};
    const double depth = reference::penetration(pair).depth.lo;
    if (depth > touching && (!most || depth > most->depth)) most = {a, b, depth};
  }
  return most;
}

}  // namespace

void refuse_overlap(const Scene& scene) {
  const std::optional<Overlap> found = deepest(scene);
  if (!found) return;
  throw InputError(body_name(scene, found->a), fmt::format("overlaps {} at the start by {:.6g} m: move them apart",
                                                           body_name(scene, found->b), found->depth));
}

}  // namespace touchstone::app
