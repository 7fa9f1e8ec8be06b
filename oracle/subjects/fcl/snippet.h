// Programs in FCL's own API that ask what the adapter's queries ask.
#pragma once

#include <string>

#include "model/scene.h"

namespace touchstone::oracle::subjects::in_fcl {

/// `solver`: "GST_LIBCCD" or "GST_INDEP"; `expected` is printed first, unless empty. Require convex bodies.
std::string distance_snippet(const Scene& scene, const std::string& solver, const std::string& expected);
std::string penetration_snippet(const Scene& scene, const std::string& solver, const std::string& expected);

/// Of the bodies with a density.
std::string mass_snippet(const Scene& scene, const std::string& expected);

}  // namespace touchstone::oracle::subjects::in_fcl
