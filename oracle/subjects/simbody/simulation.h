// Simbody's velocity-level time stepper as a simulation query.
#pragma once

#include <memory>

#include "oracle/subject.h"

namespace touchstone::oracle::subjects {

/// dt (s): the longest step.
std::unique_ptr<Subject> make_simbody_simulation(double dt = 1.0 / 256);

}  // namespace touchstone::oracle::subjects
