// Converts scenes to ODE's types.
#pragma once

#include <ode/ode.h>

#include <array>
#include <string>

#include "oracle/subjects/common/customary_domain.h"
#include "oracle/subjects/common/impact_input.h"

namespace touchstone::oracle::subjects::in_ode {

inline constexpr bool is_double = sizeof(dReal) == sizeof(double);

/// dWorldQuickStep takes constraints in an order of random numbers. From one seed the same question has the same
/// answer.
inline void start_random_numbers() { dRandSetSeed(0); }

inline dReal real(double x) { return static_cast<dReal>(x); }

inline std::array<dReal, 4> turn(const Eigen::Quaterniond& q) {
  return {real(q.w()), real(q.x()), real(q.y()), real(q.z())};
}

/// Mass properties about the centre of mass; for a body with a density, ODE computes them.
inline dMass mass_of(const Body& body) {
  dMass mass;
  if (const auto* given = std::get_if<MassProperties>(&body.mass)) {
    const Mat3& I = given->I_BBcm_B;
    dMassSetParameters(&mass, real(given->mass), 0, 0, 0, real(I(0, 0)), real(I(1, 1)), real(I(2, 2)), real(I(0, 1)),
                       real(I(0, 2)), real(I(1, 2)));
    return mass;
  }
  const dReal density = real(std::get<Density>(body.mass).value);
  if (const auto* sphere = std::get_if<Sphere>(&body.shape)) {
    dMassSetSphere(&mass, density, real(sphere->radius));
  } else {
    const Vec3 sides = 2 * std::get<Box>(body.shape).half_extents;
    dMassSetBox(&mass, density, real(sides.x()), real(sides.y()), real(sides.z()));
  }
  return mass;
}

/// Makes a body at its centre of mass, with its velocity, but without its mass.
inline dBodyID put(dWorldID world, const Body& body) {
  const dBodyID made = dBodyCreate(world);
  const Pose X = centre_of_mass(body);
  dBodySetPosition(made, real(X.p_WB.x()), real(X.p_WB.y()), real(X.p_WB.z()));
  dBodySetQuaternion(made, turn(rotation(X.q_WB)).data());
  const Vec3 &v = body.velocity.v_WBcm, &w = body.velocity.w_WB;
  dBodySetLinearVel(made, real(v.x()), real(v.y()), real(v.z()));
  dBodySetAngularVel(made, real(w.x()), real(w.y()), real(w.z()));
  return made;
}

inline Velocity velocity_of(dBodyID body) {
  if (body == nullptr) return {};
  const dReal *v = dBodyGetLinearVel(body), *w = dBodyGetAngularVel(body);
  return {{v[0], v[1], v[2]}, {w[0], w[1], w[2]}};
}

inline dGeomID geom(dSpaceID space, const Sphere& sphere) { return dCreateSphere(space, real(sphere.radius)); }

inline dGeomID geom(dSpaceID space, const Box& box) {
  const Vec3 sides = 2 * box.half_extents;
  return dCreateBox(space, real(sides.x()), real(sides.y()), real(sides.z()));
}

inline const std::string no_hulls = "ODE's convex wants planes that its user computes";

/// The card of a subject that uses ODE. The first call initialises ODE, once in a process.
inline Card card(const std::string& name, const std::string& about) {
  struct Library {
    Library() { dInitODE(); }
    ~Library() { dCloseODE(); }
  };
  static const Library library;
  Card card;
  card.name = "ode." + name;
  card.version = dODE_VERSION;
  card.precision = is_double ? Precision::binary64 : Precision::binary32;
  card.about = about;
  card.homepage = "https://ode.org";
  card.domain = customary_domain();
  return card;
}

}  // namespace touchstone::oracle::subjects::in_ode
