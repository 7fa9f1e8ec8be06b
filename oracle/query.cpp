#include "oracle/query.h"

#include <algorithm>

namespace touchstone::oracle {

const std::vector<Query>& queries() {
  static const std::vector<Query> all = {
      {.name = "mass", .ask = &Subject::mass},
      {.name = "bounds", .ask = &Subject::bounds},
      {.name = "broad_phase", .ask = &Subject::broad_phase},
      {.name = "pair_history", .ask = &Subject::pair_history},
      {.name = "distance", .ask = &Subject::distance, .about_two_bodies = true},
      {.name = "penetration", .ask = &Subject::penetration, .about_two_bodies = true},
      {.name = "pixel", .ask = &Subject::pixel, .needs = ScenePart::raster},
      {.name = "impulse", .ask = &Subject::impulse, .needs = ScenePart::contact},
      {.name = "time_of_impact", .ask = &Subject::time_of_impact, .about_two_bodies = true, .needs = ScenePart::motion},
      {.name = "simulation", .ask = &Subject::simulation, .needs = ScenePart::motion},
      {.name = "constraint", .ask = &Subject::constraint, .needs = ScenePart::motion}};
  return all;
}

std::vector<std::string> query_names() {
  std::vector<std::string> names;
  for (const Query& query : queries()) names.push_back(query.name);
  return names;
}

const Query* find_query(const std::string& name) {
  const auto found = std::ranges::find(queries(), name, &Query::name);
  return found == queries().end() ? nullptr : &*found;
}

}  // namespace touchstone::oracle
