// Simbody's velocity-level time stepper as an impulse query (one impact).
#pragma once

#include <memory>
#include <string>

#include "oracle/subject_fwd.h"

namespace touchstone::oracle::subjects {

/// Restitution by "poisson" or by "newton".
std::unique_ptr<Subject> make_simbody_impulse(const std::string& law);

}  // namespace touchstone::oracle::subjects
