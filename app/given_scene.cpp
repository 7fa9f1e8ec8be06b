#include "app/given_scene.h"

#include <algorithm>
#include <filesystem>

#include "app/motion_scenes.h"
#include "model/input_error.h"
#include "model/json.h"
#include "model/near_names.h"
#include "reference/validity.h"

namespace touchstone::app {
namespace {

/// Only what reading complains of has the file's name before it already.
Scene completed(const Scene& scene, const std::string& file) try {
  return reference::completed(scene);
} catch (const InputError& error) {
  throw InputError(file, error.what());
}

InputError neither_file_nor_name(const std::string& word) {
  std::vector<std::string> names;
  for (const MotionScene& motion : motion_scenes()) names.push_back(motion.scene.name);
  const std::string suggestion = did_you_mean(word, names);
  const std::string help = suggestion.empty() ? "`touchstone list motions` names them" : suggestion;
  return {word, "is neither a file nor a scene of that name; " + help};
}

}  // namespace

Scene given_scene(const std::string& name_or_file) {
  const auto& known = motion_scenes();
  const auto named =
      std::ranges::find_if(known, [&](const MotionScene& motion) { return motion.scene.name == name_or_file; });
  if (named != known.end()) return named->scene;
  if (name_or_file != "-" && !std::filesystem::exists(name_or_file)) throw neither_file_nor_name(name_or_file);
  return completed(read_scene(name_or_file), name_or_file);
}

}  // namespace touchstone::app
