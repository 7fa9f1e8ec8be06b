// ODE's two steppers as simulation queries.
#pragma once

#include <memory>
#include <string>

#include "oracle/subject_fwd.h"

namespace touchstone::oracle::subjects {

/// "simulation" (dWorldStep) or "simulation_quick" (dWorldQuickStep). dt (s): the longest step.
std::unique_ptr<Subject> make_ode_simulation(const std::string& stepper);
std::unique_ptr<Subject> make_ode_simulation(const std::string& stepper, double dt);

}  // namespace touchstone::oracle::subjects
