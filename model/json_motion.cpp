// Times of impact and trajectories as JSON.
#include <array>

#include "model/json_node.h"

namespace touchstone {
namespace {

using touchstone::json_of;
using Status = TimeOfImpact::Status;
using Kind = Event::Kind;

constexpr std::array<std::pair<Status, const char*>, 3> status_words = {
    {{Status::hit, "hit"}, {Status::miss, "miss"}, {Status::undecided, "undecided"}}};

constexpr std::array<std::pair<Kind, const char*>, 6> kind_words = {{{Kind::impact, "impact"},
                                                                     {Kind::micro_collision, "micro_collision"},
                                                                     {Kind::completed, "completed"},
                                                                     {Kind::contact, "contact"},
                                                                     {Kind::release, "release"},
                                                                     {Kind::force, "force"}}};

template <class Value, std::size_t n>
const char* word_of(Value value, const std::array<std::pair<Value, const char*>, n>& words) {
  return words[static_cast<std::size_t>(value)].second;
}

template <class Value, std::size_t n>
Value read_word(const Node& node, const std::array<std::pair<Value, const char*>, n>& words) {
  const std::string word = node.text();
  std::string known;
  for (const auto& [value, name] : words) {
    if (word == name) return value;
    known += (known.empty() ? "" : ", ") + Json(name).dump();
  }
  node.refuse("expected one of " + known + ", found " + Json(word).dump());
}

Json json_of(const State& state) { return {{"X_WB", json_of(state.X_WB)}, {"velocity", json_of(state.velocity)}}; }

State read_state(const Node& node) {
  node.expect_object({"X_WB", "velocity"});
  return {read_pose(node.at("X_WB")), read_velocity(node.at("velocity"))};
}

Event read_event(const Node& node) {
  node.expect_object({"kind", "time", "a", "b", "p_WC", "nhat_BA_W", "P_A_W", "after_a", "after_b"});
  if (node.at("kind").text() == "push") node.at("kind").refuse("the kind \"push\" is \"force\" now");
  Event event;
  event.kind = read_word(node.at("kind"), kind_words);
  event.time = node.at("time").number();
  event.a = node.at("a").index();
  event.after_a = read_state(node.at("after_a"));
  if (const auto b = node.find("b")) {
    event.b = b->index();
    event.p_WC = read_vec3(node.at("p_WC"));
    event.nhat_BA_W = read_vec3(node.at("nhat_BA_W"));
    event.P_A_W = read_vec3(node.at("P_A_W"));
    event.after_b = read_state(node.at("after_b"));
  }
  return event;
}

ContactSolver read_contact_solver(const Node& node) {
  node.expect_object({"steps", "unconverged", "residual"});
  return {node.at("steps").index(), node.at("unconverged").index(), node.at("residual").number()};
}

}  // namespace

Json json_of(const Event& event) {
  Json json = {{"kind", word_of(event.kind, kind_words)}, {"time", event.time}, {"a", event.a}};
  if (event.b >= 0) {
    json["b"] = event.b;
    json["p_WC"] = json_of(event.p_WC);
    json["nhat_BA_W"] = json_of(event.nhat_BA_W);
    json["P_A_W"] = json_of(event.P_A_W);
  }
  json["after_a"] = json_of(event.after_a);
  if (event.b >= 0) json["after_b"] = json_of(event.after_b);
  return json;
}

Json json_of(const TimeOfImpact& answer) {
  Json json = {{"status", word_of(answer.status, status_words)}};
  if (answer.time) json["time"] = *answer.time;
  if (answer.enclosure) json["enclosure"] = {answer.enclosure->lo, answer.enclosure->hi};
  if (answer.gap) json["gap"] = *answer.gap;
  return json;
}

Json json_of(const Trajectory& answer) {
  Json states = Json::array();
  for (const std::vector<State>& bodies : answer.states) {
    Json row = Json::array();
    for (const State& state : bodies) row.push_back(json_of(state));
    states.push_back(std::move(row));
  }
  Json json = {{"states", std::move(states)}};
  if (answer.events) {
    json["events"] = Json::array();
    for (const Event& event : *answer.events) json["events"].push_back(json_of(event));
  }
  if (answer.complete_until) json["complete_until"] = *answer.complete_until;
  if (!answer.gave_up.empty()) json["gave_up"] = answer.gave_up;
  if (const auto& solver = answer.contact_solver) {
    json["contact_solver"] = {
        {"steps", solver->steps}, {"unconverged", solver->unconverged}, {"residual", solver->residual}};
  }
  return json;
}

template <>
TimeOfImpact read<TimeOfImpact>(const Json& json, const std::string& place) {
  const Node node(json, place);
  node.expect_object({"status", "time", "enclosure", "gap"});
  TimeOfImpact answer;
  answer.status = read_word(node.at("status"), status_words);
  if (const auto time = node.find("time")) answer.time = time->number();
  if (const auto enclosure = node.find("enclosure")) {
    enclosure->expect_size(2);
    answer.enclosure = {(*enclosure)[0].number(), (*enclosure)[1].number()};
  }
  if (const auto gap = node.find("gap")) answer.gap = gap->number();
  return answer;
}

template <>
Trajectory read<Trajectory>(const Json& json, const std::string& place) {
  const Node node(json, place);
  node.expect_object({"states", "events", "complete_until", "gave_up", "contact_solver"});
  Trajectory answer;
  const Node states = node.at("states");
  for (int i = 0; i < states.size(); ++i) {
    const Node row = states[i];
    std::vector<State>& bodies = answer.states.emplace_back();
    for (int j = 0; j < row.size(); ++j) bodies.push_back(read_state(row[j]));
  }
  if (const auto events = node.find("events")) {
    answer.events.emplace();
    for (int i = 0; i < events->size(); ++i) answer.events->push_back(read_event((*events)[i]));
  }
  if (const auto until = node.find("complete_until")) answer.complete_until = until->number();
  if (const auto why = node.find("gave_up")) answer.gave_up = why->text();
  if (const auto solver = node.find("contact_solver")) answer.contact_solver = read_contact_solver(*solver);
  return answer;
}

}  // namespace touchstone
