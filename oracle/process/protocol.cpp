#include "oracle/process/protocol.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <utility>

#include "model/answer_text.h"
#include "model/json_node.h"

namespace touchstone::oracle::protocol {
namespace {

const std::string request_place = "request";
const std::string introduction_place = "introduction";
const std::string answer_place = "answer";

template <class Enum, std::size_t n>
using Words = std::array<std::pair<Enum, const char*>, n>;

constexpr Words<Precision, 3> precisions = {
    {{Precision::exact, "exact"}, {Precision::binary64, "binary64"}, {Precision::binary32, "binary32"}}};
constexpr Words<Breaks::Kind, 5> kinds = {{{Breaks::Kind::threw, "threw"},
                                           {Breaks::Kind::crashed, "crashed"},
                                           {Breaks::Kind::hung, "hung"},
                                           {Breaks::Kind::garbage, "garbage"},
                                           {Breaks::Kind::refused, "refused"}}};
constexpr Words<Request::Op, 5> ops = {{{Request::Op::start, "start"},
                                        {Request::Op::ask, "ask"},
                                        {Request::Op::reproduce, "reproduce"},
                                        {Request::Op::work, "work"},
                                        {Request::Op::stop, "stop"}}};

constexpr Words<BoxKind, 3> box_kinds = {
    {{BoxKind::tight, "tight"}, {BoxKind::of_turned_box, "of_turned_box"}, {BoxKind::of_ball, "of_ball"}}};
constexpr Words<Combine, 5> combinations = {{{Combine::min, "min"},
                                             {Combine::max, "max"},
                                             {Combine::product, "product"},
                                             {Combine::mean, "mean"},
                                             {Combine::geometric_mean, "geometric_mean"}}};
constexpr Words<bool, 2> frictions = {{{false, "cone"}, {true, "pyramid"}}};

template <class Enum, std::size_t n>
const char* word_of(Enum value, const Words<Enum, n>& words) {
  return words[static_cast<std::size_t>(value)].second;
}

template <class Enum, std::size_t n>
Enum read_word(const Node& node, const Words<Enum, n>& words) {
  const std::string word = node.text();
  std::string known;
  for (const auto& [value, name] : words) {
    if (word == name) return value;
    known += std::string(known.empty() ? "" : ", ") + '"' + name + '"';
  }
  node.refuse("expected one of " + known + ", found " + Json(word).dump());
}

/// Messages of engines may contain any bytes.
std::string line_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n'; }

std::string text_or(const Node& object, const char* key, const std::string& fallback) {
  const auto said = object.find(key);
  return said ? said->text() : fallback;
}

Deviation read_deviation(const Node& node) {
  node.expect_object({"clause", "what", "link"});
  return {text_or(node, "clause", ""), node.at("what").text(), text_or(node, "link", "")};
}

double read_limit(const Node& node) {
  const double limit = node.number();
  if (!(limit >= 0)) node.refuse("expected a number of at least 0");
  return limit;
}

std::uint64_t read_count(const Node& node) {
  const double count = node.number();
  if (!(count >= 0 && count < 0x1p64 && count == std::floor(count)))
    node.refuse("expected a whole number from 0 to 2^64 - 1");
  return static_cast<std::uint64_t>(count);
}

void read_limit(const Node& object, const char* key, std::optional<double>& limit) {
  if (const auto found = object.find(key)) limit = read_limit(*found);
}

void read_limits(const Node& object, const char* key, std::optional<Interval>& limits) {
  const auto found = object.find(key);
  if (!found) return;
  found->expect_size(2);
  limits = Interval{read_limit((*found)[0]), read_limit((*found)[1])};
}

double limit_or_0(const Node& object, const char* key) {
  const auto found = object.find(key);
  return found ? read_limit(*found) : 0;
}

Domain read_domain(const Node& node) {
  node.expect_object({"lengths", "fixed_lengths", "reach", "aspect", "vertices", "mass_ratio", "speed", "angular_speed",
                      "lowest_speed"});
  Domain domain;
  read_limits(node, "lengths", domain.lengths);
  read_limits(node, "fixed_lengths", domain.fixed_lengths);
  if (const auto vertices = node.find("vertices")) domain.vertices = vertices->index();
  read_limit(node, "reach", domain.reach);
  read_limit(node, "aspect", domain.aspect);
  read_limit(node, "mass_ratio", domain.mass_ratio);
  read_limit(node, "speed", domain.speed);
  read_limit(node, "angular_speed", domain.angular_speed);
  read_limit(node, "lowest_speed", domain.lowest_speed);
  return domain;
}

DistanceTolerance read_distance_tolerance(const Node& node) {
  node.expect_object({"absolute", "relative", "slop", "margin"});
  return {limit_or_0(node, "absolute"), limit_or_0(node, "relative"), limit_or_0(node, "slop"),
          limit_or_0(node, "margin")};
}

ContactTolerance read_contact_tolerance(const Node& node) {
  node.expect_object({"absolute", "size", "way"});
  return {limit_or_0(node, "absolute"), limit_or_0(node, "size"), limit_or_0(node, "way")};
}

std::vector<std::string> read_texts(const Node& node) {
  std::vector<std::string> texts;
  for (int i = 0; i < node.size(); ++i) texts.push_back(node[i].text());
  return texts;
}

template <class Enum, std::size_t n>
void read_word(const Node& object, const char* key, Enum& value, const Words<Enum, n>& words) {
  if (const auto found = object.find(key)) value = read_word(*found, words);
}

Dynamics read_dynamics(const Node& node) {
  node.expect_object({"combines", "restitution_threshold", "friction", "damping", "speed_limits", "sleep"});
  Dynamics dynamics;
  if (const auto combines = node.find("combines")) {
    combines->expect_object({"restitution", "friction"});
    read_word(*combines, "restitution", dynamics.restitution, combinations);
    read_word(*combines, "friction", dynamics.friction, combinations);
  }
  dynamics.restitution_threshold = limit_or_0(node, "restitution_threshold");
  read_word(node, "friction", dynamics.friction_pyramid, frictions);
  if (const auto damping = node.find("damping")) {
    damping->expect_object({"linear", "angular"});
    dynamics.linear_damping = limit_or_0(*damping, "linear");
    dynamics.angular_damping = limit_or_0(*damping, "angular");
  }
  if (const auto limits = node.find("speed_limits")) {
    limits->expect_object({"linear", "angular"});
    read_limit(*limits, "linear", dynamics.speed_limit);
    read_limit(*limits, "angular", dynamics.angular_speed_limit);
  }
  if (const auto sleep = node.find("sleep")) {
    sleep->expect_object({"speed", "angular_speed", "seconds"});
    dynamics.sleep = {read_limit(sleep->at("speed")), read_limit(sleep->at("angular_speed")),
                      read_limit(sleep->at("seconds"))};
  }
  return dynamics;
}

std::map<std::string, Precision> read_precision_of(const Node& node) {
  const std::initializer_list<std::string_view> parts = {
      "mass",           "bounds",     "broad_phase", "pair_history", "distance", "penetration", "impulse", "pixel",
      "time_of_impact", "simulation", "constraint",  "sphere",       "box",      "polytope",    "compound"};
  node.expect_object(parts);
  std::map<std::string, Precision> precision_of;
  for (const std::string_view part : parts) {
    if (const auto found = node.find(part)) precision_of[std::string(part)] = read_word(*found, precisions);
  }
  return precision_of;
}

Stepping read_stepping(const Node& node) {
  node.expect_object({"step", "order"});
  const Stepping stepping{node.at("step").number(), node.at("order").index()};
  if (!(stepping.step > 0)) node.at("step").refuse("expected a number above 0");
  if (stepping.order != 1 && stepping.order != 2) node.at("order").refuse("expected 1 or 2");
  return stepping;
}

WorkLimit read_work_limit(const Node& node) {
  node.expect_object({"query", "count", "base", "per", "placements"});
  WorkLimit limit{node.at("query").text(), node.at("count").text(), limit_or_0(node, "base")};
  if (const auto per = node.find("per")) {
    for (const std::string& name : per->keys()) limit.per[name] = read_limit(per->at(name));
  }
  if (const auto placements = node.find("placements")) limit.placements = placements->index();
  return limit;
}

Card read_card(const Node& node) {
  node.expect_object({"name", "version", "precision", "answers", "knows_touching", "broad_phase_margin", "domain",
                      "distance_tolerance", "contact_tolerance", "boxes", "precision_of", "dynamics", "reproduces",
                      "stepping", "work_limits", "about", "homepage", "deviations"});
  Card card;
  card.name = node.at("name").text();
  card.version = node.at("version").text();
  card.precision = read_word(node.at("precision"), precisions);
  card.answers = read_texts(node.at("answers"));
  if (const auto knows = node.find("knows_touching")) card.knows_touching = knows->truth();
  if (const auto margin = node.find("broad_phase_margin")) card.broad_phase_margin = read_limit(*margin);
  if (const auto domain = node.find("domain")) card.domain = read_domain(*domain);
  if (const auto tolerance = node.find("distance_tolerance")) {
    card.distance_tolerance = read_distance_tolerance(*tolerance);
  }
  if (const auto tolerance = node.find("contact_tolerance")) {
    card.contact_tolerance = read_contact_tolerance(*tolerance);
  }
  read_word(node, "boxes", card.boxes, box_kinds);
  if (const auto precision_of = node.find("precision_of")) card.precision_of = read_precision_of(*precision_of);
  if (const auto dynamics = node.find("dynamics")) card.dynamics = read_dynamics(*dynamics);
  if (const auto reproduces = node.find("reproduces")) card.reproduces = read_texts(*reproduces);
  if (const auto stepping = node.find("stepping")) card.stepping = read_stepping(*stepping);
  if (const auto limits = node.find("work_limits")) {
    for (int i = 0; i < limits->size(); ++i) card.work_limits.push_back(read_work_limit((*limits)[i]));
  }
  card.about = text_or(node, "about", "");
  card.homepage = text_or(node, "homepage", "");
  if (const auto deviations = node.find("deviations")) {
    for (int i = 0; i < deviations->size(); ++i) card.deviations.push_back(read_deviation((*deviations)[i]));
  }
  return card;
}

void expect_seq(const Node& node, Seq seq) {
  const Node said = node.at("seq");
  if (said.number() != static_cast<double>(seq)) said.refuse("not that of the question");
}

Breaks read_breaks(const Node& node) {
  node.expect_object({"kind", "how"});
  return {read_word(node.at("kind"), kinds), node.at("how").text()};
}

/// The part that `key` names, or what the subject says in its place.
template <class T, class Read>
Answer<T> read_part(std::string_view line, Seq seq, const char* key, Read&& read) {
  const Json json = parse_answer(line, answer_place);
  const Node node(json, answer_place);
  node.expect_object({"seq", key, "abstains", "breaks"});
  expect_seq(node, seq);
  if (json.size() != 2)
    node.refuse(std::string("expected \"seq\" and one of \"") + key + "\", \"abstains\", \"breaks\"");
  if (const auto abstains = node.find("abstains")) return Abstains{abstains->text()};
  if (const auto breaks = node.find("breaks")) return read_breaks(*breaks);
  return read(json[key], key);
}

/// `more`: further members, each after a comma.
std::string question(const char* op, Seq seq, std::string_view query, std::string_view scene_json,
                     std::string_view more = "") {
  std::string line = R"({"op":")" + std::string(op) + R"(","seq":)" + std::to_string(seq) + R"(,"query":")";
  return line.append(query).append(R"(","scene":)").append(scene_json).append(more).append("}\n");
}

}  // namespace

Json json_of(const Domain& domain) {
  Json json = Json::object();
  if (domain.lengths) json["lengths"] = {domain.lengths->lo, domain.lengths->hi};
  if (domain.fixed_lengths) json["fixed_lengths"] = {domain.fixed_lengths->lo, domain.fixed_lengths->hi};
  if (domain.reach) json["reach"] = *domain.reach;
  if (domain.aspect) json["aspect"] = *domain.aspect;
  if (domain.vertices) json["vertices"] = *domain.vertices;
  if (domain.mass_ratio) json["mass_ratio"] = *domain.mass_ratio;
  if (domain.speed) json["speed"] = *domain.speed;
  if (domain.angular_speed) json["angular_speed"] = *domain.angular_speed;
  if (domain.lowest_speed) json["lowest_speed"] = *domain.lowest_speed;
  return json;
}

Json json_of(const DistanceTolerance& tolerance) {
  return {{"absolute", tolerance.absolute},
          {"relative", tolerance.relative},
          {"slop", tolerance.slop},
          {"margin", tolerance.margin}};
}

Json json_of(const ContactTolerance& tolerance) {
  return {{"absolute", tolerance.absolute}, {"size", tolerance.size}, {"way", tolerance.way}};
}

Json json_of(const Dynamics& dynamics) {
  Json json = Json::object();
  if (dynamics.restitution != Combine::min)
    json["combines"]["restitution"] = word_of(dynamics.restitution, combinations);
  if (dynamics.friction != Combine::min) json["combines"]["friction"] = word_of(dynamics.friction, combinations);
  if (dynamics.restitution_threshold > 0) json["restitution_threshold"] = dynamics.restitution_threshold;
  if (dynamics.friction_pyramid) json["friction"] = word_of(dynamics.friction_pyramid, frictions);
  if (dynamics.linear_damping > 0) json["damping"]["linear"] = dynamics.linear_damping;
  if (dynamics.angular_damping > 0) json["damping"]["angular"] = dynamics.angular_damping;
  if (dynamics.speed_limit) json["speed_limits"]["linear"] = *dynamics.speed_limit;
  if (dynamics.angular_speed_limit) json["speed_limits"]["angular"] = *dynamics.angular_speed_limit;
  if (const auto& sleep = dynamics.sleep) {
    json["sleep"] = {{"speed", sleep->speed}, {"angular_speed", sleep->angular_speed}, {"seconds", sleep->seconds}};
  }
  return json;
}

Json json_of(const std::map<std::string, Precision>& precision_of) {
  Json json = Json::object();
  for (const auto& [part, precision] : precision_of) json[part] = word_of(precision, precisions);
  return json;
}

Json json_of(const WorkLimit& limit) {
  return {{"query", limit.query},
          {"count", limit.count},
          {"base", limit.base},
          {"per", limit.per},
          {"placements", limit.placements}};
}

Json json_of(const Card& card) {
  Json deviations = Json::array();
  for (const Deviation& known : card.deviations) {
    deviations.push_back({{"clause", known.clause}, {"what", known.what}, {"link", known.link}});
  }
  Json json = {{"name", card.name},
               {"version", card.version},
               {"precision", word_of(card.precision, precisions)},
               {"answers", card.answers},
               {"knows_touching", card.knows_touching},
               {"broad_phase_margin", card.broad_phase_margin},
               {"domain", json_of(card.domain)},
               {"distance_tolerance", json_of(card.distance_tolerance)},
               {"contact_tolerance", json_of(card.contact_tolerance)},
               {"boxes", word_of(card.boxes, box_kinds)},
               {"precision_of", json_of(card.precision_of)},
               {"dynamics", json_of(card.dynamics)},
               {"reproduces", card.reproduces},
               {"about", card.about},
               {"homepage", card.homepage},
               {"deviations", std::move(deviations)}};
  for (const WorkLimit& limit : card.work_limits) json["work_limits"].push_back(json_of(limit));
  if (card.stepping) json["stepping"] = {{"step", card.stepping->step}, {"order", card.stepping->order}};
  return json;
}

std::string start(Seq seq) { return line_of({{"op", "start"}, {"seq", seq}, {"protocol", version}}); }

std::string ask(Seq seq, std::string_view query, std::string_view scene_json) {
  return question("ask", seq, query, scene_json);
}

std::string reproduce(Seq seq, std::string_view query, std::string_view scene_json, std::string_view expected) {
  if (expected.empty()) return question("reproduce", seq, query, scene_json);
  const std::string quoted = Json(expected).dump(-1, ' ', false, Json::error_handler_t::replace);
  return question("reproduce", seq, query, scene_json, R"(,"expected":)" + quoted);
}

std::string work(Seq seq, std::string_view query, std::string_view scene_json) {
  return question("work", seq, query, scene_json);
}

std::string stop(Seq seq) { return line_of({{"op", "stop"}, {"seq", seq}}); }

std::string introduction(Seq seq, const Card& card) {
  return line_of({{"seq", seq}, {"protocol", version}, {"card", json_of(card)}});
}

std::string answer(Seq seq, const Json& result) { return line_of({{"seq", seq}, {"result", result}}); }

std::string snippet(Seq seq, const std::string& program) { return line_of({{"seq", seq}, {"snippet", program}}); }

std::string work(Seq seq, const Work& counts) { return line_of({{"seq", seq}, {"work", counts}}); }

std::string answer(Seq seq, const Abstains& abstains) { return line_of({{"seq", seq}, {"abstains", abstains.why}}); }

std::string answer(Seq seq, const Breaks& breaks) {
  return line_of({{"seq", seq}, {"breaks", {{"kind", word_of(breaks.kind, kinds)}, {"how", breaks.how}}}});
}

Request read_request(std::string_view line) {
  const Json json = parse(line, request_place);
  const Node node(json, request_place);
  Request request;
  request.op = read_word(node.at("op"), ops);
  request.seq = node.at("seq").index();
  if (request.op != Request::Op::start && request.op != Request::Op::stop) {
    if (request.op == Request::Op::reproduce) {
      node.expect_object({"op", "seq", "query", "scene", "expected"});
      request.expected = text_or(node, "expected", "");
    } else {
      node.expect_object({"op", "seq", "query", "scene"});
    }
    request.query = node.at("query").text();
    node.at("scene");
    request.scene = read<Scene>(json["scene"], "scene");
  } else if (request.op == Request::Op::start) {
    node.expect_object({"op", "seq", "protocol"});
    if (node.at("protocol").index() != version) node.at("protocol").refuse("expected " + std::to_string(version));
  } else {
    node.expect_object({"op", "seq"});
  }
  return request;
}

Seq seq_of(std::string_view line) try {
  const Json json = parse(line, request_place);
  return Node(json, request_place).at("seq").index();
} catch (const InputError&) {
  return 0;
}

Card read_introduction(std::string_view line, Seq seq) {
  const Json json = parse_answer(line, introduction_place);
  const Node node(json, introduction_place);
  if (const auto breaks = node.find("breaks")) node.refuse("it breaks: " + read_breaks(*breaks).how);
  node.expect_object({"seq", "protocol", "card"});
  expect_seq(node, seq);
  if (node.at("protocol").index() != version) node.at("protocol").refuse("expected " + std::to_string(version));
  return read_card(node.at("card"));
}

template <class T>
Answer<T> read_answer(std::string_view line, Seq seq) {
  return read_part<T>(line, seq, "result", [](const Json& json, const char* place) { return read<T>(json, place); });
}

Answer<std::string> read_snippet(std::string_view line, Seq seq) {
  return read_part<std::string>(line, seq, "snippet",
                                [](const Json& json, const char* place) { return Node(json, place).text(); });
}

Answer<Work> read_work(std::string_view line, Seq seq) {
  return read_part<Work>(line, seq, "work", [](const Json& json, const char* place) {
    const Node node(json, place);
    Work counts;
    for (const std::string& name : node.keys()) counts[name] = read_count(node.at(name));
    return counts;
  });
}

template Answer<Masses> read_answer<Masses>(std::string_view, Seq);
template Answer<Bounds> read_answer<Bounds>(std::string_view, Seq);
template Answer<PairSet> read_answer<PairSet>(std::string_view, Seq);
template Answer<PairHistory> read_answer<PairHistory>(std::string_view, Seq);
template Answer<Distance> read_answer<Distance>(std::string_view, Seq);
template Answer<Penetration> read_answer<Penetration>(std::string_view, Seq);
template Answer<Impulse> read_answer<Impulse>(std::string_view, Seq);
template Answer<Pixels> read_answer<Pixels>(std::string_view, Seq);
template Answer<TimeOfImpact> read_answer<TimeOfImpact>(std::string_view, Seq);
template Answer<Trajectory> read_answer<Trajectory>(std::string_view, Seq);

}  // namespace touchstone::oracle::protocol
