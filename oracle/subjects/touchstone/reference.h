// Our own reference as a subject like any other; it is judged like the rest.
#pragma once

#include <memory>

#include "oracle/subject_fwd.h"

namespace touchstone::oracle::subjects {

std::unique_ptr<Subject> make_reference();

}  // namespace touchstone::oracle::subjects
