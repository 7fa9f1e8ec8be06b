#include "app/trial/meshes.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "app/system/program_folder.h"
#include "app/system/progress.h"
#include "model/input_error.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/truth.h"
#include "oracle/truth/world_points.h"
#include "properties/random.h"
#include "reference/mesh.h"

namespace touchstone::app {
namespace {

namespace fs = std::filesystem;
using Robots = std::map<std::string, std::vector<fs::path>>;  // folder -> its mesh files, sorted

Robots mesh_files(const std::string& folder) {
  Robots robots;
  if (!fs::is_directory(folder)) return robots;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".stl" || ending == ".STL" || ending == ".obj") {
      robots[entry.path().parent_path().string()].push_back(entry.path());
    }
  }
  for (auto& [robot, files] : robots) std::ranges::sort(files);
  return robots;
}

void keep_largest(Robots& robots) {
  const auto largest = std::ranges::max_element(robots, {}, [](const auto& robot) { return robot.second.size(); });
  Robots only = {*largest};
  robots = std::move(only);
}

void read_all(const Robots& robots, MeshSet& set) {
  std::size_t count = 0;
  for (const auto& [robot, files] : robots) count += files.size();
  Progress progress("reading meshes", static_cast<int>(count));
  for (const auto& [robot, files] : robots) {
    for (const fs::path& file : files) {
      progress.step(file.filename().string());
      try {
        set.meshes.push_back({file.stem().string(), robot, reference::read_mesh(file.string())});
      } catch (const InputError& error) {
        set.left_out.push_back(error.what());
      }
    }
  }
}

Body body_of(const Mesh& mesh) {
  Body body;
  body.name = mesh.name;
  body.shape = mesh.hull;
  return body;
}

Quaternion drawn_rotation(properties::Random& random) {
  Quaternion q{random.whole(-4, 4), random.whole(-4, 4), random.whole(-4, 4), random.whole(-4, 4)};
  if (q == Quaternion{0, 0, 0, 0}) q.w = 1;
  return q;
}

/// The gap, relative to the size of the smaller body.
double drawn_gap(const std::string& family, properties::Random& random) {
  if (family == "mesh.separated") return 0.1;
  if (family == "mesh.near") return random.pick({1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9});
  return 0;
}

/// Moves B along the line of the closest points until the gap is gap_in_sizes.
void close_in(Scene& scene, double gap_in_sizes) {
  const double size = std::min(oracle::tolerance::radius(scene.bodies[0]), oracle::tolerance::radius(scene.bodies[1]));
  const reference::DistanceTruth& truth = oracle::truth::distance(scene);
  const Vec3 toward_A(truth.difference.x.nearest(), truth.difference.y.nearest(), truth.difference.z.nearest());
  scene.bodies[1].X_WB.p_WB += toward_A.stableNormalized() * (truth.distance.lo - gap_in_sizes * size);
}

/// A point inside the body: the mean of its vertices, in W.
Vec3 middle(const Body& body) {
  const oracle::Points points = oracle::world_points(body, 0);
  oracle::Point sum = oracle::Point::Zero();
  for (const oracle::Point& p : points) sum += p;
  return (sum / static_cast<oracle::Real>(points.size())).cast<double>();
}

/// If two bodies touch at x, they overlap once B has moved by the fraction e of the way between their middles: (1 − e)
/// x + e·middle(A) is inside both.
void push_in(Scene& scene) {
  constexpr double part = 0.05;
  scene.bodies[1].X_WB.p_WB += part * (middle(scene.bodies[0]) - middle(scene.bodies[1]));
}

/// Moves the bodies apart so that some boxes overlap and some do not.
void scatter(Scene& scene, double radius, properties::Random& random) {
  for (Body& body : scene.bodies) {
    body.X_WB.p_WB = radius * Vec3(random.whole(-3, 3), random.whole(-3, 3), random.whole(-3, 3));
  }
}

bool is_pair_query(const std::string& query) { return query == "distance" || query == "penetration"; }

std::vector<MeshQuestion> pairs(const std::string& query, const Effort& effort, const MeshSet& set) {
  static const std::vector<std::string> kinds = {"mesh.separated", "mesh.near", "mesh.overlapping"};
  std::vector<MeshQuestion> asked;
  std::uint64_t pair = 0;
  for (std::size_t i = 0; i < set.meshes.size(); ++i) {
    for (std::size_t j = i + 1; j < set.meshes.size() && set.meshes[i].robot == set.meshes[j].robot; ++j, ++pair) {
      asked.push_back({kinds[pair % kinds.size()], pair, {i, j}});
    }
  }
  const bool of_depth = query == "penetration";
  if (of_depth) {
    std::erase_if(asked, [](const MeshQuestion& question) { return question.family != "mesh.overlapping"; });
  }
  const auto wanted = static_cast<std::size_t>(of_depth ? effort.deep_mesh_pairs : effort.mesh_pairs);
  if (asked.size() <= wanted) return asked;
  std::vector<MeshQuestion> spread;  // evenly over all the pairs
  for (std::size_t k = 0; k < wanted; ++k) spread.push_back(asked[k * asked.size() / wanted]);
  return spread;
}

}  // namespace

MeshSet read_meshes(const std::string& folder, bool one_robot_only) {
  MeshSet set;
  Robots robots = mesh_files(folder);
  set.folder = folder;
  if (folder.empty()) {
    for (const std::string& known : mesh_folders()) {
      if (robots.empty()) robots = mesh_files(set.folder = known);
    }
  } else if (robots.empty()) {
    throw InputError(folder, "holds no mesh (STL or OBJ)");
  }
  if (robots.empty())
    return {
        "", "Debian's package dart-doc is not here; the launcher fetches it, or name a folder with --meshes", {}, {}};
  if (one_robot_only) keep_largest(robots);
  read_all(robots, set);
  if (set.meshes.empty()) throw InputError("meshes", set.left_out.front());
  return set;
}

std::vector<MeshQuestion> mesh_questions(const std::string& query, const Effort& effort, const MeshSet& set) {
  if (is_pair_query(query)) return pairs(query, effort, set);
  std::vector<MeshQuestion> alone;
  if (query == "broad_phase") {
    for (std::size_t i = 0; i < set.meshes.size();) {
      MeshQuestion robot{"mesh.robot", i, {}};
      for (const std::string& name = set.meshes[i].robot; i < set.meshes.size() && set.meshes[i].robot == name; ++i) {
        robot.meshes.push_back(i);
      }
      alone.push_back(robot);
    }
    return alone;
  }
  for (std::size_t i = 0; i < set.meshes.size(); ++i) alone.push_back({"mesh.alone", i, {i}});
  return alone;
}

Scene mesh_scene(const MeshSet& set, const MeshQuestion& question, std::uint64_t seed) {
  properties::Random random(seed, question.family, question.index);
  Scene scene;
  double reach = 0;
  for (const std::size_t i : question.meshes) {
    Body body = body_of(set.meshes[i]);
    body.X_WB.q_WB = drawn_rotation(random);
    reach += oracle::tolerance::radius(body);
    scene.bodies.push_back(std::move(body));
  }
  if (question.meshes.size() == 2) {
    const Vec3 direction(random.whole(1, 4), random.whole(-4, 4), random.whole(-4, 4));
    scene.bodies[1].X_WB.p_WB = direction.normalized() * (1.5 * reach);
    close_in(scene, drawn_gap(question.family, random));
    if (question.family == "mesh.overlapping") push_in(scene);
    scene.name = scene.bodies[0].name + " and " + scene.bodies[1].name;
  } else {
    scene.name = question.family;
    if (question.family == "mesh.robot") scatter(scene, reach / static_cast<double>(question.meshes.size()), random);
  }
  return scene;
}

}  // namespace touchstone::app
