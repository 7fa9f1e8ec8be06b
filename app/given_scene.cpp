#include "app/given_scene.h"

#include <algorithm>
#include <filesystem>

#include "app/motion_scenes.h"
#include "model/input_error.h"
#include "model/json.h"
#include "reference/validity.h"

namespace touchstone::app {
namespace {

/// Only what reading complains of has the file's name before it already.
Scene completed(const Scene& scene, const std::string& file) try {
  return reference::completed(scene);
} catch (const InputError& error) {
  throw InputError(file, error.what());
}

}  // namespace

Scene given_scene(const std::string& name_or_file) {
  const auto& known = motion_scenes();
  const auto named =
      std::ranges::find_if(known, [&](const MotionScene& motion) { return motion.scene.name == name_or_file; });
  if (named != known.end()) return named->scene;
  if (!std::filesystem::exists(name_or_file)) {
    throw InputError(name_or_file, "is neither a file nor a scene of that name (`touchstone list motions` names them)");
  }
  return completed(read_scene(name_or_file), name_or_file);
}

}  // namespace touchstone::app
