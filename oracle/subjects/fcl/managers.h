// FCL's broad-phase managers.
#pragma once

#include <memory>
#include <string>

#include "oracle/subject_fwd.h"

namespace touchstone::oracle::subjects {

/// "naive", "sap", "ssap", "interval_tree", "spatial_hash", "dynamic_tree" or "dynamic_tree_array"; throws InputError
/// for any other name.
std::unique_ptr<Subject> make_fcl_manager(const std::string& name);

}  // namespace touchstone::oracle::subjects
