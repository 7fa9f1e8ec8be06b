// FCL with either of its two GJK solvers.
#pragma once

#include <memory>

#include "oracle/subject_fwd.h"

namespace touchstone::oracle::subjects {

std::unique_ptr<Subject> make_fcl_libccd();
std::unique_ptr<Subject> make_fcl_indep();

}  // namespace touchstone::oracle::subjects
