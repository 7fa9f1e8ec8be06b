#include "app/motion/given_scene.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "app/motion/motion_scenes.h"
#include "model/json.h"
#include "model/near_names.h"
#include "reference/validity.h"

namespace touchstone::app {
namespace {

GivenScene scene_of_file(const std::string& path) {
  GivenScene given{{}, read_source(path)};
  given.scene = scene_from(given.source.text, given.source.name);
  try {
    given.scene = reference::completed(std::move(given.scene));
  } catch (const InputError& error) {
    throw given.located(error);
  }
  return given;
}

InputError neither_file_nor_name(const std::string& word) {
  std::vector<std::string> names;
  for (const MotionScene& motion : motion_scenes()) names.push_back(motion.scene.name);
  const std::string suggestion = did_you_mean(word, names);
  const std::string help = suggestion.empty() ? "`touchstone list motions` names them" : suggestion;
  return {word, "is neither a file nor a scene of that name; " + help};
}

}  // namespace

GivenScene given_scene(const std::string& name_or_file) {
  const auto& known = motion_scenes();
  const auto named =
      std::ranges::find_if(known, [&](const MotionScene& motion) { return motion.scene.name == name_or_file; });
  if (named != known.end()) return {named->scene, {name_or_file, ""}};
  std::error_code other_reasons;  // errors other than "not found" are left to the reader
  const bool is_nowhere =
      std::filesystem::status(name_or_file, other_reasons).type() == std::filesystem::file_type::not_found;
  if (name_or_file != "-" && is_nowhere) throw neither_file_nor_name(name_or_file);
  return scene_of_file(name_or_file);
}

}  // namespace touchstone::app
