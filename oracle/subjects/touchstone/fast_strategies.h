// Each strategy of fast/broad_phase as a separate subject.
#pragma once

#include <memory>
#include <string>

#include "oracle/subject_fwd.h"

namespace touchstone::oracle::subjects {

/// Throws InputError for an unknown strategy.
std::unique_ptr<Subject> make_fast_strategy(const std::string& name);

}  // namespace touchstone::oracle::subjects
