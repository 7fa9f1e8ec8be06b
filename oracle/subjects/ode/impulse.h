// ODE's two steppers as impulse queries (one impact).
#pragma once

#include <memory>
#include <string>

#include "oracle/subject_fwd.h"

namespace touchstone::oracle::subjects {

/// "step" (dWorldStep) or "quick_step" (dWorldQuickStep).
std::unique_ptr<Subject> make_ode_impulse(const std::string& stepper);

}  // namespace touchstone::oracle::subjects
