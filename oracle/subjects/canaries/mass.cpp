// Canaries that lie about mass, centre of mass and inertia.
#include <Eigen/Geometry>
#include <algorithm>

#include "oracle/rotation.h"
#include "oracle/subjects/canaries/lie.h"

namespace touchstone::oracle::subjects {
namespace {

// Applies the lie to each movable body separately.
template <class OneLie>
Lies each(OneLie&& lie) {
  Lies lies;
  lies.mass = [lie](Subject&, const Scene& scene, Masses& said) {
    for (std::size_t i = 0; i < said.size(); ++i) {
      if (said[i]) lie(scene.bodies[i], *said[i]);
    }
  };
  return lies;
}

void inertia_of_box(const Body& body, MassProperties& said) {
  Eigen::AlignedBox3d box;
  for (const Vec3& corner : corners(body)) box.extend(corner);
  const Vec3 square = box.sizes().cwiseAbs2() * (said.mass / 12);
  said.I_BBcm_B = Vec3(square.y() + square.z(), square.z() + square.x(), square.x() + square.y()).asDiagonal();
}

void product_sign(const Body&, MassProperties& said) {
  said.I_BBcm_B = Mat3(2 * said.I_BBcm_B.diagonal().asDiagonal()) - said.I_BBcm_B;
}

void inertia_about_origin(const Body&, MassProperties& said) {
  const Vec3 c = said.p_BBcm;
  said.I_BBcm_B += said.mass * (c.squaredNorm() * Mat3::Identity() - c * c.transpose());
}

void inertia_in_world(const Body& body, MassProperties& said) {
  const Mat3 R_WB = rotation(body.X_WB.q_WB).toRotationMatrix();
  said.I_BBcm_B = R_WB * said.I_BBcm_B * R_WB.transpose();
}

// With C = ∫ r rᵀ dm the inertia is tr(C) 1 − C, so C = tr(I)/2 1 − I.
void covariance(const Body&, MassProperties& said) {
  said.I_BBcm_B = Mat3(said.I_BBcm_B.trace() / 2 * Mat3::Identity()) - said.I_BBcm_B;
}

double greatest_arm(const Body& body) {
  double greatest = 0;
  for (const Vec3& corner : corners(body)) greatest = std::max(greatest, corner.norm());
  return greatest;
}

// Of a box, 4 times what may be wrong.
void slightly_wrong(const Body& body, MassProperties& said) {
  const double arm = greatest_arm(body);
  said.mass *= 1 + 44 * rounding;
  said.p_BBcm.x() += 96 * rounding * arm;
  said.I_BBcm_B(0, 0) += 320 * rounding * said.mass * arm * arm;
}

void slightly_lopsided(const Body& body, MassProperties& said) {
  const double arm = greatest_arm(body);
  said.I_BBcm_B(1, 0) += 3000 * rounding * said.mass * arm * arm;
}

void density_ignored(const Body& body, MassProperties& said) {
  if (const Density* density = std::get_if<Density>(&body.mass)) {
    said.mass /= density->value;
    said.I_BBcm_B /= density->value;
  }
}

}  // namespace

std::vector<Canary> canaries_about_mass() {
  return {
      lying("canary.density_ignored", "takes every density for 1", [] { return each(density_ignored); }),
      lying("canary.centre_at_origin", "takes the body's origin for its centre of mass",
            [] { return each([](const Body&, MassProperties& said) { said.p_BBcm.setZero(); }); }),
      lying("canary.inertia_of_box", "gives the inertia of the bounding box", [] { return each(inertia_of_box); }),
      lying("canary.product_sign", "gives the products of inertia the other sign", [] { return each(product_sign); }),
      lying("canary.inertia_about_origin", "leaves the inertia about the body's origin",
            [] { return each(inertia_about_origin); }),
      lying("canary.inertia_in_world", "gives the inertia in the world's axes", [] { return each(inertia_in_world); }),
      lying("canary.covariance", "gives ∫ r rᵀ dm for the inertia", [] { return each(covariance); }),
      lying("canary.negative_mass", "sees every solid inside out",
            [] { return each([](const Body&, MassProperties& said) { said.mass = -said.mass; }); }),
      lying("canary.slightly_wrong_mass", "is wrong by four times what rounding explains of a box",
            [] { return each(slightly_wrong); }),
      lying("canary.slightly_lopsided", "has an inertia that is not symmetric, by a few thousand roundings",
            [] { return each(slightly_lopsided); }),
  };
}

}  // namespace touchstone::oracle::subjects
