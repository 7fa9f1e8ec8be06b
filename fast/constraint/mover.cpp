#include "fast/constraint/mover.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "fast/mass.h"
#include "model/input_error.h"

namespace touchstone::fast::constraint {
namespace {

lin_canny::Solid solid_of(const Body& body, const std::string& place) {
  if (std::holds_alternative<Compound>(body.shape)) throw InputError(place + ".shape", "a compound; not stepped");
  return lin_canny::Solid(body.shape);
}

Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

Quaternion normalised(const Quaternion& q) {
  const double s = 1 / std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {s * q.w, s * q.x, s * q.y, s * q.z};
}

/// Times a power of two: the same rotation, exactly, with squares that are in range.
Quaternion about_1(const Quaternion& q) {
  const int exponent = -std::ilogb(std::max({std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)}));
  const auto scaled = [&](double x) { return std::scalbn(x, exponent); };
  return {scaled(q.w), scaled(q.x), scaled(q.y), scaled(q.z)};
}

}  // namespace

Mover::Mover(const Body& body, const std::string& place)
    : solid_(solid_of(body, place)), q_WB_(about_1(body.X_WB.q_WB)), twist_{body.velocity.v_WBcm, body.velocity.w_WB} {
  if (const auto properties = fast::mass(body)) {
    inverse_mass_ = 1 / properties->mass;
    p_BBcm_ = properties->p_BBcm;
    inertia_B_ = properties->I_BBcm_B;
    inverse_inertia_B_ = inertia_B_.inverse();
    round_ = inertia_B_ == Mat3(inertia_B_(0, 0) * Mat3::Identity());
  }
  centre_ = lin_canny::rotation(q_WB_) * p_BBcm_ + body.X_WB.p_WB;
  reach_ = convex().reach + p_BBcm_.norm();
  refresh();
}

Pose Mover::pose() const { return {centre_ - R_WB_ * p_BBcm_, q_WB_}; }

/// By the rotation with the quaternion (1, angle/2): its angle is that of `angle` to second order, and no sine is
/// needed.
void Mover::turn(const Vec3& angle) {
  q_WB_ = normalised(product({1, angle.x() / 2, angle.y() / 2, angle.z() / 2}, q_WB_));
}

void Mover::refresh() {
  R_WB_ = lin_canny::rotation(q_WB_);
  if (is_fixed()) return;
  inverse_inertia_W_ = round_ ? inverse_inertia_B_ : Mat3(R_WB_ * inverse_inertia_B_ * R_WB_.transpose());
}

void Mover::advance(double h, const Twist& twist, bool touched, const Twist& shift) {
  centre_ += h * (touched || is_fixed() ? Vec3(twist.v + shift.v) : Vec3((twist_.v + twist.v) / 2));
  twist_ = twist;
  if (round_) {
    if (!twist.w.isZero(0) || !shift.w.isZero(0)) turn(h * (twist.w + shift.w));
    return refresh();
  }
  const Vec3 L = R_WB_ * (inertia_B_ * (R_WB_.transpose() * twist.w));
  const Quaternion before = q_WB_;
  turn(h / 2 * twist.w);
  refresh();
  const Vec3 half_way = inverse_inertia_W_ * L;
  q_WB_ = before;
  turn(h * (half_way + shift.w));
  refresh();
  twist_.w = inverse_inertia_W_ * L;
}

}  // namespace touchstone::fast::constraint
