// Simbody's velocity-level time stepper as a simulation query.
#pragma once

#include <memory>

#include "oracle/subject_fwd.h"

namespace touchstone::oracle::subjects {

/// dt (s): the longest step.
std::unique_ptr<Subject> make_simbody_simulation();
std::unique_ptr<Subject> make_simbody_simulation(double dt);

}  // namespace touchstone::oracle::subjects
