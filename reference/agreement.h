// Checks that the independent routes to a distance give the same answer.
#pragma once

#include <string>

#include "model/scene.h"

namespace touchstone::reference {

/// Compares the three routes to the distance of bodies 0 and 1: verdict, |d*|², d*, interval and features, as exact
/// rationals. Also checks the certificate. Returns "" if all agree and the check passes; else names the routes that
/// differ, the quantity and its values.
/// Requires a completed scene (reference/validity.h).
std::string disagreement(const Scene& scene);

}  // namespace touchstone::reference
