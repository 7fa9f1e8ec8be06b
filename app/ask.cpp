#include "app/ask.h"

#include <fmt/format.h>

#include <map>
#include <stdexcept>

#include "app/report_json.h"
#include "model/input_error.h"
#include "model/json.h"
#include "oracle/words.h"
#include "reference/bounds.h"
#include "reference/broad_phase.h"
#include "reference/distance.h"
#include "reference/mass.h"
#include "reference/penetration.h"
#include "reference/validity.h"

namespace touchstone::app {
namespace {

using oracle::words::text;
using reference::Rational;

/// What is printed: a JSON object whose texts are for people too.
using Show = Json (*)(const Scene&);

Json json_of(const Rational& value) { return {{"exact", value.text()}, {"nearest", value.nearest()}}; }

Json json_of(const Interval& interval) { return {interval.lo, interval.hi}; }

Json json_of(const reference::RationalVec3& v) { return {v.x.text(), v.y.text(), v.z.text()}; }

Json json_of(const Feature& feature) { return {{"part", feature.part}, {"vertices", feature.vertices}}; }

void require_pair(const Scene& scene) {
  if (scene.bodies.size() < 2) throw InputError("bodies", "this question is about bodies 0 and 1: two are needed");
}

Json checked(const reference::Certificate& certificate, const Scene& scene) {
  const std::string wrong = reference::check(certificate, scene);
  if (!wrong.empty()) throw std::logic_error("the certificate does not prove its verdict: " + wrong);
  Json pairs = Json::array();
  for (std::size_t i = 0; i < certificate.pairs.size(); ++i) {
    pairs.push_back({{"A", certificate.pairs[i].first},
                     {"B", certificate.pairs[i].second},
                     {"weight", i < certificate.weights.size() ? certificate.weights[i].text() : ""}});
  }
  return {{"says", text(certificate)},
          {"direction", json_of(certificate.direction)},
          {"pairs", std::move(pairs)},
          {"checked", "by the independent checker: holds"}};
}

Json distance(const Scene& scene) {
  require_pair(scene);
  const reference::DistanceTruth truth = reference::distance(scene);
  Json json = {{"verdict", text(truth.verdict)},
               {"distance", truth.distance.lo},
               {"distance_enclosure", json_of(truth.distance)},
               {"squared_distance_of_cores", json_of(truth.core_squared)},
               {"radius_sum", json_of(truth.radius_sum)},
               {"witness_A", touchstone::json_of(truth.p_WCa)},
               {"witness_B", touchstone::json_of(truth.p_WCb)},
               {"feature_A", json_of(truth.feature_A)},
               {"feature_B", json_of(truth.feature_B)},
               {"certificate", checked(truth.certificate, scene)}};
  return json;
}

Json penetration(const Scene& scene) {
  require_pair(scene);
  const reference::PenetrationTruth truth = reference::penetration(scene);
  return {{"verdict", text(truth.verdict)},
          {"depth", truth.depth.lo},
          {"depth_enclosure", json_of(truth.depth)},
          {truth.cores_overlap ? "squared_depth_of_cores" : "squared_distance_of_cores", json_of(truth.core_squared)},
          {"radius_sum", json_of(truth.radius_sum)},
          {"direction", json_of(truth.direction)},
          {"direction_unit", touchstone::json_of(truth.nhat_BA_W)}};
}

Json corner(const std::array<Rational, 3>& c) { return {c[0].text(), c[1].text(), c[2].text()}; }

Json bounds(const Scene& scene) {
  Json boxes = Json::array();
  const std::vector<reference::ExactBox> exact = reference::bounds(scene);
  for (std::size_t b = 0; b < exact.size(); ++b) {
    Json nearest = Json::array();
    for (const auto& end : {exact[b].lo, exact[b].hi}) {
      nearest.push_back({end[0].nearest(), end[1].nearest(), end[2].nearest()});
    }
    boxes.push_back({{"body", b}, {"nearest", nearest}, {"lo", corner(exact[b].lo)}, {"hi", corner(exact[b].hi)}});
  }
  return {{"boxes", std::move(boxes)}};
}

Json broad_phase(const Scene& scene) {
  return {{"overlapping_boxes", touchstone::json_of(reference::broad_phase(scene))}};
}

template <std::size_t n>
Json json_of(const std::array<Interval, n>& intervals) {
  Json all = Json::array();
  for (const Interval& interval : intervals) all.push_back(json_of(interval));
  return all;
}

Json mass(const Scene& scene) {
  Json bodies = Json::array();
  const auto truths = reference::mass(scene);
  for (std::size_t b = 0; b < truths.size(); ++b) {
    if (!truths[b]) {
      bodies.push_back({{"body", b}, {"fixed", true}});
      continue;
    }
    bodies.push_back({{"body", b},
                      {"mass", json_of(truths[b]->mass)},
                      {"centre_of_mass", json_of(truths[b]->p_BBcm)},
                      {"inertia_xx_yy_zz_xy_xz_yz", json_of(truths[b]->I_BBcm_B)}});
  }
  return {{"bodies", std::move(bodies)}};
}

const std::map<std::string, Show>& shows() {
  static const std::map<std::string, Show> all = {{"mass", mass},
                                                  {"bounds", bounds},
                                                  {"broad_phase", broad_phase},
                                                  {"distance", distance},
                                                  {"penetration", penetration}};
  return all;
}

std::string as_words(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

void print(const Json& json, const std::string& indent) {
  for (const auto& [key, value] : json.items()) {
    const bool list_of_objects = value.is_array() && !value.empty() && value[0].is_object();
    if (!value.is_object() && !list_of_objects) {
      fmt::print("{}{:<26} {}\n", indent, key, as_words(value));
    } else if (value.is_object()) {
      fmt::print("{}{}\n", indent, key);
      print(value, indent + "  ");
    } else {
      for (const Json& item : value) {
        fmt::print("{}{}\n", indent, key);
        print(item, indent + "  ");
      }
    }
  }
}

/// What only geometry shows to be wrong with a scene has its file's name before it too.
Json answered(const std::string& query, const Scene& scene, const std::string& path) try {
  return shows().at(query)(reference::completed(scene));
} catch (const InputError& error) {
  throw InputError(path, error.what());
}

}  // namespace

const std::vector<std::string>& queries() {
  static const std::vector<std::string> all = {"mass", "bounds", "broad_phase", "distance", "penetration"};
  return all;
}

void ask(const std::string& query, const std::string& scene_path, bool as_json) {
  const Scene scene = read_scene(scene_path);
  const Json answer = answered(query, scene, scene_path);
  if (as_json) {
    fmt::print("{}", text_of(answer));
  } else {
    print(answer, "");
  }
}

}  // namespace touchstone::app
