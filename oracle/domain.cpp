#include "oracle/domain.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "model/infinity.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/truth.h"

namespace touchstone::oracle {
namespace {

/// m: thickness and length, as the header defines them.
Interval extent(const Sphere& s) { return {2 * s.radius, 2 * s.radius}; }
Interval extent(const Box& b) { return {2 * b.half_extents.minCoeff(), 2 * b.half_extents.stableNorm()}; }
Interval extent(const Polytope& p) {
  const auto at = [&p](int i) { return p.vertices[static_cast<std::size_t>(i)]; };
  Interval found{infinity, 0};
  for (const Vec3& v : p.vertices) found.hi = std::max(found.hi, (v - p.vertices.front()).stableNorm());
  for (const std::vector<int>& face : p.faces) {
    Vec3 normal = Vec3::Zero();  // the sum of a fan of triangles, whose normals agree
    for (std::size_t k = 2; k < face.size(); ++k) {
      normal += (at(face[k - 1]) - at(face[0])).cross(at(face[k]) - at(face[0]));
    }
    normal.stableNormalize();
    double height = 0;
    for (const Vec3& v : p.vertices) height = std::max(height, normal.dot(at(face[0]) - v));
    found.lo = std::min(found.lo, height);
  }
  return found;
}

/// Of all parts: the least thickness, the greatest length, the greatest aspect, the most vertices.
struct Measures {
  Interval lengths{infinity, 0};
  double aspect = 0;
  std::size_t vertices = 0;

  template <class Shape>
  void add(const Shape& shape) {
    const Interval part = extent(shape);
    lengths = {std::min(lengths.lo, part.lo), std::max(lengths.hi, part.hi)};
    aspect = std::max(aspect, part.lo > 0 ? part.hi / part.lo : infinity);
    if constexpr (std::is_same_v<Shape, Polytope>) vertices = std::max(vertices, shape.vertices.size());
  }
  void add(const Compound& compound) {
    for (const Part& part : compound.parts) std::visit([this](const auto& shape) { add(shape); }, part.shape);
  }
};

Measures measures_of(const Scene& scene) {
  Measures measures;
  for (const Body& body : scene.bodies) std::visit([&](const auto& shape) { measures.add(shape); }, body.shape);
  return measures;
}

Interval lengths_of(const Body& body) {
  Measures measures;
  std::visit([&](const auto& shape) { measures.add(shape); }, body.shape);
  return measures.lengths;
}

/// Greatest speed and angular speed.
std::pair<double, double> speeds_of(const Scene& scene) {
  double speed = 0;
  double angular_speed = 0;
  for (const Body& body : scene.bodies) {
    speed = std::max(speed, body.velocity.v_WBcm.stableNorm());
    angular_speed = std::max(angular_speed, body.velocity.w_WB.stableNorm());
  }
  return {speed, angular_speed};
}

/// m/s: of the fastest point of a body; an estimate, since the radius is about its origin, not its centre of mass.
double fastest_point(const Scene& scene) {
  double fastest = 0;
  for (const Body& body : scene.bodies) {
    const double turning = body.velocity.w_WB.stableNorm() * tolerance::radius(body);
    fastest = std::max(fastest, body.velocity.v_WBcm.stableNorm() + turning);
  }
  return fastest;
}

/// A scene at rest, or one that gravity sets moving, has no lowest speed.
std::optional<std::string> too_slow(const std::optional<double>& limit, const Scene& scene) {
  if (!limit || !scene.gravity.isZero(0)) return std::nullopt;
  const double fastest = fastest_point(scene);
  if (fastest == 0 || fastest >= *limit) return std::nullopt;
  return fmt::format("the greatest speed of a point, {:.3g} m/s, is below {:.3g} m/s", fastest, *limit);
}

/// m: the scale, with the places of a sequence.
double reach_of(const Scene& scene) {
  double reach = tolerance::scale(scene);
  for (const SequenceFrame& frame : scene.frames) {
    for (const Placement& placement : frame) {
      if (!placement.X_WB) continue;
      const double size = tolerance::radius(scene.bodies[static_cast<std::size_t>(placement.body)]);
      reach = std::max(reach, placement.X_WB->p_WB.cwiseAbs().maxCoeff() + size);
    }
  }
  return reach;
}

std::optional<std::string> above(double value, const std::optional<double>& limit, const char* what) {
  if (!limit || value <= *limit) return std::nullopt;
  return fmt::format("{} {:.3g} is above {:.3g}", what, value, *limit);
}

std::optional<std::string> beyond_lengths(const Interval& limits, const Interval& lengths) {
  if (lengths.lo < limits.lo) return fmt::format("a thickness of {:.3g} m is below {:.3g} m", lengths.lo, limits.lo);
  return above(lengths.hi, limits.hi, "a length, m:");
}

bool limits_bodies(const Domain& domain) {
  return domain.lengths || domain.fixed_lengths || domain.aspect || domain.vertices;
}

std::optional<std::string> beyond_bodies(const Domain& domain, const Scene& scene) {
  for (const Body& body : scene.bodies) {
    const std::optional<Interval>& limits =
        is_fixed(body) && domain.fixed_lengths ? domain.fixed_lengths : domain.lengths;
    if (!limits) continue;
    if (auto why = beyond_lengths(*limits, lengths_of(body))) return why;
  }
  const Measures measures = measures_of(scene);
  if (auto why = above(measures.aspect, domain.aspect, "an aspect of")) return why;
  return above(static_cast<double>(measures.vertices), domain.vertices, "a number of vertices:");
}

}  // namespace

SceneSizes sizes_of(const Scene& scene) {
  const Measures measures = measures_of(scene);
  const auto [speed, angular_speed] = speeds_of(scene);
  return {.lengths = measures.lengths,
          .reach = reach_of(scene),
          .aspect = measures.aspect,
          .vertices = static_cast<int>(measures.vertices),
          .speed = speed,
          .angular_speed = angular_speed};
}

double mass_ratio(const Scene& scene) {
  Interval masses{infinity, 0};
  for (const auto& truth : truth::mass(scene)) {
    if (truth) masses = {std::min(masses.lo, truth->mass.lo), std::max(masses.hi, truth->mass.hi)};
  }
  return masses.hi > 0 ? masses.hi / masses.lo : 1;
}

std::optional<std::string> beyond(const Domain& domain, const Scene& scene) {
  if (domain.reach) {
    if (auto why = above(reach_of(scene), domain.reach, "a coordinate, m:")) return why;
  }
  const auto [speed, angular_speed] = speeds_of(scene);
  if (auto why = above(speed, domain.speed, "a speed, m/s:")) return why;
  if (auto why = above(angular_speed, domain.angular_speed, "an angular speed, rad/s:")) return why;
  if (auto why = too_slow(domain.lowest_speed, scene)) return why;
  if (limits_bodies(domain)) {
    if (auto why = beyond_bodies(domain, scene)) return why;
  }
  return domain.mass_ratio ? above(mass_ratio(scene), domain.mass_ratio, "a mass ratio of") : std::nullopt;
}

}  // namespace touchstone::oracle
