// A program in Bullet's own API that asks what the adapter's pair queries ask.
#pragma once

#include <string>

#include "model/scene.h"

namespace touchstone::oracle::subjects::in_bullet {

/// Prints the signed distance of bodies 0 (A) and 1 (B), the point on B and the normal from B to A. `package`: for
/// pkg-config; `expected` is printed first, unless empty. Requires convex bodies.
std::string pair_snippet(const Scene& scene, const std::string& package, const std::string& expected);

}  // namespace touchstone::oracle::subjects::in_bullet
