#include "app/trial/meshes.h"

#include <algorithm>

#include "model/input_error.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/truth.h"
#include "tests/catch.h"

namespace touchstone::app {
namespace {

MeshSet two_tetrahedra() {
  MeshSet set;
  for (const double size : {1.0, 3.0}) {
    const Polytope hull = oracle::truth::convex_hull({Vec3::Zero(), {size, 0, 0}, {0, size, 0}, {0, 0, size}});
    set.meshes.push_back({"tetrahedron", "robot", hull});
  }
  return set;
}

double gap_in_sizes(const Scene& scene) {
  const double size = std::min(oracle::tolerance::radius(scene.bodies[0]), oracle::tolerance::radius(scene.bodies[1]));
  return oracle::truth::distance(scene).distance.lo / size;
}

TEST_CASE("Poses are what their kind says") {
  const MeshSet set = two_tetrahedra();
  for (std::uint64_t index = 0; index < 30; ++index) {
    CHECK(gap_in_sizes(mesh_scene(set, {"mesh.separated", index, {0, 1}}, 1)) == Approx(0.1));
    const double near = gap_in_sizes(mesh_scene(set, {"mesh.near", index, {0, 1}}, 1));
    CHECK(near > 0.9e-9);
    CHECK(near < 1.1e-3);
    const Scene overlapping = mesh_scene(set, {"mesh.overlapping", index, {0, 1}}, 1);
    CHECK(oracle::truth::distance(overlapping).verdict == Verdict::overlapping);
  }
}

TEST_CASE("A scene follows from the seed") {
  const MeshSet set = two_tetrahedra();
  const MeshQuestion question{"mesh.near", 3, {0, 1}};
  CHECK(mesh_scene(set, question, 5) == mesh_scene(set, question, 5));
  CHECK_FALSE(mesh_scene(set, question, 5) == mesh_scene(set, question, 6));
}

TEST_CASE("Depth, and beside others distance, is asked of a few pairs, spread over all") {
  MeshSet set;
  for (int i = 0; i < 10; ++i) set.meshes.push_back({"mesh", "robot", {}});
  Effort effort{.name = "some", .deep_mesh_pairs = 5};
  CHECK(mesh_questions("distance", effort, set).size() == 45);
  const std::vector<MeshQuestion> deep = mesh_questions("penetration", effort, set);
  CHECK(deep.size() == 5);
  CHECK(deep.back().meshes[0] > 3);
  effort.mesh_pairs = 9;
  const std::vector<MeshQuestion> some = mesh_questions("distance", effort, set);
  CHECK(some.size() == 9);
  CHECK(some.back().meshes[0] > 3);
  CHECK(mesh_questions("broad_phase", effort, set).size() == 1);
  CHECK(mesh_questions("mass", effort, set).size() == 10);
}

TEST_CASE("Meshes of two robots are never paired") {
  MeshSet set;
  for (const char* robot : {"one", "one", "two"}) set.meshes.push_back({"mesh", robot, {}});
  CHECK(mesh_questions("distance", {"some", 1, 1, 1, 1, 1, 1, 5}, set).size() == 1);
  CHECK(mesh_questions("broad_phase", {"some", 1, 1, 1, 1, 1, 1, 5}, set).size() == 2);
}

TEST_CASE("A folder that was named must exist") { CHECK_THROWS_AS(read_meshes("/nowhere", false), InputError); }

}  // namespace
}  // namespace touchstone::app
