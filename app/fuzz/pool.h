// The scenes that fuzzing mutates.
#pragma once

#include <cstddef>
#include <vector>

#include "model/scene.h"
#include "properties/random.h"

namespace touchstone::app {

/// Holds at most `most` scenes: the nearer one is to a failure, the longer it is kept, and the more often it is chosen.
class Pool {
 public:
  static constexpr std::size_t most = 1000;  ///< a choice: a few megabytes

  /// If the pool is full, the scene takes the place of the one that is farther from a failure, of two that are drawn.
  void keep(Scene scene, double nearness, properties::Random& random);

  /// Half the time any scene, else the nearer one of two. Requires that the pool is not empty.
  const Scene& choose(properties::Random& random) const;

  std::size_t size() const { return entries_.size(); }

 private:
  struct Entry {
    Scene scene;
    double nearness = 0;
  };

  std::size_t any(properties::Random& random) const;

  std::vector<Entry> entries_;
};

}  // namespace touchstone::app
