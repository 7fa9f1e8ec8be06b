#include "fast/lin_canny/solid.h"

#include <utility>
#include <variant>

#include "model/box_vertices.h"

namespace touchstone::fast::lin_canny {
namespace {

using Preparation = Solid::Preparation;

Convex unposed(Hull core, double radius) { return {std::move(core), radius, 0, false, {}, Mat3::Identity()}; }

Convex convex(const Sphere& sphere, Preparation) { return unposed(Hull(Vec3(Vec3::Zero())), sphere.radius); }
Convex convex(const Box& box, Preparation preparation) {
  return unposed(preparation == Preparation::whole ? Hull(box) : Hull::of_vertices(vertices_of(box)), 0);
}
Convex convex(const Polytope& polytope, Preparation preparation) {
  return unposed(preparation == Preparation::whole ? Hull(polytope) : Hull::of_vertices(polytope.vertices), 0);
}

Convex with_reach(Convex part) {
  part.reach = (part.core.radius() + part.radius + part.X_BP.p_WB.stableNorm()) * (1 + 8 * u);
  return part;
}

/// R_WB R_BP: rotation errors 12u each, and the product's rows of three products and two sums 3.1u · √3 · √3: < 34u;
/// then 5.2u for the product with a vertex: < 40u. R_WB p_BP: turn_error |p_BP|, and two sums.
constexpr double part_turn_error = 40 * u;

}  // namespace

Solid::Solid(const Shape& shape, Preparation preparation) {
  if (const auto* compound = std::get_if<Compound>(&shape)) {
    for (const Part& part : compound->parts) {
      Convex made = std::visit([&](const auto& s) { return convex(s, preparation); }, part.shape);
      made.X_BP = part.X_BP;
      made.R_BP = rotation(part.X_BP.q_WB);
      made.is_posed = true;
      parts_.push_back(with_reach(std::move(made)));
    }
    return;
  }
  std::visit(
      [&](const auto& s) {
        if constexpr (!std::is_same_v<std::decay_t<decltype(s)>, Compound>)
          parts_.push_back(with_reach(convex(s, preparation)));
      },
      shape);
}

PosedHull posed_hull(const Convex& part, const CachedPose& body, const Vec3& p_WO) {
  const Vec3 t = body.X_WB.p_WB - p_WO;
  const double shift_error = u * t.norm();
  if (!part.is_posed) return {&part.core, body.R_WB, t, turn_error, shift_error};
  const Vec3& p_BP = part.X_BP.p_WB;
  return {&part.core, body.R_WB * part.R_BP, t + body.R_WB * p_BP, part_turn_error,
          2 * (shift_error + turn_error * p_BP.norm())};
}

}  // namespace touchstone::fast::lin_canny
