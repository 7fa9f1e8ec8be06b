#include "fast/penetration/exact_depth.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include "fast/mark.h"
#include "fast/penetration/triangulation.h"
#include "model/infinity.h"

namespace touchstone::fast::penetration {
namespace {

using exact::Difference;
using exact::Dyadic;
using exact::Vector;

class ExactSearch {
 public:
  explicit ExactSearch(Difference& difference) : difference_(difference) { start(); }

  /// Replaces the nearest face until it is a facet of B − A.
  ExactDepth run() {
    while (true) {
      const int face = nearest_face();
      const Plane& plane = planes_[static_cast<std::size_t>(face)];
      const Vector highest = support(plane.n);
      if (dot(plane.n, highest - corners_[first(face)]).sign() == 0) return result(plane);
      insert(highest, face);
    }
  }

 private:
  struct Plane {
    Vector n;  ///< outward, not of unit length
    double height = 0;
  };

  std::size_t first(int face) const { return static_cast<std::size_t>(surface_[face].corners[0]); }
  Vector support(const Vector& n) { return difference_(difference_.support(-n)); }

  /// The vertex farthest from the plane through p with the normal n, on either side.
  Vector off_plane(const Vector& n, const Vector& p) {
    const Vector above = support(n);
    return dot(n, above - p).sign() != 0 ? above : support(-n);
  }

  /// Four vertices that are not in one plane.
  void start() {
    const Vector x = exact::vector(Vec3::UnitX());
    corners_.push_back(support(x));
    corners_.push_back(off_plane(x, corners_[0]));
    const Vector along = corners_[1] - corners_[0];
    Vector side = cross(along, x);
    if (side.is_zero()) side = cross(along, exact::vector(Vec3::UnitY()));
    corners_.push_back(off_plane(side, corners_[0]));
    const Vector n = cross(along, corners_[2] - corners_[0]);
    corners_.push_back(off_plane(n, corners_[0]));
    if (dot(n, corners_[3] - corners_[0]).sign() > 0) std::swap(corners_[1], corners_[2]);
    surface_.start();
    planes_.resize(4);
    for (int face = 0; face < 4; ++face) set_plane(face);
  }

  void set_plane(int face) {
    const auto [p, q, r] = surface_[face].corners;
    const auto at = [&](int i) -> const Vector& { return corners_[static_cast<std::size_t>(i)]; };
    Plane& plane = planes_[static_cast<std::size_t>(face)];
    plane.n = cross(at(q) - at(p), at(r) - at(p));
    const Dyadic times = dot(plane.n, at(p)), D = difference_.denominator();
    const double height = exact::root_of_ratio(times * times, dot(plane.n, plane.n) * D * D);
    plane.height = times.sign() < 0 ? -height : height;
  }

  int nearest_face() const {
    int nearest = 0;
    double least = infinity;
    for (int face = 0; face < surface_.size(); ++face) {
      const double height = planes_[static_cast<std::size_t>(face)].height;
      if (!surface_[face].is_dead && height < least) nearest = face, least = height;
    }
    return nearest;
  }

  /// The polytope is convex, so the faces that see w are connected, those with w in their plane included.
  void insert(const Vector& w, int from) {
    mark(Mark::depth_exact);
    const auto is_visible = [&](int face) {
      return dot(planes_[static_cast<std::size_t>(face)].n, w - corners_[first(face)]).sign() >= 0;
    };
    const std::vector<int>& fresh = surface_.insert(static_cast<int>(corners_.size()), from, is_visible);
    corners_.push_back(w);
    planes_.resize(static_cast<std::size_t>(surface_.size()));
    for (const int face : fresh) set_plane(face);
  }

  static ExactDepth result(const Plane& plane) {
    if (!std::isfinite(plane.height)) throw std::range_error("the depth is beyond the range of doubles");
    const double depth = std::max(0.0, plane.height);
    return {{depth * (1 - 0x1p-48), std::nextafter(depth * (1 + 0x1p-48), infinity)},
            exact::direction(plane.n).normalized()};
  }

  Difference& difference_;
  std::vector<Vector> corners_;
  Triangulation surface_;
  std::vector<Plane> planes_;  ///< by triangle
};

}  // namespace

ExactDepth exact_depth(Difference& difference) { return ExactSearch(difference).run(); }

}  // namespace touchstone::fast::penetration
