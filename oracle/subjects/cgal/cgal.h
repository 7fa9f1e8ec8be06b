// CGAL's box intersection (GPL).
#pragma once

#include <memory>

#include "oracle/subject_fwd.h"

namespace touchstone::oracle::subjects {

std::unique_ptr<Subject> make_cgal();

}  // namespace touchstone::oracle::subjects
