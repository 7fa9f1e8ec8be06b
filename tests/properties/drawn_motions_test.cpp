// Canaries about the time of impact are detected on drawn scenes, not only on those made by hand: a run with little
// effort would find them.
#include <algorithm>

#include "oracle/subjects/canaries/canaries.h"
#include "properties/property.h"
#include "properties/scenes/domain.h"
#include "tests/catch.h"
#include "tests/properties/kills.h"

using namespace touchstone;

namespace {

/// Some scenes from each family of motions, one of each family in turn.
std::vector<Scene> drawn_motions() {
  constexpr std::uint64_t of_each = 12, seed = 1;
  std::vector<Scene> scenes;
  for (std::uint64_t i = 0; i < of_each; ++i) {
    for (const properties::Family& family : properties::families()) {
      if (family.id.starts_with("flights.")) scenes.push_back(properties::draw(family, seed, i));
    }
  }
  return scenes;
}

bool is_caught(const std::string& property, const oracle::subjects::Canary& canary, const std::vector<Scene>& scenes) {
  const auto& check = properties::find(property).check;
  return std::ranges::any_of(scenes, [&](const Scene& scene) {
    const auto subject = canary.make(tests::truthful());
    return check(scene, *subject).outcome == oracle::Outcome::fails;
  });
}

}  // namespace

TEST_CASE("canaries about flights are caught on drawn scenes") {
  const std::vector<std::pair<std::string, std::string>> table = {{"turns_forgotten", "agrees"},
                                                                  {"gravity_forgotten", "agrees"},
                                                                  {"gyroscopic_term_forgotten", "agrees"},
                                                                  {"fixed_bodies_stand", "agrees"},
                                                                  {"pushes_forgotten", "agrees"},
                                                                  {"thick_air", "agrees"},
                                                                  {"balls_for_boxes", "agrees"},
                                                                  {"since_forgotten", "later"},
                                                                  {"tunnels", "agrees"},
                                                                  {"late", "enclosure"},
                                                                  {"early", "enclosure"},
                                                                  {"whole_microseconds", "hastened"},
                                                                  {"envelope_is_contact", "scaled"},
                                                                  {"feels_gravity", "gravity"},
                                                                  {"feels_mass", "mass"},
                                                                  {"balls_rub", "spin_of_balls"},
                                                                  {"touching_counts", "start"},
                                                                  {"touching_ignored", "start"},
                                                                  {"ahead_is_hit", "agrees"},
                                                                  {"shrugs_at_flights", "decided"},
                                                                  {"wide_meeting", "tight"}};
  const std::vector<Scene> scenes = drawn_motions();
  for (const auto& [canary, property] : table) {
    INFO(canary << " " << property);
    CHECK(is_caught("time_of_impact." + property, oracle::subjects::canary("canary." + canary), scenes));
  }
}
