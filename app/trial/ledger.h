// All that a run found: the results, and what was asked.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "app/profile/query_profile.h"
#include "app/trial/result_matrix.h"
#include "app/trial/row.h"

namespace touchstone::app {

/// The meshes that were read, and the scenes made of them.
struct MeshCounts {
  std::string absent;  ///< why there are none
  std::size_t count = 0;
  std::size_t left_out = 0;            ///< flat, or not a mesh
  std::map<std::string, long> scenes;  ///< by family
};

struct Ledger {
  Ledger(ResultMatrix::Properties properties, std::vector<TestedSubject> tested)
      : subjects(std::move(tested)), results(properties, subjects), beyond(std::move(properties), subjects) {}

  /// Not copied, since the results point to the subjects.
  Ledger(Ledger&&) = default;

  std::uint64_t seed = 0;
  std::string effort;
  int cases = 0;  ///< drawn scenes per query
  bool interrupted = false;
  std::vector<TestedSubject> subjects;
  ResultMatrix results;
  ResultMatrix beyond;  ///< of scenes outside the domain that a subject's card declares; never mixed with `results`
  std::map<std::string, std::map<std::string, long>> classes;  ///< query -> class -> scenes
  std::map<std::string, long> scenes;                          ///< query -> number of scenes
  std::vector<std::string> empty_classes;                      ///< "distance: edge-edge"
  MeshCounts meshes;
  std::map<std::string, QueryProfile> profiles;  ///< by query; empty unless the plan wants them
};

}  // namespace touchstone::app
