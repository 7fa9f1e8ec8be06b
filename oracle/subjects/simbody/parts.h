// Helpers that all uses of Simbody share. Include only in files compiled as C++17, as Simbody's headers require.
#pragma once

#include <simbody/Simbody.h>

#include "oracle/subjects/simbody/stepper.h"

namespace touchstone::oracle::subjects::in_simbody {

using Stepper = SimTK::SemiExplicitEulerTimeStepper;

inline SimTK::Vec3 vector(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
inline Eigen::Vector3d vector(const SimTK::Vec3& v) { return {v[0], v[1], v[2]}; }

inline SimTK::MassProperties mass_of(const RigidBody& body) {
  const SimTK::Vec3 centre(0);
  if (const auto* I = std::get_if<Eigen::Matrix3d>(&body.moments)) {
    return {body.mass, centre, SimTK::Inertia((*I)(0, 0), (*I)(1, 1), (*I)(2, 2), (*I)(0, 1), (*I)(0, 2), (*I)(1, 2))};
  }
  if (const auto* ball = std::get_if<BallOf>(&body.moments)) {
    return {body.mass, centre, SimTK::UnitInertia::sphere(ball->radius)};
  }
  return {body.mass, centre, SimTK::UnitInertia::brick(vector(std::get<BrickOf>(body.moments).half_extents))};
}

/// Frames are at centres of mass, so that inertia need not be shifted; the ground's frame is the world frame.
inline SimTK::Transform frame_of(const RigidBody& body) {
  if (body.mass == 0) return {};
  const Eigen::Quaterniond& q = body.q_WB;
  return {SimTK::Rotation(SimTK::Quaternion(q.w(), q.x(), q.y(), q.z())), vector(body.p_WBcm)};
}

inline SimTK::MobilizedBody put(const RigidBody& body, SimTK::SimbodyMatterSubsystem& matter) {
  if (body.mass == 0) return matter.updGround();
  return SimTK::MobilizedBody::Free(matter.updGround(), SimTK::Body::Rigid(mass_of(body)));
}

inline void start(const RigidBody& body, const SimTK::MobilizedBody& mobilized, SimTK::State& state) {
  if (body.mass == 0) return;
  mobilized.setQToFitTransform(state, frame_of(body));
  mobilized.setUToFitVelocity(state, {vector(body.w_WB), vector(body.v_WBcm)});
}

inline Twist twist_of(const SimTK::MobilizedBody& body, const SimTK::State& state) {
  return {vector(body.getBodyOriginVelocity(state)), vector(body.getBodyAngularVelocity(state))};
}

}  // namespace touchstone::oracle::subjects::in_simbody
