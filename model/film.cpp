#include "model/film.h"

namespace touchstone {

std::vector<Places> places(const Scene& film) {
  std::vector<Places> all;
  Places now(film.bodies.size());
  for (const Frame& frame : film.frames) {
    for (const Placement& placement : frame) now[static_cast<std::size_t>(placement.body)] = placement.X_WB;
    all.push_back(now);
  }
  return all;
}

}  // namespace touchstone
