#include "oracle/subjects/common/cast.h"

#include <algorithm>
#include <cmath>

#include "oracle/subjects/common/impact_input.h"

namespace touchstone::oracle::subjects {
namespace {

/// Inertia about the centre of mass; none if the adapter cannot compute it.
std::optional<MassProperties> inertia(const Body& body) {
  if (const auto* given = std::get_if<MassProperties>(&body.mass)) return *given;
  MassProperties made;
  made.I_BBcm_B = Mat3::Identity();  // per unit mass; a sphere or a fixed body may have any multiple of 1
  if (is_fixed(body) || std::holds_alternative<Sphere>(body.shape)) return made;
  const auto* box = std::get_if<Box>(&body.shape);
  if (box == nullptr) return std::nullopt;
  const Vec3 squares = box->half_extents.cwiseAbs2();
  made.I_BBcm_B = Mat3((squares.sum() - squares.array()).matrix().asDiagonal());
  return made;
}

/// The angular velocity stays constant, and the rotation is about the origin of the shape.
bool turns_evenly(const Body& body) {
  if (body.velocity.w_WB.isZero(0)) return true;
  const std::optional<MassProperties> mass = inertia(body);
  if (!mass || !mass->p_BBcm.isZero(0)) return false;
  const Vec3 w_B = rotation(body.X_WB.q_WB).conjugate() * body.velocity.w_WB;
  return w_B.cross(mass->I_BBcm_B * w_B).isZero(0);
}

std::optional<Abstains> no_such_cast(const Scene& scene, bool may_turn) {
  if (!scene.motion || scene.bodies.size() != 2) return Abstains{"not two bodies with a motion"};
  if (has_compound(scene)) return no_compounds;
  const Motion& motion = *scene.motion;
  if (std::ranges::any_of(motion.start_times, [](double time) { return time != 0; }))
    return Abstains{"start times other than 0 are not offered"};
  if (!motion.forces.empty()) return Abstains{"only casts along straight lines are offered"};
  const bool together = is_fixed(scene.bodies[0]) == is_fixed(scene.bodies[1]);  // gravity on both: no relative one
  if (!together && !scene.gravity.isZero(0)) return Abstains{"only casts along straight lines are offered"};
  for (const Body& body : scene.bodies) {
    if (!may_turn && !body.velocity.w_WB.isZero(0)) return Abstains{"only casts without rotation are offered"};
    if (!turns_evenly(body))
      return Abstains{"only casts with a constant angular velocity about the shape's origin are offered"};
  }
  return std::nullopt;
}

Pose pose_at(const Body& body, double time) {
  const Vec3& w = body.velocity.w_WB;
  const double rate = w.norm();
  Pose at{body.X_WB.p_WB + time * body.velocity.v_WBcm, body.X_WB.q_WB};
  if (rate == 0) return at;
  const Eigen::Quaterniond q = Eigen::AngleAxisd(rate * time, w / rate) * rotation(body.X_WB.q_WB);
  at.q_WB = {q.w(), q.x(), q.y(), q.z()};
  return at;
}

}  // namespace

Answer<TimeOfImpact> cast_along(const Scene& scene, bool may_turn, const Cast& cast) {
  if (const auto declined = no_such_cast(scene, may_turn)) return *declined;
  const Body &A = scene.bodies[0], &B = scene.bodies[1];
  const double end = scene.motion->sample_times.back();
  const double rate = std::max(A.velocity.w_WB.norm(), B.velocity.w_WB.norm());
  const double ways = std::max(1.0, std::ceil(2 * rate * end)), length = end / ways;
  if (ways > 100'000) return Abstains{"the bodies rotate too often during the motion"};
  TimeOfImpact said;
  said.status = TimeOfImpact::Status::miss;
  for (double i = 0; i < ways; ++i) {
    const double from = i * length, to = (i + 1) * length;
    const auto part = cast({pose_at(A, from), pose_at(A, to), pose_at(B, from), pose_at(B, to)});
    if (!part) continue;
    said.status = TimeOfImpact::Status::hit;
    said.time = from + *part * length;
    break;
  }
  return said;
}

}  // namespace touchstone::oracle::subjects
