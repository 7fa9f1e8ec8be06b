// Our own optimised implementation as one subject among others.
#pragma once

#include <memory>

#include "oracle/subject.h"

namespace touchstone::oracle::subjects {

std::unique_ptr<Subject> make_fast();

}  // namespace touchstone::oracle::subjects
