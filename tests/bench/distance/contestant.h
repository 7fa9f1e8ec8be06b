// A contestant in the comparison of distance queries.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tests/bench/distance/workload.h"

namespace touchstone::bench {

class Contestant {
 public:
  virtual ~Contestant() = default;

  /// The distance of the two bodies in these poses. A contestant may use what it has kept from the previous frame.
  virtual double distance(const FrameSequence::Poses& poses) = 0;
};

struct Entrant {
  std::string name;
  std::string whose;  ///< "ours"; "peer": another engine's distance query; "other": another query
  std::function<std::unique_ptr<Contestant>(const Polytope& A, const Polytope& B)> enter;
};

std::vector<Entrant> ours();
/// fast::distance and reference::distance of a scene: they keep nothing.
std::vector<Entrant> asked_once();
std::vector<Entrant> bullet();
std::vector<Entrant> fcl_solvers();
std::vector<Entrant> libccd();

}  // namespace touchstone::bench
