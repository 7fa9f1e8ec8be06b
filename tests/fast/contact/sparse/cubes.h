// Cubes above one another on a fixed floor, as the solvers see them.
#pragma once

#include "tests/fast/contact/rows.h"

namespace touchstone::fast::contact {

/// Cubes of mass 1 and side 1, the lowest first and the floor last. Each lies `step` farther along x than the one below
/// it, and touches that at the four corners of the face that they share. All have the velocity v.
inline Contacts leaning_stack(int count, double step, const Vec3& v, double friction) {
  Contacts contacts;
  for (int i = 0; i < count; ++i) {
    contacts.bodies.push_back({1, 6 * Mat3::Identity()});
    contacts.twists.push_back({v, Vec3::Zero()});
  }
  contacts.bodies.emplace_back();
  contacts.twists.emplace_back();
  for (int i = 0; i < count; ++i) {
    const double overhang = i == 0 ? 0 : step;
    for (const double x : {overhang - 0.5, 0.5}) {  // seen from the cube below
      for (const double y : {-0.5, 0.5}) {
        ContactRow row;
        row.a = i;
        row.b = i == 0 ? count : i - 1;
        row.n = Vec3(0, 0, 1);
        row.arm_A = Vec3(x - overhang, y, -0.5);
        row.arm_B = i == 0 ? Vec3(Vec3::Zero()) : Vec3(x, y, 0.5);
        row.friction = friction;
        prepare(row, contacts.bodies);
        contacts.rows.push_back(row);
      }
    }
  }
  return contacts;
}

/// The greatest velocity of a body's centre or corner, as a bound.
inline double greatest_speed(const std::vector<Twist>& twists) {
  double greatest = 0;
  for (const Twist& twist : twists) greatest = std::max(greatest, twist.v.norm() + twist.w.norm());
  return greatest;
}

}  // namespace touchstone::fast::contact
