#include "reference/bounds.h"

#include <gmpxx.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include "reference/exact/rational.h"
#include "reference/motion/plain_pose.h"

namespace touchstone::reference {
namespace {

/// Least and greatest value of row·p over the points p of the solid, in its own frame.
std::pair<mpq_class, mpq_class> extent(const Sphere& sphere, const Triple&) {
  return {mpq_class(-sphere.radius), mpq_class(sphere.radius)};  // a row of a rotation is a unit vector
}

std::pair<mpq_class, mpq_class> extent(const Box& box, const Triple& row) {
  const mpq_class reach = dot({abs(row[0]), abs(row[1]), abs(row[2])}, triple(box.half_extents));
  return {mpq_class(-reach), reach};
}

std::pair<mpq_class, mpq_class> extent(const Polytope& polytope, const Triple& row) {
  mpq_class least = dot(row, triple(polytope.vertices.front()));
  mpq_class greatest = least;
  for (const Vec3& v : polytope.vertices) {
    const mpq_class reach = dot(row, triple(v));
    if (reach < least) least = reach;
    if (reach > greatest) greatest = reach;
  }
  return {least, greatest};
}

template <class Solid>
ExactBox box_of(const Solid& solid, const Motion& X_WP) {
  ExactBox box;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [least, greatest] = extent(solid, X_WP.rows[i]);
    box.lo[i] = rational_of(least + X_WP.translation[i]);
    box.hi[i] = rational_of(greatest + X_WP.translation[i]);
  }
  return box;
}

ExactBox box_of(const Compound& compound, const Motion& X_WB) {
  std::optional<ExactBox> whole;
  for (const Part& part : compound.parts) {
    const Motion X_WP = composed(X_WB, motion(part.X_BP));
    const ExactBox box = std::visit([&](const auto& solid) { return box_of(solid, X_WP); }, part.shape);
    if (!whole) whole = box;
    for (std::size_t i = 0; i < 3; ++i) {
      whole->lo[i] = std::min(whole->lo[i], box.lo[i]);
      whole->hi[i] = std::max(whole->hi[i], box.hi[i]);
    }
  }
  return whole.value();
}

}  // namespace

ExactBox box(const Body& body) {
  const Motion X_WB = motion(body.X_WB);
  return std::visit([&](const auto& shape) { return box_of(shape, X_WB); }, body.shape);
}

std::vector<ExactBox> bounds(const Scene& scene) {
  std::vector<ExactBox> boxes;
  for (const Body& body : scene.bodies) boxes.push_back(box(body));
  return boxes;
}

}  // namespace touchstone::reference
