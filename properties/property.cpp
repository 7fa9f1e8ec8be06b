#include "properties/property.h"

#include <algorithm>

#include "model/input_error.h"
#include "properties/stems.h"

namespace touchstone::properties {
namespace {

std::vector<Property> join() {
  std::vector<Property> joined;
  for (const auto& stem :
       {mass_properties, bounds_properties, broad_phase_properties, broad_phase_film_properties, distance_properties,
        penetration_properties, pixel_properties, impulse_properties, impulse_law_properties, time_of_impact_properties,
        simulation_properties, simulation_lockstep_properties, simulation_law_properties,
        simulation_scene_properties, constraint_properties}) {
    for (Property& property : stem()) joined.push_back(std::move(property));
  }
  return joined;
}

// Levenshtein's distance: how many letters to change, add or drop.
std::size_t edits(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t kept = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({kept, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row[b.size()];
}

std::string near_names(const std::string& id) {
  std::vector<std::pair<std::size_t, std::string>> ranked;
  for (const Property& property : all()) ranked.emplace_back(edits(id, property.id), property.id);
  std::ranges::sort(ranked);
  return ranked[0].second + ", " + ranked[1].second + " or " + ranked[2].second;
}

}  // namespace

const std::vector<Property>& all() {
  static const std::vector<Property> properties = join();
  return properties;
}

const Property& find(const std::string& id) {
  const auto found = std::ranges::find(all(), id, &Property::id);
  if (found == all().end()) throw InputError("property " + id, "unknown; did you mean " + near_names(id) + "?");
  return *found;
}

}  // namespace touchstone::properties
