#include "fast/mass.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <variant>

#include "fast/lin_canny/rotation.h"
#include "fast/motion/spread.h"
#include "fast/rounding.h"
#include "model/input_error.h"

namespace touchstone::fast {
namespace {

/// At unit density: volume, centroid, and ∫ (x − centroid)(x − centroid)ᵀ dV, with about the errors of rounding.
struct SolidMass {
  double volume = 0;
  Vec3 centroid = Vec3::Zero();
  Mat3 covariance = Mat3::Zero();
  double volume_error = 8 * u;  ///< relative
  Vec3 centroid_error = Vec3::Zero();
  Mat3 covariance_error = 8 * u * covariance.cwiseAbs();
};

SolidMass solid(const Sphere& sphere) {
  const double r2 = sphere.radius * sphere.radius;
  const double volume = 4 * std::numbers::pi / 3 * sphere.radius * r2;
  return {volume, Vec3::Zero(), volume * r2 / 5 * Mat3::Identity()};
}

SolidMass solid(const Box& box) {
  const Vec3& h = box.half_extents;
  const double volume = 8 * h.x() * h.y() * h.z();
  return {volume, Vec3::Zero(), (volume / 3 * h.cwiseProduct(h)).asDiagonal()};
}

/// By tetrahedra from a point of the solid to the triangles of its faces. The volume may round to 0 or below.
SolidMass solid_about(const Polytope& polytope, const Vec3& inside) {
  double sixfold = 0, triangles = 0;
  Vec3 moment = Vec3::Zero(), h = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  const auto corner = [&](int i) -> Vec3 { return polytope.vertices[static_cast<std::size_t>(i)] - inside; };
  for (const std::vector<int>& face : polytope.faces) {
    const Vec3 a = corner(face[0]);
    h = h.cwiseMax(a.cwiseAbs()).cwiseMax(corner(face[1]).cwiseAbs());
    for (std::size_t k = 2; k < face.size(); ++k) {
      const Vec3 b = corner(face[k - 1]), c = corner(face[k]), s = a + b + c;
      h = h.cwiseMax(c.cwiseAbs());
      ++triangles;
      const double det = a.dot(b.cross(c));
      sixfold += det;
      moment += det * s;
      second += det * (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
    }
  }
  const double volume = sixfold / 6;
  const Vec3 shift = moment / (4 * sixfold);
  SolidMass found{volume, inside + shift, second / 120 - volume * shift * shift.transpose()};
  found.volume_error = 16 * u * std::sqrt(triangles) * h.prod() / volume;
  found.centroid_error = 2 * found.volume_error * h + u * found.centroid.cwiseAbs();
  found.covariance_error = volume * (2 * found.volume_error + 8 * u) * h * h.transpose();
  return found;
}

/// About the mean of the vertices. In a sliver so thin that rounding leaves no volume, exactly.
SolidMass solid(const Polytope& polytope) {
  if (polytope.faces.empty()) throw InputError("shape.faces", "are missing: mass properties need them");
  Vec3 mean = Vec3::Zero();
  for (const Vec3& v : polytope.vertices) mean += v / static_cast<double>(polytope.vertices.size());
  const SolidMass found = solid_about(polytope, mean);
  if (found.volume > 0) return found;
  const motion::Spread exact = motion::exact_spread(polytope).rounded;
  return {exact.volume, exact.centroid, exact.C};
}

/// Of a compound, from the errors of its parts and the sums.
void add_errors(SolidMass& whole, const std::vector<SolidMass>& parts) {
  whole.volume_error = 0;
  whole.covariance_error.setZero();
  for (const SolidMass& part : parts) {
    const double share = part.volume / whole.volume;
    const Vec3 off = (part.centroid - whole.centroid).cwiseAbs();
    whole.volume_error += share * (part.volume_error + 8 * u);
    whole.centroid_error +=
        share * (part.centroid_error + (part.volume_error + 8 * u) * off + 8 * u * part.centroid.cwiseAbs());
  }
  for (const SolidMass& part : parts) {
    const Vec3 off = (part.centroid - whole.centroid).cwiseAbs();
    const Vec3 off_error = part.centroid_error + whole.centroid_error;
    const Mat3 moved = off * off_error.transpose();
    whole.covariance_error += part.covariance_error + part.volume * (moved + moved.transpose()) +
                              part.volume * (part.volume_error + 8 * u) * off * off.transpose();
  }
}

SolidMass solid(const Compound& compound) {
  std::vector<SolidMass> parts;
  SolidMass whole;
  for (const Part& part : compound.parts) {
    SolidMass posed = std::visit([](const auto& shape) { return solid(shape); }, part.shape);
    const Mat3 R = lin_canny::rotation(part.X_BP.q_WB);
    const Mat3 of_each = R.cwiseAbs();  // R's own error, 12u, is in the constants
    posed.centroid_error = of_each * posed.centroid_error + Vec3::Constant(16 * u * posed.centroid.norm()) +
                           8 * u * part.X_BP.p_WB.cwiseAbs();
    posed.covariance_error =
        of_each * posed.covariance_error * of_each.transpose() + Mat3::Constant(64 * u * posed.covariance.norm());
    posed.centroid = R * posed.centroid + part.X_BP.p_WB;
    posed.covariance = R * posed.covariance * R.transpose();
    whole.volume += posed.volume;
    parts.push_back(posed);
  }
  for (const SolidMass& part : parts) whole.centroid += part.volume / whole.volume * part.centroid;
  add_errors(whole, parts);
  for (const SolidMass& part : parts) {
    const Vec3 off = part.centroid - whole.centroid;
    whole.covariance += part.covariance + part.volume * off * off.transpose();
  }
  return whole;
}

/// The result is exactly symmetric.
Mat3 inertia(double density, const Mat3& covariance) {
  Mat3 I = -density * covariance;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    I(i, i) = density * (covariance(j, j) + covariance(k, k));
    I(j, i) = I(i, j);
  }
  return I;
}

std::optional<RoundedMass> mass(const Shape&, const Fixed&) { return std::nullopt; }
std::optional<RoundedMass> mass(const Shape&, const MassProperties& given) { return RoundedMass{given}; }
std::optional<RoundedMass> mass(const Shape& shape, const Density& density) {
  const SolidMass whole = std::visit([](const auto& s) { return solid(s); }, shape);
  return RoundedMass{{density.value * whole.volume, whole.centroid, inertia(density.value, whole.covariance)},
                     whole.volume_error,
                     whole.centroid_error,
                     inertia(density.value, whole.covariance_error).cwiseAbs()};
}

}  // namespace

std::optional<RoundedMass> rounded_mass(const Body& body) {
  return std::visit([&](const auto& kind) { return mass(body.shape, kind); }, body.mass);
}

std::optional<MassProperties> mass(const Body& body) {
  if (const auto* given = std::get_if<MassProperties>(&body.mass)) return *given;
  const std::optional<RoundedMass> found = rounded_mass(body);
  return found ? std::optional(found->properties) : std::nullopt;
}

Masses mass(const Scene& scene) {
  Masses all;
  all.reserve(scene.bodies.size());
  for (const Body& body : scene.bodies) all.push_back(mass(body));
  return all;
}

}  // namespace touchstone::fast
