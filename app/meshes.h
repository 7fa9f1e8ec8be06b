// Real input: the convex hulls of robots' collision meshes (Debian's dart-doc), alone and in pairs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/effort.h"
#include "model/scene.h"
#include "model/shape.h"

namespace touchstone::app {

struct Mesh {
  std::string name;   ///< file name without its ending
  std::string robot;  ///< the folder that it was found in
  Polytope hull;
};

struct MeshSet {
  std::string folder;                 ///< empty if there is none
  std::string absent;                 ///< why there is none
  std::vector<Mesh> meshes;           ///< sorted by path
  std::vector<std::string> left_out;  ///< files that are flat, or no meshes, and why
};

/// Reads the STL and OBJ files below `folder`, or below the first of the known folders that exists if `folder` is
/// empty. A folder that was named must hold a mesh: InputError. Files that are flat (decals) or no meshes are left out.
/// `one_robot_only` reads just the folder that holds the most files.
MeshSet read_meshes(const std::string& folder, bool one_robot_only);

/// A pair (or, for mass, bounds and broad phase, one mesh or all of a robot) in one of three kinds of pose.
struct MeshQuestion {
  std::string family;  ///< "mesh.separated", "mesh.near", "mesh.overlapping", "mesh.alone", "mesh.robot"
  std::uint64_t index = 0;
  std::vector<std::size_t> meshes;
};

/// Every pair of meshes of one robot; the kinds of pose take turns.
std::vector<MeshQuestion> mesh_questions(const std::string& stem, const Effort& effort, const MeshSet& set);

/// Rotations of small integers and the direction are drawn from the seed; the exact distance then says how far to move
/// B: to a gap of a tenth (separated) or of 1e-3 to 1e-9 (near) of the smaller body's size, or until it is in A by a
/// twentieth of the way between their middles (overlapping).
Scene mesh_scene(const MeshSet& set, const MeshQuestion& question, std::uint64_t seed);

}  // namespace touchstone::app
