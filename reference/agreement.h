// Do the independent routes say the same?
#pragma once

#include <string>

#include "model/scene.h"

namespace touchstone::reference {

/// Empty if the three routes to the distance of bodies 0 and 1 give the same verdict, |d*|², d*, interval and features, as
/// exact rationals, and the certificate passes its check; else which of them differ, in what, on which values.
/// Requires a completed scene (reference/validity.h).
std::string disagreement(const Scene& scene);

}  // namespace touchstone::reference
