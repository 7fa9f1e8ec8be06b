// FCL's conservative advancement as a time-of-impact query.
#pragma once

#include <memory>

#include "oracle/subject_fwd.h"

namespace touchstone::oracle::subjects {

std::unique_ptr<Subject> make_fcl_cast();

}  // namespace touchstone::oracle::subjects
