// The properties of simulation that ask for more than one run, or for bodies in contact; the others are in queries.h.
#pragma once

#include <vector>

#include "properties/property.h"

namespace touchstone::properties {

/// Lists that properties::all() is made of.
std::vector<Property> simulation_causality_properties();
std::vector<Property> simulation_face_properties();

}  // namespace touchstone::properties
