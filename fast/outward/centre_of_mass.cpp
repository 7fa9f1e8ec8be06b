#include "fast/outward/centre_of_mass.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>
#include <vector>

#include "fast/exact/vector.h"
#include "fast/outward/outward.h"
#include "model/input_error.h"

namespace touchstone::fast::outward {
namespace {

using exact::Dyadic;
using exact::Vector;

/// Six times the volume (m³), and the centroid in multiples of `unit`.
struct Solid {
  Dyadic sixfold;
  Vec3 centroid = Vec3::Zero();
  double error = 0;
};

constexpr double quotient_error = 6 * u;  // exact/dyadic.h

Solid solid(const Sphere& sphere) {
  const Dyadic r(sphere.radius);
  return {Dyadic(8 * std::numbers::pi) * (r * r * r), Vec3::Zero(), 0};
}

Solid solid(const Box& box) {
  const Vec3& h = box.half_extents;
  return {Dyadic(48) * Dyadic(h.x()) * Dyadic(h.y()) * Dyadic(h.z()), Vec3::Zero(), 0};
}

/// 6 V = Σ det(a, b, c) over the faces' fans, 24 V centroid = Σ det(a, b, c) (a + b + c).
Solid solid(const Polytope& polytope) {
  if (polytope.faces.empty()) throw InputError("shape.faces", "are missing: the centre of mass needs them");
  const auto corner = [&](int i) { return exact::vector(polytope.vertices[static_cast<std::size_t>(i)]); };
  Dyadic sixfold;
  Vector moment;
  for (const std::vector<int>& face : polytope.faces) {
    const Vector a = corner(face[0]);
    for (std::size_t k = 2; k < face.size(); ++k) {
      const Vector b = corner(face[k - 1]);
      const Vector c = corner(face[k]);
      const Dyadic det = dot(a, cross(b, c));
      sixfold = sixfold + det;
      moment = moment + det * (a + b + c);
    }
  }
  if (sixfold.sign() <= 0) throw InputError("shape.faces", "bound no positive volume");
  const Dyadic times = Dyadic(4 * unit) * sixfold;
  const Vec3 centroid{exact::ratio(moment.x, times), exact::ratio(moment.y, times), exact::ratio(moment.z, times)};
  return {sixfold, centroid, quotient_error * centroid.lpNorm<Eigen::Infinity>() + underflow};
}

/// Σ V_k c_k / Σ V_k. A weight V_k/ΣV has an error of quotient_error and π's 2u (twice: it is in the sum too); a
/// product and the sum of n terms round by (n + 1)u: (n + 12)u of the greatest |c_k|, in addition to the parts' own
/// errors.
Solid solid(const Compound& compound) {
  Dyadic sixfold;
  std::vector<Solid> parts;
  for (const Part& part : compound.parts) {
    parts.push_back(std::visit([](const auto& s) { return solid(s); }, part.shape));
    sixfold = sixfold + parts.back().sixfold;
  }
  Solid whole{sixfold, Vec3::Zero(), 0};
  double greatest = 0;
  double worst = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const Motion X = motion(compound.parts[k].X_BP);
    const Vec3 centroid = X.R * parts[k].centroid + X.t;
    whole.centroid += exact::ratio(parts[k].sixfold, sixfold) * centroid;
    greatest = std::max(greatest, centroid.lpNorm<Eigen::Infinity>());
    worst = std::max(worst, place_error(X, parts[k].centroid.lpNorm<1>()) + 2 * parts[k].error);
  }
  whole.error = (static_cast<double>(parts.size()) + 16) * u * greatest + (1 + 32 * u) * worst;
  return whole;
}

std::optional<CentreOfMass> centre(const Shape&, const Fixed&) { return std::nullopt; }

std::optional<CentreOfMass> centre(const Shape&, const MassProperties& given) {
  return CentreOfMass{given.p_BBcm / unit, underflow, given.mass};
}

std::optional<CentreOfMass> centre(const Shape& shape, const Density& density) {
  const Solid whole = std::visit([](const auto& s) { return solid(s); }, shape);
  const double mass = exact::ratio(Dyadic(density.value) * whole.sixfold, Dyadic(6));
  return CentreOfMass{whole.centroid, whole.error, mass * (1 - 12 * u)};
}

}  // namespace

std::optional<CentreOfMass> centre_of_mass(const Body& body) {
  return std::visit([&](const auto& mass) { return centre(body.shape, mass); }, body.mass);
}

}  // namespace touchstone::fast::outward
