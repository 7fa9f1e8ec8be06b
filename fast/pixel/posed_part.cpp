#include "fast/pixel/posed_part.h"

#include <stdexcept>

#include "fast/outward/outward.h"
#include "model/box_vertices.h"

namespace touchstone::fast::pixel {
namespace {

Part part(const Sphere& sphere, std::vector<Pose> poses) { return {std::move(poses), sphere}; }
Part part(const Polytope& polytope, std::vector<Pose> poses) { return {std::move(poses), polytope}; }
Part part(const Box& box, std::vector<Pose> poses) { return {std::move(poses), as_polytope(box)}; }

std::vector<Part> parts(const auto& shape, const Pose& X_WB) { return {part(shape, {X_WB})}; }
std::vector<Part> parts(const Compound& compound, const Pose& X_WB) {
  std::vector<Part> all;
  for (const touchstone::Part& one : compound.parts) {
    all.push_back(std::visit([&](const auto& shape) { return part(shape, {X_WB, one.X_BP}); }, one.shape));
  }
  return all;
}

}  // namespace

std::vector<Part> parts_of(const Body& body) {
  return std::visit([&](const auto& shape) { return parts(shape, body.X_WB); }, body.shape);
}

// With u = 2^-53 and S = max ‖p‖₁ + the poses' offsets + the greatest coordinate on the raster, no coordinate exceeds
// S:
//   a posed vertex                        place_error ≤ 2·16 u S
//   a line or a centre of the grid        3 u S
//   a cut edge from p to q, at t = (line − p)/(q − p) and p + t (q − p), |q − p| ≤ 2S
//                                         t to 3u, so 2·3 u S; the product 2 u S, the sums 3 u S: 11 u S, four times
// Together < 80 u S; 128 leaves room for this bound's own rounding and for a sphere's radius and square roots.
PosedPart posed(const Part& part, const Grid& grid) {
  outward::Motion X = outward::motion(part.poses.front());
  if (part.poses.size() == 2) X = outward::composed(X, outward::motion(part.poses.back()));
  PosedPart made;
  double length = 0;
  const auto add = [&](const Vec3& p) {
    length = std::max(length, (p / outward::unit).lpNorm<1>());
    made.vertices.emplace_back((X.R * (p / outward::unit) + X.t) * outward::unit);
  };
  if (const auto* sphere = std::get_if<Sphere>(&part.shape)) {
    add(Vec3::Zero());
    made.radius = sphere->radius;
  } else {
    for (const Vec3& v : std::get<Polytope>(part.shape).vertices) add(v);
  }
  const double S = outward::unit * (length + X.offsets) + made.radius + grid.x.greatest() + grid.y.greatest();
  if (!(S < 0x1p1000)) throw std::range_error("lengths beyond 2^1000 m");
  made.error = 128 * u * S + outward::unit * outward::underflow;
  made.box = {made.vertices.front(), made.vertices.front()};
  for (const Vec3& v : made.vertices) made.box = {made.box.lo.cwiseMin(v), made.box.hi.cwiseMax(v)};
  const Vec3 more = Vec3::Constant(made.radius + made.error);
  made.box = {made.box.lo - more, made.box.hi + more};
  return made;
}

}  // namespace touchstone::fast::pixel
