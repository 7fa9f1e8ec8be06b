// Real input: the convex hulls of robots' collision meshes (Debian's dart-doc), alone and in pairs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/trial/effort.h"
#include "model/scene.h"
#include "model/shape.h"

namespace touchstone::app {

struct Mesh {
  std::string name;   ///< file name without its suffix
  std::string robot;  ///< the folder of the file
  Polytope hull;
};

struct MeshSet {
  std::string folder;                 ///< empty if there is none
  std::string absent;                 ///< why there is none
  std::vector<Mesh> meshes;           ///< sorted by path
  std::vector<std::string> left_out;  ///< files that are flat or not meshes, and why
};

/// Reads the STL and OBJ files below `folder` or, if `folder` is empty, below the first of the known folders that
/// exists. If a named folder holds no mesh, throws InputError. Leaves out files that are flat (decals) or not meshes.
/// `one_robot_only` reads only the folder with the most files.
MeshSet read_meshes(const std::string& folder, bool one_robot_only);

/// A pair (or, for mass, bounds and broad phase, one mesh or all meshes of a robot) in one of three kinds of pose.
struct MeshQuestion {
  std::string family;  ///< "mesh.separated", "mesh.near", "mesh.overlapping", "mesh.alone", "mesh.robot"
  std::uint64_t index = 0;
  std::vector<std::size_t> meshes;
};

/// All pairs of meshes of each robot, or as many as the effort has, spread over them; the kinds of pose alternate.
std::vector<MeshQuestion> mesh_questions(const std::string& query, const Effort& effort, const MeshSet& set);

/// Draws rotations with small integer components and a direction from the seed. The exact distance then says how far to
/// move B: to a gap of a tenth (separated) or of 1e-3 to 1e-9 (near) of the smaller body's size, or into A by a
/// twentieth of the distance between their middles (overlapping).
Scene mesh_scene(const MeshSet& set, const MeshQuestion& question, std::uint64_t seed);

}  // namespace touchstone::app
