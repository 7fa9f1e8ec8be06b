// Bodies in contact as the solver sees them: balls that hit a floor, and a tower of them.
#pragma once

#include <algorithm>
#include <vector>

#include "fast/contact/solver.h"

namespace touchstone::fast::contact {

/// A problem for the solver.
struct Contacts {
  std::vector<Mobility> bodies;
  std::vector<Twist> twists;
  std::vector<ContactRow> rows;
};

/// A homogeneous ball of mass 2 and radius 1 (1/I = 5/4) that touches a fixed floor from above, at velocity v.
inline Contacts ball_on_floor(const Vec3& v, double friction) {
  Contacts contacts;
  contacts.bodies = {{0.5, 1.25 * Mat3::Identity()}, {}};
  contacts.twists = {{v, Vec3::Zero()}, {}};
  ContactRow row;
  row.b = 1;
  row.n = Vec3(0, 0, 1);
  row.arm_A = Vec3(0, 0, -1);
  row.friction = friction;
  prepare(row, contacts.bodies);
  contacts.rows = {row};
  return contacts;
}

/// Balls of these masses above each other on a fixed floor, the lowest first, all falling at 1 m/s.
inline Contacts tower(const std::vector<double>& masses) {
  Contacts contacts;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    contacts.bodies.push_back({1 / masses[i], Mat3::Identity()});
    contacts.twists.push_back({Vec3(0, 0, -1), Vec3::Zero()});
  }
  contacts.bodies.emplace_back();  // the floor
  contacts.twists.emplace_back();
  for (std::size_t i = 0; i < masses.size(); ++i) {
    ContactRow row;
    row.a = static_cast<int>(i);
    row.b = static_cast<int>(i == 0 ? masses.size() : i - 1);
    row.n = Vec3(0, 0, 1);
    row.arm_A = Vec3(0, 0, -1);
    row.arm_B = i == 0 ? Vec3(Vec3::Zero()) : Vec3(0, 0, 1);
    row.friction = 0.5;
    prepare(row, contacts.bodies);
    contacts.rows.push_back(row);
  }
  return contacts;
}

/// The greatest residual of a contact (m/s).
inline double greatest_residual(const Contacts& contacts) {
  double greatest = 0;
  for (const ContactRow& row : contacts.rows)
    greatest = std::max(greatest, residual(row, relative_velocity(row, contacts.twists)));
  return greatest;
}

}  // namespace touchstone::fast::contact
