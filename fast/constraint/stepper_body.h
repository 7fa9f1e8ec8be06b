// One body of the time stepper: its state, and how it moves once its new velocities are known.
#pragma once

#include "fast/contact/part.h"
#include "fast/contact/row.h"
#include "fast/motion/rigid_body_model.h"
#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::fast::constraint {

class StepperBody {
 public:
  /// Throws InputError for a compound.
  StepperBody(const Body& body, const std::string& place);

  bool is_fixed() const { return inverse_mass_ == 0; }
  /// A sphere with its centre of mass in the middle, which turns steadily.
  bool is_ball() const;
  bool moves() const { return !twist_.v.isZero(0) || !twist_.w.isZero(0); }
  double inverse_mass() const { return inverse_mass_; }
  double mass() const { return 1 / inverse_mass_; }
  contact::Mobility mobility() const { return {inverse_mass_, inverse_inertia_W_}; }
  const Vec3& centre() const { return centre_; }
  const contact::Twist& twist() const { return twist_; }
  const lin_canny::Solid& solid() const { return model_.solid; }
  Pose pose() const;
  contact::Part part() const;
  State state() const { return {pose(), {twist_.v, twist_.w}}; }
  double reach() const { return reach_; }  ///< m; no point of the body is farther from the centre of mass

  /// Sets the twist and advances by h. A body with contact impulses moves with `twist` plus `shift`; one without moves
  /// with the mean of its old and new velocity, exactly on its parabola. It rotates as a free body does from its new
  /// angular velocity (fast/motion/ballistic_motion.h), so that even a fast-spinning needle keeps its energy.
  void advance(double h, const contact::Twist& twist, bool touched, const contact::Twist& shift);
  /// Likewise for a ball under constant forces, whether it touches something or not: with the mean of its old and new
  /// velocity, and by the first two terms of Magnus's series for an angular velocity that changes at a constant rate.
  void advance_evenly(double h, const contact::Twist& twist);
  /// This body moved by `way`.
  StepperBody moved(const Vec3& way) const;

 private:
  const lin_canny::Convex& convex() const { return model_.solid.parts().front(); }
  void turn(const Vec3& angle);
  void refresh();

  motion::RigidBodyModel model_;
  double inverse_mass_ = 0;
  double reach_ = 0;
  Mat3 inverse_inertia_B_ = Mat3::Zero();
  Vec3 centre_;
  Quaternion q_WB_;
  contact::Twist twist_;
  Mat3 R_WB_;
  Mat3 inverse_inertia_W_ = Mat3::Zero();
};

}  // namespace touchstone::fast::constraint
