// A scene as it came through the pipe, made fit to be asked about.
#pragma once

#include <string>

#include "model/scene.h"

namespace touchstone::oracle {

/// Validates the scene (model/limits.h), derives the faces of each polytope that has none, and checks that the scene
/// has what the query is about: two bodies, a contact, a raster, a flight. Throws InputError that names the place,
/// which begins with "scene".
///
/// Faces that are given are checked face by face and neighbour by neighbour (oracle/given_faces.h).
Scene received(Scene scene, const std::string& query);

}  // namespace touchstone::oracle
