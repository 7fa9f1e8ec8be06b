// Our own optimised implementation as a subject like any other.
#pragma once

#include <memory>

#include "oracle/subject_fwd.h"

namespace touchstone::oracle::subjects {

std::unique_ptr<Subject> make_fast();

}  // namespace touchstone::oracle::subjects
