// DART's rigid-body simulation.
#pragma once

#include <memory>

#include "oracle/subject_fwd.h"

namespace touchstone::oracle::subjects {

/// dart::simulation::World in steps of at most `dt` (s). Balls, boxes and compounds of these; a hull would be a mesh of
/// assimp.
std::unique_ptr<Subject> make_dart_simulation();
std::unique_ptr<Subject> make_dart_simulation(double dt);

}  // namespace touchstone::oracle::subjects
