// How much is asked, and how long a failing scene is cut down.
#pragma once

#include <string>
#include <vector>

namespace touchstone::app {

struct Effort {
  std::string name;
  int cases = 0;              ///< drawn scenes a stem
  int cases_alone = 0;        ///< the same, if one subject is on trial by itself
  int more_impacts = 0;       ///< then besides, for the properties of an impact that need one answer
  int extreme_cases = 0;      ///< besides, for the properties that ask only for an end and sense
  int minimise_budget = 0;    ///< questions a failing row
  int mesh_share = 1;         ///< a pair of meshes is asked under every so-many-th of the stem's laws
  int deep_mesh_pairs = 0;    ///< overlapping pairs of meshes that are asked for their depth
  int simulations = 0;        ///< at most so many drawn scenes of simulation
  int simulations_alone = 0;  ///< the same, if one subject is on trial by itself
  int constraints = 0;        ///< at most so many of constraint
};

/// Impacts at standard, of one subject by itself: 1,456,000. 5 of the 16 families of contacts are stiff (tiny_slip,
/// on_the_cone, mass_ratios, levers, jamming): 455,000 impacts, and 1,001,000 that are not.
inline const std::vector<Effort>& efforts() {
  static const std::vector<Effort> all = {
      {"quick", 300, 300, 0, 60, 300, 4, 12, 30, 30, 30},
      {"standard", 4000, 100'000, 1'356'000, 600, 800, 1, 60, 1000, 4000, 1000},
      {"soak", 40'000, 1'000'000, 9'000'000, 6000, 1500, 1, 600, 10'000, 40'000, 10'000}};
  return all;
}

}  // namespace touchstone::app
