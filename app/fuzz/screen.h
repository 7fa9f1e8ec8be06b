// The first stage of fuzzing: one question a scene, and a quick proof that its answer is right.
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "fast/mark.h"
#include "model/scene.h"
#include "oracle/judge/distance_screen.h"
#include "oracle/subject.h"
#include "properties/property.h"

namespace touchstone::app {

/// Screens the answers of one subject to `distance` (oracle/judge/distance_screen.h), and remembers what they showed.
class Screen {
 public:
  /// Whether a screen exists for the query, and the properties include all that it stands for.
  static bool applies(const std::string& query, const std::vector<const properties::Property*>& properties);

  /// Whether a failure of the property means that the screen must not call the answer right.
  static bool stands_for(const properties::Property& property);

  explicit Screen(oracle::Subject& subject) : subject_(subject) {}

  struct Seen {
    oracle::judge::Screened result = oracle::judge::Screened::open;
    bool is_new = false;  ///< it shows what no scene had shown before
  };

  /// Asks once. New may be: how often a mark of `fast` was reached, the verdict, how many vertices the features have,
  /// or the power of two of the margin over the scene's scale, of the error or of the enclosure's width over what is
  /// allowed. An exception is `open`: the properties will meet it.
  Seen ask(const Scene& scene);

 private:
  bool note(int kind, int what, int value);
  bool note_marks(const fast::MarkCounts& before);

  oracle::Subject& subject_;
  std::set<std::array<int, 3>> known_;
};

}  // namespace touchstone::app
