// What a contact does: the decision, and the speeds that it depends on.
#pragma once

#include "fast/simulation/island/islands.h"

namespace touchstone::fast::simulation {

enum class Response {
  later,            ///< nothing: the two separate, or hardly approach
  rest,             ///< one rests on the other in closed form
  join_island,      ///< both take contact steps with all that they are in contact with
  micro_collision,  ///< a micro-bounce replaces the contact force
  impact
};

/// How fast two bodies approach at a contact, and the micro-bounces that cannot be distinguished from contact.
struct ContactSpeeds {
  double u_n = 0;  ///< m/s; < 0: they approach
  double bounce_speed =
      0;  ///< m/s; micro-bounces up to it stay within the envelope; 0: nothing presses the two together
  bool in_contact = false;  ///< one of the two is in contact or has had an impact at this time

  /// Whether the two come together so slowly that they may stay together. A body comes down about as fast as it went
  /// up; up to twice the micro-bounce speed still counts.
  bool is_slow() const { return bounce_speed > 0 && -u_n <= 2 * bounce_speed; }
};

/// A contact is an impact, unless it is so slow that a micro-bounce would stay within the envelope: then the body rests
/// if there is a closed form, or the pair joins an island, or with `micro_collisions` it micro-bounces instead.
/// `has_closed_form` matters only for a slow contact of bodies that are not in contact yet.
Response classify(const ContactSpeeds& speeds, bool has_closed_form, bool micro_collisions);

/// An upper bound of the speed of a body's points (m/s).
double speed_bound(const BodyMotion& body, const Velocity& V);

/// An upper bound of the acceleration with which the rotation of two bodies may press them together without applied
/// forces: the centripetal acceleration of their points (m/s²).
double centripetal_bound(const World& world, const Islands& islands, BodyId a, BodyId b);

/// The unit of approach speeds of a pair in contact (m/s): the speed of a micro-bounce within the envelope. Without
/// applied accelerations and with e < 1, at least the speed that the contact solver cannot distinguish from rest
/// beside the present speeds and those before impacts at this time.
double rebound_speed(const World& world, const Islands& islands, BodyId a, BodyId b);

/// The speeds of a pair that touches with the normal velocity u_n.
ContactSpeeds contact_speeds(const World& world, const Islands& islands, BodyId a, BodyId b, const Touch& touch,
                             double u_n, bool in_contact);

}  // namespace touchstone::fast::simulation
