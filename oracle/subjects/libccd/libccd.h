// libccd's two penetration queries.
#pragma once

#include <memory>

#include "oracle/subject_fwd.h"

namespace touchstone::oracle::subjects {

std::unique_ptr<Subject> make_libccd_gjk();  ///< GJK, then EPA
std::unique_ptr<Subject> make_libccd_mpr();  ///< Minkowski portal refinement

}  // namespace touchstone::oracle::subjects
