// Answers as JSON. A member for which a subject makes no claim is absent.
#include <array>

#include "model/json_node.h"

namespace touchstone {
namespace {

using touchstone::json_of;

constexpr std::array<std::pair<Verdict, const char*>, 3> verdict_words = {
    {{Verdict::separated, "separated"}, {Verdict::touching, "touching"}, {Verdict::overlapping, "overlapping"}}};

Json json_of(Verdict verdict) { return verdict_words[static_cast<std::size_t>(verdict)].second; }
Json json_of(double number) { return number; }
Json json_of(const Interval& interval) { return {interval.lo, interval.hi}; }
Json json_of(const Feature& feature) { return {{"part", feature.part}, {"vertices", feature.vertices}}; }

Json stated(const MassProperties& mass) {
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i) rows.push_back(json_of(Vec3(mass.I_BBcm_B.row(i))));
  return {{"mass", mass.mass}, {"p_BBcm", json_of(mass.p_BBcm)}, {"I_BBcm_B", std::move(rows)}};
}

template <class T>
void write_if_said(Json& json, const char* key, const std::optional<T>& value) {
  if (value) json[key] = json_of(*value);
}

Verdict read_verdict(const Node& node) {
  const std::string word = node.text();
  for (const auto& [verdict, name] : verdict_words) {
    if (word == name) return verdict;
  }
  node.refuse("expected \"separated\", \"touching\" or \"overlapping\", found " + Json(word).dump());
}

double read_number(const Node& node) { return node.number(); }

Interval read_interval(const Node& node) {
  node.expect_size(2);
  return {node[0].number(), node[1].number()};
}

Feature read_feature(const Node& node) {
  node.expect_object({"part", "vertices"});
  Feature feature{node.at("part").index(), {}};
  const Node vertices = node.at("vertices");
  for (int i = 0; i < vertices.size(); ++i) feature.vertices.push_back(vertices[i].index());
  return feature;
}

Aabb read_aabb(const Node& node) {
  node.expect_object({"lo", "hi"});
  return {read_vec3(node.at("lo")), read_vec3(node.at("hi"))};
}

PairSet read_pairs(const Node& node) {
  PairSet pairs;
  for (int i = 0; i < node.size(); ++i) {
    const Node item = node[i];
    item.expect_size(2);
    const std::pair<int, int> pair(item[0].index(), item[1].index());
    if (pair.first >= pair.second) item.refuse("expected the smaller index first");
    if (!pairs.empty() && pair <= pairs.back()) item.refuse("expected the pairs sorted, each once");
    pairs.push_back(pair);
  }
  return pairs;
}

Mask read_mask(const Node& node) {
  Mask mask;
  for (int i = 0; i < node.size(); ++i) {
    mask.push_back(node[i].text());
    if (mask.back().find_first_not_of("01") != std::string::npos) node[i].refuse("expected nothing but 0 and 1");
  }
  return mask;
}

std::vector<Mask> read_masks(const Node& node) {
  std::vector<Mask> masks;
  for (int i = 0; i < node.size(); ++i) masks.push_back(read_mask(node[i]));
  return masks;
}

template <class T>
void read_if_said(const Node& node, const char* key, T (*read_value)(const Node&), std::optional<T>& value) {
  if (const auto said = node.find(key)) value = read_value(*said);
}

}  // namespace

Vec3 read_vec3(const Node& node) {
  node.expect_size(3);
  return {node[0].number(), node[1].number(), node[2].number()};
}

Mat3 read_mat3(const Node& node) {
  node.expect_size(3);
  Mat3 matrix;
  for (int i = 0; i < 3; ++i) matrix.row(i) = read_vec3(node[i]).transpose();
  return matrix;
}

MassProperties read_mass_properties(const Node& node) {
  return {node.at("mass").number(), read_vec3(node.at("p_BBcm")), read_mat3(node.at("I_BBcm_B"))};
}

Velocity read_velocity(const Node& node) {
  node.expect_object({"v_WBcm", "w_WB"});
  return {read_vec3(node.at("v_WBcm")), read_vec3(node.at("w_WB"))};
}

Json json_of(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

Json json_of(const Velocity& velocity) {
  return {{"v_WBcm", json_of(velocity.v_WBcm)}, {"w_WB", json_of(velocity.w_WB)}};
}

Json json_of(const Masses& answer) {
  Json json = Json::array();
  for (const auto& mass : answer) json.push_back(mass ? stated(*mass) : Json());
  return json;
}

Json json_of(const Bounds& answer) {
  Json json = Json::array();
  for (const Aabb& box : answer) json.push_back({{"lo", json_of(box.lo)}, {"hi", json_of(box.hi)}});
  return json;
}

Json json_of(const PairSet& answer) {
  Json json = Json::array();
  for (const auto& [i, j] : answer) json.push_back({i, j});
  return json;
}

Json json_of(const PairHistory& answer) {
  Json json = Json::array();
  for (const PairFrame& frame : answer) {
    json.push_back({{"pairs", json_of(frame.pairs)}});
    write_if_said(json.back(), "begun", frame.begun);
    write_if_said(json.back(), "ended", frame.ended);
  }
  return json;
}

Json json_of(const Distance& answer) {
  Json json = Json::object();
  write_if_said(json, "verdict", answer.verdict);
  write_if_said(json, "distance", answer.distance);
  write_if_said(json, "p_WCa", answer.p_WCa);
  write_if_said(json, "p_WCb", answer.p_WCb);
  write_if_said(json, "feature_A", answer.feature_A);
  write_if_said(json, "feature_B", answer.feature_B);
  write_if_said(json, "enclosure", answer.enclosure);
  return json;
}

Json json_of(const Penetration& answer) {
  Json json = Json::object();
  write_if_said(json, "verdict", answer.verdict);
  write_if_said(json, "depth", answer.depth);
  write_if_said(json, "nhat_BA_W", answer.nhat_BA_W);
  return json;
}

Json json_of(const Impulse& answer) {
  Json json = {{"after", {json_of(answer.after[0]), json_of(answer.after[1])}}};
  write_if_said(json, "P_A_W", answer.P_A_W);
  write_if_said(json, "error", answer.error);
  write_if_said(json, "ambiguous", answer.ambiguous);
  return json;
}

Json json_of(const Pixels& answer) {
  Json overlap = {{"count", answer.overlap.count}};
  if (answer.overlap.first) overlap["first"] = {answer.overlap.first->first, answer.overlap.first->second};
  return {{"sampled", answer.sampled},
          {"conservative", answer.conservative},
          {"overlap", std::move(overlap)},
          {"meet_sampled", answer.meet_sampled},
          {"meet_conservative", answer.meet_conservative}};
}

template <>
Vec3 read<Vec3>(const Json& json, const std::string& place) {
  return read_vec3(Node(json, place));
}

template <>
Masses read<Masses>(const Json& json, const std::string& place) {
  const Node node(json, place);
  Masses masses;
  for (int i = 0; i < node.size(); ++i) {
    const Node item = node[i];
    if (item.is_null()) {
      masses.emplace_back();
      continue;
    }
    item.expect_object({"mass", "p_BBcm", "I_BBcm_B"});
    masses.emplace_back(read_mass_properties(item));
  }
  return masses;
}

template <>
Bounds read<Bounds>(const Json& json, const std::string& place) {
  const Node node(json, place);
  Bounds bounds;
  for (int i = 0; i < node.size(); ++i) bounds.push_back(read_aabb(node[i]));
  return bounds;
}

template <>
PairSet read<PairSet>(const Json& json, const std::string& place) {
  return read_pairs(Node(json, place));
}

template <>
PairHistory read<PairHistory>(const Json& json, const std::string& place) {
  const Node node(json, place);
  PairHistory history;
  for (int i = 0; i < node.size(); ++i) {
    const Node item = node[i];
    item.expect_object({"pairs", "begun", "ended"});
    PairFrame& frame = history.emplace_back(PairFrame{read_pairs(item.at("pairs")), {}, {}});
    read_if_said(item, "begun", read_pairs, frame.begun);
    read_if_said(item, "ended", read_pairs, frame.ended);
  }
  return history;
}

template <>
Distance read<Distance>(const Json& json, const std::string& place) {
  const Node node(json, place);
  node.expect_object({"verdict", "distance", "p_WCa", "p_WCb", "feature_A", "feature_B", "enclosure"});
  Distance answer;
  read_if_said(node, "verdict", read_verdict, answer.verdict);
  read_if_said(node, "distance", read_number, answer.distance);
  read_if_said(node, "p_WCa", read_vec3, answer.p_WCa);
  read_if_said(node, "p_WCb", read_vec3, answer.p_WCb);
  read_if_said(node, "feature_A", read_feature, answer.feature_A);
  read_if_said(node, "feature_B", read_feature, answer.feature_B);
  read_if_said(node, "enclosure", read_interval, answer.enclosure);
  return answer;
}

template <>
Penetration read<Penetration>(const Json& json, const std::string& place) {
  const Node node(json, place);
  node.expect_object({"verdict", "depth", "nhat_BA_W"});
  Penetration answer;
  read_if_said(node, "verdict", read_verdict, answer.verdict);
  read_if_said(node, "depth", read_number, answer.depth);
  read_if_said(node, "nhat_BA_W", read_vec3, answer.nhat_BA_W);
  return answer;
}

template <>
Impulse read<Impulse>(const Json& json, const std::string& place) {
  const Node node(json, place);
  node.expect_object({"after", "P_A_W", "error", "ambiguous"});
  const Node after = node.at("after");
  after.expect_size(2);
  Impulse answer{{read_velocity(after[0]), read_velocity(after[1])}, {}, {}, {}};
  read_if_said(node, "P_A_W", read_vec3, answer.P_A_W);
  read_if_said(node, "error", read_number, answer.error);
  read_if_said(node, "ambiguous", read_number, answer.ambiguous);
  return answer;
}

template <>
Pixels read<Pixels>(const Json& json, const std::string& place) {
  const Node node(json, place);
  node.expect_object({"sampled", "conservative", "overlap", "meet_sampled", "meet_conservative"});
  Pixels answer;
  answer.sampled = read_masks(node.at("sampled"));
  answer.conservative = read_masks(node.at("conservative"));
  const Node overlap = node.at("overlap");
  overlap.expect_object({"count", "first"});
  answer.overlap.count = overlap.at("count").index();
  if (const auto first = overlap.find("first")) {
    first->expect_size(2);
    answer.overlap.first = {(*first)[0].index(), (*first)[1].index()};
  }
  answer.meet_sampled = read_mask(node.at("meet_sampled"));
  answer.meet_conservative = read_mask(node.at("meet_conservative"));
  return answer;
}

}  // namespace touchstone
