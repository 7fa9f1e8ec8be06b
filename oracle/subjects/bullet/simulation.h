// Bullet's discrete dynamics world as a simulation query, in the precision for which this library is built.
#pragma once

#include <memory>
#include <string>

#include "oracle/subject_fwd.h"

namespace touchstone::oracle::subjects {

/// Settings "simulation": the defaults; "simulation_tuned": as Bullet's maintainers advise against lost restitution. dt
/// (s): the longest step.
std::unique_ptr<Subject> make_bullet_simulation(const std::string& settings);
std::unique_ptr<Subject> make_bullet_simulation(const std::string& settings, double dt);

}  // namespace touchstone::oracle::subjects
