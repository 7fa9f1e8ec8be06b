// Validates and completes a scene that came through the pipe.
#pragma once

#include <string>

#include "model/scene.h"

namespace touchstone::oracle {

/// Validates the scene (model/limits.h), derives the faces of each polytope that has none, and checks that the scene
/// has what the query needs: two bodies, a contact, a raster, a motion. Throws InputError that names the place, which
/// starts with "scene".
///
/// Given faces are checked only against their neighbours (oracle/process/given_faces.h).
Scene received(Scene scene, const std::string& query);

}  // namespace touchstone::oracle
