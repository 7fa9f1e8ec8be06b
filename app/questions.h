// Which scenes a stem's properties are asked about: drawn families, extreme scenes, real meshes.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/effort.h"
#include "app/meshes.h"
#include "model/scene.h"
#include "properties/property.h"

namespace touchstone::app {

struct Question {
  std::string family;
  std::uint64_t index = 0;
  std::function<Scene()> scene;  ///< the same scene each time
  std::function<bool(const properties::Property&)> asked_under;
  bool counts_for_classes = false;  ///< drawn from a family of the stem
};

/// Is it a plain agreement of a number or verdict with the truth? Every pair of meshes is asked under these.
bool compares_with_truth(const properties::Property& property);

/// In a fixed order: the families in turn, then the extremes, then the meshes. `set` outlives the questions.
std::vector<Question> questions(const std::string& stem, const Effort& effort, std::uint64_t seed, const MeshSet& set);

}  // namespace touchstone::app
