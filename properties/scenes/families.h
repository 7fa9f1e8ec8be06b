// The families, grouped by what makes them hard; properties/scenes/domain.cpp lists them all.
#pragma once

#include <vector>

#include "properties/scenes/domain.h"

namespace touchstone::properties {

std::vector<Family> box_families();
std::vector<Family> touching_families();
std::vector<Family> parallel_families();
std::vector<Family> slender_families();
std::vector<Family> round_families();
std::vector<Family> hull_families();
std::vector<Family> mixed_families();
std::vector<Family> redundant_families();
std::vector<Family> ball_pair_families();
std::vector<Family> compound_pair_families();
std::vector<Family> contained_families();
std::vector<Family> placed_families();
std::vector<Family> crowd_families();
std::vector<Family> sequence_families();
std::vector<Family> long_sequence_families();
std::vector<Family> mass_families();
std::vector<Family> pixel_families();
std::vector<Family> contact_families();
std::vector<Family> motion_families();
std::vector<Family> tangent_motion_families();
std::vector<Family> long_motion_families();
std::vector<Family> compound_motion_families();
std::vector<Family> off_centre_motion_families();
std::vector<Family> run_families();
std::vector<Family> driven_run_families();
std::vector<Family> stacked_run_families();
std::vector<Family> table_families();

/// What a family is for: pairs of convex bodies are asked about everything, compounds have no depth.
inline const std::vector<std::string> convex_pair_queries = {"mass", "bounds", "broad_phase", "distance",
                                                             "penetration"};
inline const std::vector<std::string> pair_queries = {"mass", "bounds", "broad_phase", "distance"};

/// A small scene of two convex bodies from one of the families near the origin, of size about 1 to 10, exact in floats.
/// The families of poses, scales and positions start from it.
Scene some_pair(Random& random);

}  // namespace touchstone::properties
