#include "properties/judging/declared_boxes.h"

#include <algorithm>

#include "model/box_vertices.h"
#include "model/infinity.h"
#include "oracle/truth/truth.h"

namespace touchstone::properties {
namespace {

// The box from lo to hi, which need not have its middle at the origin.
Polytope box_from(const Vec3& lo, const Vec3& hi) {
  Polytope box = as_polytope(Box{Vec3::Ones()});
  for (Vec3& v : box.vertices) v = (v.array() < 0).select(lo, hi);
  return box;
}

Polytope box_about(const Polytope& p) {
  Vec3 lo = p.vertices.front(), hi = lo;
  for (const Vec3& v : p.vertices) lo = lo.cwiseMin(v), hi = hi.cwiseMax(v);
  return box_from(lo, hi);
}

// About the least boxes of the parts, in the axes of the body, where each hull counts as the box about it. Rounded
// outward.
Polytope box_about(const Compound& compound) {
  Scene parts;
  for (const Part& part : compound.parts) {
    Body& body = parts.bodies.emplace_back();
    const Polytope* hull = std::get_if<Polytope>(&part.shape);
    body.shape =
        hull ? Shape(box_about(*hull)) : std::visit([](const auto& shape) { return Shape(shape); }, part.shape);
    body.X_WB = part.X_BP;
  }
  Vec3 lo = Vec3::Constant(infinity), hi = -lo;
  for (const reference::ExactBox& box : oracle::truth::bounds(parts)) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<Eigen::Index>(axis);
      lo[i] = std::min(lo[i], box.lo[axis].enclosure().lo);
      hi[i] = std::max(hi[i], box.hi[axis].enclosure().hi);
    }
  }
  return box_from(lo, hi);
}

Polytope box_about(const Box& box) { return as_polytope(box); }
Polytope box_about(const Sphere& sphere) { return as_polytope(Box{Vec3::Constant(sphere.radius)}); }

// The factor covers the rounding of the radius and of the centre, of a few ulps each.
Compound ball_about(const Polytope& box) {
  const Vec3 &lo = box.vertices.front(), &hi = box.vertices.back();
  const Vec3 centre = lo / 2 + hi / 2;
  double radius = 0;
  for (const Vec3& v : box.vertices) radius = std::max(radius, (v - centre).norm());
  Part ball;
  ball.X_BP.p_WB = centre;
  ball.shape = Sphere{radius * (1 + 0x1p-49)};
  return {{ball}};
}

}  // namespace

Scene boxed(Scene scene, oracle::BoxKind kind) {
  if (kind == oracle::BoxKind::tight) return scene;
  for (Body& body : scene.bodies) {
    if (kind == oracle::BoxKind::of_ball) {
      body.shape = ball_about(std::visit([](const auto& shape) { return box_about(shape); }, body.shape));
      continue;
    }
    if (const Polytope* hull = std::get_if<Polytope>(&body.shape)) body.shape = Shape(box_about(*hull));
    if (const Compound* compound = std::get_if<Compound>(&body.shape)) body.shape = Shape(box_about(*compound));
  }
  return scene;
}

bool is_free(bool least_apart, double declared_gap, double reach, const oracle::Card& card) {
  const double rounding = reach - margin_of_a_pair(card);
  const bool settled = card.boxes != oracle::BoxKind::of_ball && declared_gap < -rounding;
  return least_apart && !settled && declared_gap <= reach;
}

}  // namespace touchstone::properties
