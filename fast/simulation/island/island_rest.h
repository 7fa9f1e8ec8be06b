// How an island comes to rest: approach that is removed without restitution, the rest test, and the energy.
#pragma once

#include "fast/simulation/island/contact_graph.h"

namespace touchstone::fast::simulation {

/// Removes the approach velocities at all contact points, without restitution.
void remove_approach(ContactGraph& graph);

/// Sets all velocities to 0 if no body is faster than `rest_speed` (m/s), the fixed ones and those that no friction
/// brakes do not move at all, and contact forces within the friction cones balance the applied accelerations. Friction
/// brakes those that contacts with friction connect to a fixed body, which takes up their momentum. Returns whether it
/// does.
bool rest_test(ContactGraph& graph, double rest_speed);

/// J; kinetic energy and potential energy in the applied accelerations, of the bodies that are not fixed.
double energy(const ContactGraph& graph);

}  // namespace touchstone::fast::simulation
