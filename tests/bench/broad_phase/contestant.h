// A contestant in the comparison of broad phases: takes a frame's changed boxes and returns the number of overlapping
// pairs.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "model/frame.h"

namespace touchstone::bench {

struct Change {
  std::size_t body = 0;
  Aabb box;
};
using Frame = std::vector<Change>;

class Contestant {
 public:
  virtual ~Contestant() = default;

  /// What a user does in a frame: pass the changed boxes, update the pairs, visit each pair once.
  virtual std::size_t pairs_after(const Frame& frame) = 0;
};

struct Entrant {
  std::string name;
  bool peer = false;  ///< from another library
  std::string law;    ///< claimed growth of a frame's cost at fixed density; empty for other libraries
  std::function<std::unique_ptr<Contestant>(const std::vector<Aabb>& boxes, const Aabb& world)> enter;
};

std::vector<Entrant> our_strategies();
std::vector<Entrant> bullet();
std::vector<Entrant> fcl_managers();
std::vector<Entrant> ode_spaces();
std::vector<Entrant> cgal();

}  // namespace touchstone::bench
