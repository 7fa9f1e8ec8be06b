#include "fast/mass.h"

#include <Eigen/Geometry>
#include <numbers>
#include <variant>

#include "fast/lin_canny/rotation.h"
#include "fast/motion/spread.h"
#include "model/input_error.h"

namespace touchstone::fast {
namespace {

/// At unit density: volume, centroid, and ∫ (x − centroid)(x − centroid)ᵀ dV.
struct Solid {
  double volume = 0;
  Vec3 centroid = Vec3::Zero();
  Mat3 covariance = Mat3::Zero();
};

Solid solid(const Sphere& sphere) {
  const double r2 = sphere.radius * sphere.radius;
  const double volume = 4 * std::numbers::pi / 3 * sphere.radius * r2;
  return {volume, Vec3::Zero(), volume * r2 / 5 * Mat3::Identity()};
}

Solid solid(const Box& box) {
  const Vec3& h = box.half_extents;
  const double volume = 8 * h.x() * h.y() * h.z();
  return {volume, Vec3::Zero(), (volume / 3 * h.cwiseProduct(h)).asDiagonal()};
}

/// By tetrahedra from a point of the solid to the triangles of its faces. The volume may round to 0 or below.
Solid solid_about(const Polytope& polytope, const Vec3& inside) {
  double sixfold = 0;
  Vec3 moment = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  const auto corner = [&](int i) -> Vec3 { return polytope.vertices[static_cast<std::size_t>(i)] - inside; };
  for (const std::vector<int>& face : polytope.faces) {
    const Vec3 a = corner(face[0]);
    for (std::size_t k = 2; k < face.size(); ++k) {
      const Vec3 b = corner(face[k - 1]), c = corner(face[k]), s = a + b + c;
      const double det = a.dot(b.cross(c));
      sixfold += det;
      moment += det * s;
      second += det * (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
    }
  }
  const double volume = sixfold / 6;
  const Vec3 shift = moment / (4 * sixfold);
  return {volume, inside + shift, second / 120 - volume * shift * shift.transpose()};
}

/// About the mean of the vertices. In a sliver so thin that rounding leaves no volume, exactly.
Solid solid(const Polytope& polytope) {
  if (polytope.faces.empty()) throw InputError("shape.faces", "are missing: mass properties need them");
  Vec3 mean = Vec3::Zero();
  for (const Vec3& v : polytope.vertices) mean += v / static_cast<double>(polytope.vertices.size());
  const Solid found = solid_about(polytope, mean);
  if (found.volume > 0) return found;
  const motion::Spread exact = motion::exact_spread(polytope);
  return {exact.volume, exact.centroid, exact.C};
}

Solid solid(const Compound& compound) {
  std::vector<Solid> parts;
  Solid whole;
  for (const Part& part : compound.parts) {
    Solid posed = std::visit([](const auto& shape) { return solid(shape); }, part.shape);
    const Mat3 R = lin_canny::rotation(part.X_BP.q_WB);
    posed.centroid = R * posed.centroid + part.X_BP.p_WB;
    posed.covariance = R * posed.covariance * R.transpose();
    whole.volume += posed.volume;
    parts.push_back(posed);
  }
  for (const Solid& part : parts) whole.centroid += part.volume / whole.volume * part.centroid;
  for (const Solid& part : parts) {
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

std::optional<MassProperties> mass(const Shape&, const Fixed&) { return std::nullopt; }
std::optional<MassProperties> mass(const Shape&, const MassProperties& given) { return given; }
std::optional<MassProperties> mass(const Shape& shape, const Density& density) {
  const Solid whole = std::visit([](const auto& s) { return solid(s); }, shape);
  return MassProperties{density.value * whole.volume, whole.centroid, inertia(density.value, whole.covariance)};
}

}  // namespace

std::optional<MassProperties> mass(const Body& body) {
  return std::visit([&](const auto& kind) { return mass(body.shape, kind); }, body.mass);
}

Masses mass(const Scene& scene) {
  Masses all;
  all.reserve(scene.bodies.size());
  for (const Body& body : scene.bodies) all.push_back(mass(body));
  return all;
}

}  // namespace touchstone::fast
