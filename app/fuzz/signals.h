// What an execution showed of a scene, so that fuzzing keeps the scenes that show something new.
#pragma once

#include <limits>
#include <set>
#include <string>

#include "fast/mark.h"
#include "model/scene.h"
#include "oracle/finding.h"
#include "properties/property.h"

namespace touchstone::app {

/// Signals are words; a scene with one that no scene had before is kept. Numbers are rounded to powers of two, so there
/// are only so many.
class Signals {
 public:
  /// "mark 12 2^3": how often `fast` reached a place, if the subject is `fast` in this process (fast/mark.h).
  void add_marks(const fast::MarkCounts& before, const fast::MarkCounts& after);

  /// "class touching": the kind of scene, by its exact truth (properties/scenes/domain.h). Of a pair also the exact
  /// margin to another verdict, over the scene's scale: "margin 2^-40".
  void add_scene(const Scene& scene, const std::string& query);

  /// "distance.value holds 2^-4": the outcome of a property, and its error over what is allowed; of a failure its
  /// defect and its error over the exact value.
  void add_finding(const properties::Property& property, const oracle::Finding& finding);

  const std::set<std::string>& words() const { return words_; }

  /// How near the scene is to a failure: the greatest log2(error / allowed), or -log2(margin / scale) - 53 if that is
  /// more; 0 is on the border. Above 0 it fails, by so many bits.
  double nearness() const { return nearness_; }

 private:
  std::set<std::string> words_;
  double nearness_ = -std::numeric_limits<double>::infinity();
};

}  // namespace touchstone::app
