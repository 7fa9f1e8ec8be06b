// What `fast` leaves out on the scenes of a query, and what that saves.
#pragma once

#include <map>
#include <string>

#include "app/profile/run_times.h"
#include "model/scene.h"

namespace touchstone::app {

/// Of the scenes that were planned (fast/plan.h).
struct LeftOut {
  struct Part {
    long scenes = 0;
    std::string why;  ///< on the first of them
  };

  long planned = 0;
  std::map<std::string, Part> parts;  ///< by what is left out
  long kept = 0;                      ///< scenes on which nothing is left out

  /// Plans the scene of `broad_phase`, `time_of_impact` or `simulation`; other queries have no plan. A scene whose
  /// shapes cannot be planned is not counted.
  void add(const Scene& scene, const std::string& query);
  void merge(const LeftOut& later);
};

/// CPU times of the pairs of sequences, in this process: by the plan, and by the plan that leaves nothing out.
struct PlanTimes {
  RunTimes planned, all_parts;

  /// Asks both, in turn, if the scene is a sequence.
  void measure(const Scene& scene, const std::string& query);
  void merge(const PlanTimes& later);
};

}  // namespace touchstone::app
