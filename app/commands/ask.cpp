#include "app/commands/ask.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "app/motion/given_scene.h"
#include "app/report/body_name.h"
#include "app/system/terminal.h"
#include "model/input_error.h"
#include "model/json.h"
#include "model/sequence.h"
#include "oracle/judge/words.h"
#include "oracle/query.h"
#include "reference/bounds.h"
#include "reference/broad_phase.h"
#include "reference/constraint.h"
#include "reference/distance.h"
#include "reference/impulse.h"
#include "reference/mass.h"
#include "reference/penetration.h"
#include "reference/pixel.h"
#include "reference/time_of_impact.h"

namespace touchstone::app {
namespace {

using oracle::words::text;
using reference::Rational;

/// Returns the JSON object that is printed; its texts are also meant for people.
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

/// The double nearest to the distance: one of the two doubles that enclose it. The middle of the two decides which.
double nearest_distance(const reference::DistanceTruth& truth) {
  const Rational middle = (Rational(truth.distance.lo) + Rational(truth.distance.hi)) / Rational(2);
  const Rational core = middle + truth.radius_sum;
  return truth.core_squared > core * core ? truth.distance.hi : truth.distance.lo;
}

Json distance(const Scene& scene) {
  require_pair(scene);
  const reference::DistanceTruth truth = reference::distance(scene);
  Json json = {{"verdict", text(truth.verdict)},
               {"distance", nearest_distance(truth)},
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

Json corner(const std::array<Rational, 3>& exact) {
  return {{"exact", {exact[0].text(), exact[1].text(), exact[2].text()}},
          {"nearest", {exact[0].nearest(), exact[1].nearest(), exact[2].nearest()}}};
}

Json bounds(const Scene& scene) {
  Json boxes = Json::array();
  for (const reference::ExactBox& box : reference::bounds(scene)) {
    boxes.push_back({{"body", boxes.size()}, {"lo", corner(box.lo)}, {"hi", corner(box.hi)}});
  }
  return {{"boxes", std::move(boxes)}};
}

/// Of a sequence, the pairs of each frame.
Json broad_phase(const Scene& scene) {
  if (is_sequence(scene)) {
    return {{"frames", touchstone::json_of(reference::pair_history(reference::sequence_bounds(scene)))}};
  }
  return {{"overlapping_boxes", touchstone::json_of(reference::broad_phase(scene))}};
}

template <std::size_t n>
Json named(const std::array<Interval, n>& intervals, const std::array<const char*, n>& names) {
  Json all;
  for (std::size_t i = 0; i < n; ++i) all[names[i]] = json_of(intervals[i]);
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
                      {"centre_of_mass", named(truths[b]->p_BBcm, {"x", "y", "z"})},
                      {"inertia", named(truths[b]->I_BBcm_B, {"xx", "yy", "zz", "xy", "xz", "yz"})}});
  }
  return {{"bodies", std::move(bodies)}};
}

Json pixel(const Scene& scene) { return touchstone::json_of(reference::pixel(scene)); }

Json json_of(const reference::ExactVec3& v) {
  Json exact = Json::array(), nearest = Json::array();
  for (const Rational& x : v) exact.push_back(x.text()), nearest.push_back(x.nearest());
  return {{"exact", std::move(exact)}, {"nearest", std::move(nearest)}};
}

/// The modes that occurred, in words.
std::string words_of(const reference::ImpulseTruth::Modes& m) {
  const std::vector<std::pair<bool, const char*>> all = {{m.separating, "separating"},
                                                         {m.frictionless, "frictionless"},
                                                         {m.stuck_from_start, "stuck from the start"},
                                                         {m.straight, "slips along a line"},
                                                         {m.slip_stops_in_compression, "slip stops in compression"},
                                                         {m.slip_stops_in_restitution, "slip stops in restitution"},
                                                         {m.sticks, "sticks"},
                                                         {m.reversal, "slip reverses"},
                                                         {m.diverges, "slips off again"},
                                                         {m.recompressed, "compressed again"},
                                                         {m.painleve, "friction can press the bodies together"}};
  std::string words;
  for (const auto& [met, word] : all) {
    if (met) words += (words.empty() ? "" : ", ") + std::string(word);
  }
  return words.empty() ? "slip turns" : words;
}

/// If a rational is only an approximation, its digits are not shown, but the nearest double.
Json impulse(const Scene& scene) {
  const reference::ImpulseTruth truth = reference::impulse(scene);
  const auto shown = [&](const reference::ExactVec3& v) {
    return truth.certified && truth.error == 0 ? json_of(v) : json_of(v)["nearest"];
  };
  Json json = {{"modes", words_of(truth.modes)},
               {"P_A_W", shown(truth.P_A_W)},
               {"p_c", truth.p_c.nearest()},
               {"p_f", truth.p_f.nearest()}};
  for (const std::size_t b : {0U, 1U}) {
    const char* key = b == 0 ? "after_A" : "after_B";
    json[key] = {{"v_WBcm", shown(truth.after[b].v_WBcm)}, {"w_WB", shown(truth.after[b].w_WB)}};
  }
  json["certified"] = truth.certified;
  json["error"] = truth.error;
  if (truth.ambiguous) json["ambiguous"] = *truth.ambiguous;
  return json;
}

/// An enclosed time: both ends, their difference, and what is known there.
Json time_of_impact(const Scene& scene) {
  const reference::TimeOfImpactTruth truth = reference::time_of_impact(scene);
  using Status = TimeOfImpact::Status;
  const char* words = truth.status == Status::hit ? "hit" : truth.status == Status::miss ? "miss" : "undecided";
  Json json = {{"status", words}, {"apart_before", truth.time.lo}};
  if (truth.status == Status::hit) {
    json["met_by"] = truth.time.hi;
    json["width"] = truth.time.hi - truth.time.lo;
    json["at_start"] = truth.at_start ? "yes" : "no";
  }
  if (truth.status == Status::undecided && std::isfinite(truth.gap)) json["gap_at_most"] = truth.gap;
  if (truth.status != Status::miss) {
    json["p_WCa"] = touchstone::json_of(truth.p_WCa);
    json["p_WCb"] = touchstone::json_of(truth.p_WCb);
    json["nhat_BA_W"] = touchstone::json_of(truth.nhat_BA_W);
  }
  return json;
}

Json json_of(const std::array<Interval, 3>& v) { return {json_of(v[0]), json_of(v[1]), json_of(v[2])}; }

Json json_of(const reference::BallTruth& state) {
  return {{"p_WB", json_of(state.p_WB)}, {"v_WB", json_of(state.v_WB)}, {"w_WB", json_of(state.w_WB)}};
}

const char* name_of(reference::ConstraintTruth::Mode mode) {
  using Mode = reference::ConstraintTruth::Mode;
  return mode == Mode::ballistic ? "ballistic" : mode == Mode::sliding ? "sliding" : "rolling";
}

Json constraint(const Scene& scene) {
  const reference::ConstraintTruth truth = reference::constraint(scene);
  Json changes = Json::array(), states = Json::array();
  for (const reference::ConstraintTruth::Change& change : truth.changes) {
    using Kind = Event::Kind;
    const char* kind = change.kind == Kind::contact ? "contact" : change.kind == Kind::release ? "release" : "impact";
    changes.push_back({{"time", json_of(change.time)},
                       {"kind", kind},
                       {"other", change.other},
                       {"then", name_of(change.segment.mode)},
                       {"after", json_of(change.after)}});
  }
  for (const reference::BallTruth& state : truth.states) states.push_back(json_of(state));
  return {{"ball", truth.ball},
          {"first", name_of(truth.first.mode)},
          {"changes", std::move(changes)},
          {"states", std::move(states)}};
}

const std::map<std::string, Show>& shows() {
  static const std::map<std::string, Show> all = {{"mass", mass},
                                                  {"bounds", bounds},
                                                  {"broad_phase", broad_phase},
                                                  {"distance", distance},
                                                  {"penetration", penetration},
                                                  {"impulse", impulse},
                                                  {"pixel", pixel},
                                                  {"time_of_impact", time_of_impact},
                                                  {"constraint", constraint}};
  return all;
}

bool is_plain(const Json& value) {
  return !value.is_object() &&
         !(value.is_array() && std::ranges::any_of(value, [](const Json& item) { return item.is_structured(); }));
}

/// "(0, 1/3, 2)"; texts without quotes.
std::string as_words(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return text(value.get<double>());
  if (!value.is_array()) return value.dump();
  std::vector<std::string> items;
  for (const Json& item : value) items.push_back(as_words(item));
  return fmt::format("({})", fmt::join(items, ", "));
}

/// "A 0, B 7, weight 1/2"
std::string on_one_line(const Json& object) {
  std::vector<std::string> items;
  for (const auto& [key, value] : object.items()) items.push_back(key + ' ' + as_words(value));
  return fmt::format("{}", fmt::join(items, ", "));
}

void show(const Json& json, const std::string& indent);

void show(const std::string& key, const Json& value, const std::string& indent) {
  constexpr int column = 28;
  const auto line = [&](const std::string& words) {
    print("{}{:<{}} {}\n", indent, key, column - static_cast<int>(indent.size()), words);
  };
  if (is_plain(value)) {
    line(as_words(value));
  } else if (value.is_object() && std::ranges::all_of(value, is_plain) && value.size() <= 3) {
    line(on_one_line(value));
  } else if (value.is_object()) {
    print("{}{}\n", indent, key);
    show(value, indent + "  ");
  } else {
    for (const Json& item : value) item.is_object() ? show(key, item, indent) : line(as_words(item));
  }
}

void show(const Json& json, const std::string& indent) {
  for (const auto& [key, value] : json.items()) show(key, value, indent);
}

/// If the scene has more than two bodies, says in the answer which two were used.
Json with_pair(const std::string& query, const Scene& scene, const Json& answer) {
  if (scene.bodies.size() == 2 || !oracle::find_query(query)->about_two_bodies) return answer;
  const std::string pair = body_name(scene, 0) + " and " + body_name(scene, 1);
  Json with_names = {{"pair", fmt::format("{}, of {} bodies", pair, scene.bodies.size())}};
  with_names.update(answer);
  return with_names;
}

}  // namespace

void print_answer(const Json& answer, const std::string& indent) { show(answer, indent); }

const std::vector<std::string>& printed_queries() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> printed = oracle::query_names();
    std::erase_if(printed, [](const std::string& name) { return !shows().contains(name); });
    return printed;
  }();
  return names;
}

Json exact_answer(const std::string& query, const Scene& scene) {
  return with_pair(query, scene, shows().at(query)(scene));
}

void ask(const std::string& query, const std::string& name_or_file, bool as_json) {
  const GivenScene given = given_scene(name_or_file);
  Json answer;
  try {
    answer = exact_answer(query, given.scene);
  } catch (const InputError& error) {
    throw given.located(error);
  }
  if (as_json) {
    print_lines(touchstone::text_of(answer));
  } else {
    print_answer(answer, "");
  }
}

}  // namespace touchstone::app
