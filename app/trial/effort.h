// How many scenes are asked about, and how long a failing scene is minimised.
#pragma once

#include <limits>
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
  int exact_cases = 0;      ///< of each kind of scene (drawn, extreme, mesh), for an exact subject beside others
  int extreme_cases = 0;    ///< further scenes, for properties that need no bound
  int minimise_budget = 0;  ///< queries per failing row
  int mesh_share = 1;       ///< a pair of meshes is used in one of so many of the query's laws
  int deep_mesh_pairs = 0;  ///< overlapping pairs of meshes that are queried for depth
  int mesh_pairs = std::numeric_limits<int>::max();  ///< pairs of meshes that are queried for distance
  TrajectoryEffort trajectories = {};
};

/// Is the answer to the query a trajectory?
inline bool is_simulated(const std::string& query) { return query == "simulation" || query == "constraint"; }

/// Beside others a subject is asked about so many times fewer extreme scenes and scenes of constraint, and about at
/// most so many pairs of meshes, each of which takes milliseconds to write and to read. Choices.
inline constexpr int fewer_beside_others = 2;
inline constexpr int mesh_pairs_beside_others = 400;

/// A choice: the many impacts of a trajectory, where a run may take its time.
inline constexpr double patient_simulation_factor = 10;

/// A subject that hung so often in a batch of scenes of one query is not asked about the query's later scenes, and so
/// often is it asked at most to make a scene smaller on which it hangs. A hang costs the whole time limit.
inline constexpr int most_hangs = 3;

/// The standard effort tests one subject on 1,456,000 impacts. 5 of the 16 families of contacts are stiff (tiny_slip,
/// on_the_cone, mass_ratios, levers, jamming): 455,000 impacts; the other 1,001,000 are not. Its numbers for several
/// subjects are chosen so that 58 engines and modes take less than 25 minutes on two processors.
inline const std::vector<Effort>& efforts() {
  static const std::vector<Effort> all = {
      {.name = "quick",
       .cases = 300,
       .cases_alone = 4000,
       .more_impacts = 0,
       .exact_cases = 400,
       .extreme_cases = 60,
       .minimise_budget = 300,
       .mesh_share = 4,
       .deep_mesh_pairs = 12,
       .trajectories = {68, 960, 240, 20, 60, 5}},
      {.name = "standard",
       .cases = 1000,
       .cases_alone = 100'000,
       .more_impacts = 1'356'000,
       .exact_cases = 400,
       .extreme_cases = 600,
       .minimise_budget = 800,
       .mesh_share = 4,
       .deep_mesh_pairs = 60,
       .trajectories = {100, 4000, 400, 300, 300, patient_simulation_factor}},
      {.name = "soak",
       .cases = 40'000,
       .cases_alone = 1'000'000,
       .more_impacts = 9'000'000,
       .exact_cases = 4000,
       .extreme_cases = 6000,
       .minimise_budget = 1500,
       .mesh_share = 1,
       .deep_mesh_pairs = 600,
       .trajectories = {10'000, 40'000, 10'000, 6000, 1500, patient_simulation_factor}}};
  return all;
}

}  // namespace touchstone::app
