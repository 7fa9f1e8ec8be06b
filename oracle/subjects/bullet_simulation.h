// Bullet's discrete world, in the precision that this library was built for, asked what happens next.
#pragma once

#include <memory>
#include <string>

#include "oracle/subject.h"

namespace touchstone::oracle::subjects {

/// Settings "simulation": as shipped; "simulation_tuned": as its maintainers advise against lost restitution.
/// dt (s): the longest step.
std::unique_ptr<Subject> make_bullet_simulation(const std::string& settings, double dt = 1.0 / 256);

}  // namespace touchstone::oracle::subjects
