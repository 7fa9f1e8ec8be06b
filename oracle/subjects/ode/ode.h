// ODE's spaces.
#pragma once

#include <memory>

#include "oracle/subject_fwd.h"

namespace touchstone::oracle::subjects {

std::unique_ptr<Subject> make_ode_simple();
std::unique_ptr<Subject> make_ode_hash();
std::unique_ptr<Subject> make_ode_quadtree();
std::unique_ptr<Subject> make_ode_sweep();

}  // namespace touchstone::oracle::subjects
