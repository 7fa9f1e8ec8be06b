#include "fast/penetration/inner_polytope.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "fast/rounding.h"
#include "model/infinity.h"

namespace touchstone::fast::penetration {
namespace {

using lin_canny::PosedHull;
using lin_canny::VertexDifference;

// The squared sine of an angle of a triangle below which its normal is computed from the edges of the hulls. A choice:
// a larger one costs time, a smaller one precision of the normal, and then more steps.
constexpr double slender = 0x1p-10;

/// The solid angle of a triangle seen from 0 (van Oosterom & Strackee 1983), signed.
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double x = a.norm(), y = b.norm(), z = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)), x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y);
}

}  // namespace

void InnerPolytope::clear() {
  corners_.clear();
  surface_.clear();
}

void InnerPolytope::start(const PosedHull& A, const PosedHull& B, const std::array<VertexDifference, 4>& corners) {
  A_ = &A, B_ = &B;
  corners_.assign(corners.begin(), corners.end());
  if (edge(0, 1).cross(edge(0, 2)).dot(edge(0, 3)) > 0) std::swap(corners_[1], corners_[2]);
  surface_.start();
  planes_.resize(4);
  for (int face = 0; face < 4; ++face) set_plane(face);
}

void InnerPolytope::move(const PosedHull& A, const PosedHull& B) {
  A_ = &A, B_ = &B;
  for (VertexDifference& w : corners_) {
    w.p_a = A.vertex(w.a);
    w.w = B.vertex(w.b) - w.p_a;
  }
  for (int face = 0; face < surface_.size(); ++face) {
    if (!surface_[face].is_dead) set_plane(face);
  }
}

/// The edges of the hulls are subtracted before they are rotated: the corners themselves have rounding errors that are
/// large for short edges.
Vec3 InnerPolytope::edge(int tail, int head) const {
  const VertexDifference &p = corners_[static_cast<std::size_t>(tail)], &q = corners_[static_cast<std::size_t>(head)];
  Vec3 along = Vec3::Zero();
  if (p.b != q.b) along = B_->turned_out(B_->hull->vertex(q.b) - B_->hull->vertex(p.b));
  if (p.a != q.a) along -= A_->turned_out(A_->hull->vertex(q.a) - A_->hull->vertex(p.a));
  return along;
}

/// A triangle without a plane gets the direction of its middle, and the search does not continue from it.
void InnerPolytope::set_plane(int face) {
  const auto [p, q, r] = surface_[face].corners;
  const Vec3 from_p = corner(q) - corner(p), to_r = corner(r) - corner(p);
  Vec3 cross = from_p.cross(to_r);
  double squared = cross.squaredNorm();
  if (squared < slender * from_p.squaredNorm() * to_r.squaredNorm()) {
    cross = edge(p, q).cross(edge(p, r));
    squared = cross.squaredNorm();
  }
  Plane& plane = planes_[static_cast<std::size_t>(face)];
  plane.is_final = !(squared > 0);
  plane.n =
      squared > 0 ? Vec3(cross * (1 / std::sqrt(squared))) : Vec3((corner(p) + corner(q) + corner(r)).normalized());
  plane.height = plane.n.dot(corner(p));
}

std::optional<int> InnerPolytope::nearest_face() const {
  std::optional<int> nearest;
  double least = infinity;
  for (int face = 0; face < surface_.size(); ++face) {
    if (surface_[face].is_dead || plane(face).is_final || !(plane(face).height < least)) continue;
    least = plane(face).height;
    nearest = face;
  }
  return nearest;
}

std::optional<double> InnerPolytope::insert(const VertexDifference& w, int from, double margin) {
  const auto is_visible = [&](int face) { return plane(face).n.dot(w.w) - plane(face).height > -margin; };
  const std::vector<int>& fresh = surface_.insert(corner_count(), from, is_visible);
  if (fresh.empty()) return {};
  corners_.push_back(w);
  planes_.resize(static_cast<std::size_t>(surface_.size()));
  double least = infinity;
  for (const int face : fresh) {
    set_plane(face);
    least = std::min(least, plane(face).height);
  }
  return least;
}

bool InnerPolytope::encloses_origin() const {
  double longest = 0;
  for (const VertexDifference& w : corners_) longest = std::max(longest, w.w.squaredNorm());
  const double rounding = 16 * u * longest * std::sqrt(longest);
  double sum = 0;
  bool all_positive = true;
  for (int face = 0; face < surface_.size() && all_positive; ++face) {
    if (surface_[face].is_dead) continue;
    const auto [p, q, r] = surface_[face].corners;
    all_positive = corner(p).dot(corner(q).cross(corner(r))) > rounding;
  }
  if (all_positive) return true;
  for (int face = 0; face < surface_.size(); ++face) {
    if (surface_[face].is_dead) continue;
    const auto [p, q, r] = surface_[face].corners;
    sum += solid_angle(corner(p), corner(q), corner(r));
  }
  return sum > 2 * std::numbers::pi;
}

double InnerPolytope::least_height() const {
  double least = infinity;
  for (int face = 0; face < surface_.size(); ++face) {
    if (surface_[face].is_dead) continue;
    for (const int i : surface_[face].corners) least = std::min(least, plane(face).n.dot(corner(i)));
  }
  return least;
}

}  // namespace touchstone::fast::penetration
