// Names the change by which a law made its second scene.
#pragma once

#include <string>

#include "model/scene.h"

namespace touchstone::properties {

/// "all lengths times 2^20", "the bodies in reverse order": the change of properties/transforms by which `after` was
/// made from `before`; "changed as the law says" if it is none of them.
std::string name_of_change(const Scene& before, const Scene& after);

}  // namespace touchstone::properties
