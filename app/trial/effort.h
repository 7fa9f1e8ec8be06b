// How many scenes are asked about, and how long a failing scene is minimised.
#pragma once

#include <string>
#include <vector>

namespace touchstone::app {

/// How many trajectories, the answers of simulation and constraint, are asked for. One takes engines up to seconds.
struct TrajectoryEffort {
  int simulations = 0;        ///< greatest number of drawn scenes of simulation
  int simulations_alone = 0;  ///< the same, if only one subject is tested
  int constraints = 0;        ///< greatest number of drawn scenes of constraint
  int extreme_cases = 0;      ///< greatest number of extreme scenes of simulation
  int minimise_budget = 0;    ///< queries per failing row
  double time_factor = 1;     ///< how many times as long as for another query a subject may take
};

struct Effort {
  std::string name;
  int cases = 0;            ///< drawn scenes per query
  int cases_alone = 0;      ///< the same, if only one subject is tested
  int more_impacts = 0;     ///< further impacts, for the properties that need one answer
  int extreme_cases = 0;    ///< further scenes, for properties that need no bound
  int minimise_budget = 0;  ///< queries per failing row
  int mesh_share = 1;       ///< a pair of meshes is used in one of so many of the query's laws
  int deep_mesh_pairs = 0;  ///< overlapping pairs of meshes that are queried for depth
  TrajectoryEffort trajectories = {};
};

/// Is the answer to the query a trajectory?
inline bool is_simulated(const std::string& query) { return query == "simulation" || query == "constraint"; }

/// A choice: the many impacts of a trajectory, where a run may take its time.
inline constexpr double patient_simulation_factor = 10;

/// A subject that hung so often in a batch of scenes of one query is not asked about the query's later scenes, and so
/// often is it asked at most to make a scene smaller on which it hangs. A hang costs the whole time limit.
inline constexpr int most_hangs = 3;

/// The standard effort tests one subject on 1,456,000 impacts. 5 of the 16 families of contacts are stiff (tiny_slip,
/// on_the_cone, mass_ratios, levers, jamming): 455,000 impacts; the other 1,001,000 are not.
inline const std::vector<Effort>& efforts() {
  static const std::vector<Effort> all = {
      {"quick", 300, 300, 0, 60, 300, 4, 12, {60, 60, 40, 20, 60, 5}},
      {"standard", 4000, 100'000, 1'356'000, 600, 800, 1, 60, {1000, 4000, 1000, 600, 800, patient_simulation_factor}},
      {"soak",
       40'000,
       1'000'000,
       9'000'000,
       6000,
       1500,
       1,
       600,
       {10'000, 40'000, 10'000, 6000, 1500, patient_simulation_factor}}};
  return all;
}

}  // namespace touchstone::app
