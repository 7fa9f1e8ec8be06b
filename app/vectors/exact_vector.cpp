#include "app/vectors/exact_vector.h"

#include <fmt/format.h>

#include <utility>

#include "app/commands/ask.h"
#include "model/input_error.h"
#include "model/parts.h"
#include "oracle/tolerance/precision.h"
#include "oracle/tolerance/tolerance.h"
#include "reference/simulation.h"

namespace touchstone::app {
namespace {

using oracle::Precision;

Json simulation(const Scene& scene) {
  const Trajectory trajectory = reference::simulation(scene);
  if (trajectory.complete_until) {
    throw InputError("",
                     fmt::format("the reference gives up at {} s: {}", *trajectory.complete_until, trajectory.gave_up));
  }
  return touchstone::json_of(trajectory);
}

/// One certificate for each pair of parts: only all of them prove a least distance.
Json certificates_of(const Scene& scene) {
  Json certificates = Json::array();
  Scene pair;
  for (int a = 0; a < part_count(scene.bodies[0]); ++a) {
    for (int b = 0; b < part_count(scene.bodies[1]); ++b) {
      pair.bodies = {part_alone(scene.bodies[0], a), part_alone(scene.bodies[1], b)};
      const Json answer = exact_answer("distance", pair);
      certificates.push_back({{"part_A", a},
                              {"part_B", b},
                              {"squared_distance_of_cores", answer["squared_distance_of_cores"]["exact"]},
                              {"radius_sum", answer["radius_sum"]["exact"]},
                              {"direction", answer["certificate"]["direction"]},
                              {"pairs", answer["certificate"]["pairs"]}});
    }
  }
  return certificates;
}

Json number(const std::string& query, const Scene& scene, Precision precision) {
  namespace tolerance = oracle::tolerance;
  if (query == "distance") return tolerance::distance(scene, precision);
  if (query == "penetration") return tolerance::penetration(scene, precision);
  return tolerance::bounds(scene, precision);
}

}  // namespace

Json exact_vector(const std::string& query, const Scene& scene) {
  if (query == "simulation") return simulation(scene);
  Json answer = exact_answer(query, scene);
  if (query == "distance" || query == "penetration") {
    answer.erase("certificate");
    answer["certificates"] = certificates_of(scene);
  }
  return answer;
}

Json allowance(const std::string& query, const Scene& scene) {
  if (query != "distance" && query != "penetration" && query != "bounds") return nullptr;
  Json allowed = {{"binary64", number(query, scene, Precision::binary64)}};
  if (oracle::exact_in(scene, Precision::binary32)) allowed["binary32"] = number(query, scene, Precision::binary32);
  return allowed;
}

}  // namespace touchstone::app
