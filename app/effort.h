// How much is asked, and how long a failing scene is cut down.
#pragma once

#include <string>
#include <vector>

namespace touchstone::app {

struct Effort {
  std::string name;
  int cases = 0;            ///< drawn scenes a stem
  int cases_alone = 0;      ///< the same, if one subject is on trial by itself
  int impacts = 0;          ///< at most so many of them are impacts, whose truth costs milliseconds
  int extreme_cases = 0;    ///< of them, for the properties that ask only for an end and sense, besides
  int minimise_budget = 0;  ///< questions a failing row
  int mesh_share = 1;       ///< a pair of meshes is asked under every so-many-th of the stem's laws
  int deep_mesh_pairs = 0;  ///< overlapping pairs of meshes that are asked for their depth
};

inline const std::vector<Effort>& efforts() {
  static const std::vector<Effort> all = {{"quick", 300, 300, 300, 60, 300, 4, 12},
                                          {"standard", 4000, 100'000, 4000, 600, 800, 1, 60},
                                          {"soak", 40'000, 1'000'000, 40'000, 6000, 1500, 1, 600}};
  return all;
}

}  // namespace touchstone::app
