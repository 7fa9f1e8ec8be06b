#include "fast/constraint/stepper_body.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "fast/motion/ballistic_motion.h"
#include "fast/motion/quaternion.h"
#include "fast/motion/steady_turn.h"
#include "model/input_error.h"

namespace touchstone::fast::constraint {
namespace {

motion::RigidBodyModel model_of(const Body& body, const std::string& place) {
  if (std::holds_alternative<Compound>(body.shape)) throw InputError(place + ".shape", "a compound; not stepped");
  return motion::RigidBodyModel(body);
}

/// The quaternion times a power of two: exactly the same rotation, and squares stay in range.
Quaternion about_1(const Quaternion& q) {
  const int exponent = -std::ilogb(std::max({std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)}));
  const auto scaled = [&](double x) { return std::scalbn(x, exponent); };
  return {scaled(q.w), scaled(q.x), scaled(q.y), scaled(q.z)};
}

}  // namespace

StepperBody::StepperBody(const Body& body, const std::string& place)
    : model_(model_of(body, place)),
      inverse_mass_(model_.is_fixed ? 0 : 1 / model_.mass),
      reach_(convex().reach + model_.p_BBcm.norm()),
      q_WB_(about_1(body.X_WB.q_WB)),
      twist_{body.velocity.v_WBcm, body.velocity.w_WB} {
  if (!is_fixed()) inverse_inertia_B_ = model_.I_BBcm_B.inverse();
  centre_ = lin_canny::rotation(q_WB_) * model_.p_BBcm + body.X_WB.p_WB;
  refresh();
}

bool StepperBody::is_ball() const {
  return std::holds_alternative<Sphere>(model_.shape) && model_.p_BBcm.isZero(0) &&
         model_.turning == motion::Turning::steady;
}

Pose StepperBody::pose() const { return {centre_ - R_WB_ * model_.p_BBcm, q_WB_}; }

contact::Part StepperBody::part() const {
  return contact::part_of(convex(), lin_canny::CachedPose(pose()), {centre_, R_WB_});
}

/// Rotates by the quaternion (1, angle/2). Its rotation angle equals |angle| to second order, and no sine is needed.
void StepperBody::turn(const Vec3& angle) {
  q_WB_ = motion::unit(motion::product({1, angle.x() / 2, angle.y() / 2, angle.z() / 2}, q_WB_));
}

void StepperBody::refresh() {
  R_WB_ = lin_canny::rotation(q_WB_);
  if (!is_fixed()) inverse_inertia_W_ = R_WB_ * inverse_inertia_B_ * R_WB_.transpose();
}

void StepperBody::advance(double h, const contact::Twist& twist, bool touched, const contact::Twist& shift) {
  centre_ += h * (touched || is_fixed() ? Vec3(twist.v + shift.v) : Vec3((twist_.v + twist.v) / 2));
  const motion::BallisticMotion free(model_, 0, {Vec3::Zero(), q_WB_}, {Vec3::Zero(), twist.w}, Vec3::Zero());
  const motion::Kinematics then = free.kinematics(h);
  q_WB_ = then.q_WB;
  twist_ = {twist.v, then.w_WB};
  if (!shift.w.isZero(0)) turn(h * shift.w);
  refresh();
}

void StepperBody::advance_evenly(double h, const contact::Twist& twist) {
  centre_ += h / 2 * (twist_.v + twist.v);
  const Vec3 mean = (twist_.w + twist.w) / 2 + h / 12 * twist.w.cross(twist_.w);
  q_WB_ = motion::unit(motion::product(motion::steady_turn(mean, h).q, q_WB_));
  twist_ = twist;
  refresh();
}

StepperBody StepperBody::moved(const Vec3& way) const {
  StepperBody moved = *this;
  moved.centre_ += way;
  return moved;
}

}  // namespace touchstone::fast::constraint
