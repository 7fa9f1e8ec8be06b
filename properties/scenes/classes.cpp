// The classes of a scene, by its exact truth, and how often each class must occur.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "model/box_vertices.h"
#include "model/input_error.h"
#include "model/near_names.h"
#include "model/sequence.h"
#include "oracle/query.h"
#include "oracle/tolerance/constraint.h"
#include "oracle/tolerance/precision.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/impact.h"
#include "oracle/truth/truth.h"
#include "properties/scenes/domain.h"

namespace touchstone::properties {
namespace {

using oracle::Precision;
using Names = std::vector<std::string>;

constexpr const char* shape_names[] = {"sphere", "box", "polytope", "compound"};

std::string ordered(std::string a, std::string b) {
  if (b < a) std::swap(a, b);
  return a + '-' + b;
}

std::string shapes(const Scene& scene) {
  return ordered(shape_names[scene.bodies[0].shape.index()], shape_names[scene.bodies[1].shape.index()]);
}

bool is_turned(const Body& body) {
  const Quaternion& q = body.X_WB.q_WB;
  return q.x != 0 || q.y != 0 || q.z != 0;
}

const char* name_of(Verdict verdict) {
  return verdict == Verdict::separated ? "separated" : verdict == Verdict::touching ? "touching" : "overlapping";
}

/// The vertices of the part to which a feature belongs, in the part's own frame; a sphere has none.
std::vector<Vec3> points_of(const Body& body, const Feature& feature) {
  const auto vertices = [](const auto& shape) -> std::vector<Vec3> {
    using T = std::decay_t<decltype(shape)>;
    if constexpr (std::is_same_v<T, Polytope>) return shape.vertices;
    if constexpr (std::is_same_v<T, Box>) return vertices_of(shape);
    return {};
  };
  std::vector<Vec3> all;
  if (const auto* compound = std::get_if<Compound>(&body.shape)) {
    all = std::visit(vertices, compound->parts[static_cast<std::size_t>(feature.part)].shape);
  } else {
    all = std::visit(vertices, body.shape);
  }
  std::vector<Vec3> points;
  for (const int i : feature.vertices) {
    if (!all.empty()) points.push_back(all[static_cast<std::size_t>(i)]);
  }
  return points;
}

/// A feature is a face of a polytope, and its number of vertices tells its dimension, except that a vertex may lie in
/// the interior of an edge. The feature is an edge if all directions from the first vertex are parallel.
const char* kind_of(const Body& body, const Feature& feature) {
  const std::vector<Vec3> points = points_of(body, feature);
  if (points.empty()) return "sphere";
  if (points.size() == 1) return "vertex";
  const Vec3 along = points[1] - points[0];
  const bool line = std::ranges::all_of(points, [&](const Vec3& p) { return along.cross(p - points[0]).isZero(0); });
  return line ? "edge" : "face";
}

std::string closeness(double length, double scale) {
  return length <= std::ldexp(scale, -40)   ? "within 2^-40"
         : length <= std::ldexp(scale, -12) ? "within 2^-12"
                                            : "clear";
}

void pair_classes(const Scene& scene, Names& names) {
  const reference::DistanceTruth& truth = oracle::truth::distance(scene);
  const std::string verdict = name_of(truth.verdict);
  names.push_back(verdict);
  names.push_back(shapes(scene));
  if (truth.feature_A.vertices.empty()) return;
  const std::string kinds =
      ordered(kind_of(scene.bodies[0], truth.feature_A), kind_of(scene.bodies[1], truth.feature_B));
  names.push_back(kinds);
  if (truth.verdict == Verdict::touching) names.push_back("touching " + kinds);
  if (truth.verdict == Verdict::separated) {
    names.push_back("separated " + closeness(truth.distance.lo, oracle::tolerance::scale(scene)));
  }
}

void depth_classes(const Scene& scene, Names& names) {
  names.push_back(shapes(scene));
  const reference::PenetrationTruth& truth = oracle::truth::penetration(scene);
  names.push_back(name_of(truth.verdict));
  if (truth.verdict == Verdict::overlapping) {
    names.push_back("overlapping " + closeness(truth.depth.lo, oracle::tolerance::scale(scene)));
  }
}

void shape_classes(const Scene& scene, Names& names) {
  std::set<std::string> kinds;
  for (const Body& body : scene.bodies) {
    kinds.insert(shape_names[body.shape.index()]);
    kinds.insert(is_turned(body) ? "turned" : "not turned");
    if (body.X_WB.p_WB.minCoeff() < 0) kinds.insert("negative coordinates");
  }
  names.insert(names.end(), kinds.begin(), kinds.end());
}

void mass_classes(const Scene& scene, Names& names) {
  shape_classes(scene, names);
  for (const Body& body : scene.bodies) {
    if (std::holds_alternative<MassProperties>(body.mass)) names.push_back("given");
    if (std::holds_alternative<Fixed>(body.mass)) names.push_back("fixed");
    if (const auto* density = std::get_if<Density>(&body.mass); density && density->value != 1)
      names.push_back("density");
  }
  const auto& truth = oracle::truth::mass(scene);
  for (const auto& mass : truth) {
    if (!mass) continue;
    const auto [low, high] = std::minmax({mass->I_BBcm_B[0].lo, mass->I_BBcm_B[1].lo, mass->I_BBcm_B[2].lo});
    names.push_back(high > 100 * low ? "slender" : "compact");
  }
}

void sequence_classes(const Scene& sequence, Names& names) {
  names.push_back("sequence");
  if (sequence.bodies.size() > 16) names.push_back("sequence: more than 16 bodies");
  const PairHistory& truth = oracle::truth::pair_history(sequence);
  const std::vector<reference::FrameBoxes>& boxes = oracle::truth::sequence_bounds(sequence);
  Places before(sequence.bodies.size());
  const std::vector<Places> there = places(sequence);
  for (std::size_t f = 0; f < truth.size(); ++f) {
    if (sequence.frames[f].empty()) names.push_back("sequence: empty frame");
    if (!truth[f].begun->empty()) names.push_back("sequence: pairs begin");
    if (!truth[f].ended->empty()) names.push_back("sequence: pairs end");
    int gone = 0;
    for (const Placement& placement : sequence.frames[f]) {
      gone += placement.X_WB ? 0 : 1;
      const std::optional<Pose>& was = before[static_cast<std::size_t>(placement.body)];
      if (was && placement.X_WB == was) names.push_back("sequence: unchanged pose");
    }
    if (gone > 0) names.push_back("sequence: body removed");
    if (gone > 1) names.push_back("sequence: two removed at once");
    for (const auto& [i, j] : truth[f].pairs) {
      const auto& a = boxes[f][static_cast<std::size_t>(i)];
      const auto& b = boxes[f][static_cast<std::size_t>(j)];
      if (reference::gap(*a, *b).sign() == 0) names.push_back("sequence: touching boxes");
    }
    before = there[f];
  }
}

void broad_phase_classes(const Scene& scene, Names& names) {
  if (is_sequence(scene)) return sequence_classes(scene, names);
  const std::size_t count = scene.bodies.size();
  names.push_back(count <= 2 ? "two bodies" : count <= 12 ? "3 to 12 bodies" : "more than 12 bodies");
  const std::vector<reference::ExactBox>& boxes = oracle::truth::bounds(scene);
  bool touching = false;
  bool overlapping = false;
  bool equal_end = false;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      const int sign = reference::gap(boxes[i], boxes[j]).sign();
      touching = touching || sign == 0;
      overlapping = overlapping || sign < 0;
      for (std::size_t axis = 0; axis < 3 && !equal_end; ++axis) {
        equal_end = boxes[i].lo[axis] == boxes[j].lo[axis] || boxes[i].hi[axis] == boxes[j].lo[axis] ||
                    boxes[i].lo[axis] == boxes[j].hi[axis] || boxes[i].hi[axis] == boxes[j].hi[axis];
      }
    }
  }
  if (touching) names.push_back("touching boxes");
  if (overlapping) names.push_back("overlapping boxes");
  if (!touching && !overlapping) names.push_back("no pair");
  if (equal_end) names.push_back("equal end points");
}

void impulse_classes(const Scene& scene, Names& names) {
  const Contact& contact = *scene.contact;
  const oracle::Impact impact = oracle::impact(scene);
  const auto when = [&names](bool is, const char* name) {
    if (is) names.emplace_back(name);
  };
  const oracle::Real coupling = impact.k().norm() / impact.K_nn(), condition = impact.condition();
  const bool uncoupled = coupling <= 0x1p-60L;
  names.emplace_back(contact.law == Law::poisson ? "Poisson" : contact.law == Law::stronge ? "Stronge" : "Newton");
  when(impact.u_n() < 0, "approaching");
  when(impact.u_n() > 0, "parting");
  when(impact.u_n() == 0, "neither approaching nor parting");
  when(impact.u_t().norm() <= 0x1p-60L * impact.u.norm(), "no slip");
  when(contact.friction == 0, "no friction");
  when(std::isinf(contact.friction), "infinite friction");
  when(contact.restitution == 0, "e = 0");
  when(contact.restitution == 1, "e = 1");
  when(uncoupled, "normal and slip uncoupled");
  when(!uncoupled && contact.friction * coupling > 1, "jam-capable");
  when(condition <= 10, "cond(K) to 10");
  when(condition > 1e4, "cond(K) beyond 1e4");
  when(impact.bodies[0].fixed || impact.bodies[1].fixed, "one body fixed");
  when(!impact.bodies[0].fixed && !impact.bodies[1].fixed, "no body fixed");
}

bool any(const Mask& mask) {
  return std::ranges::any_of(mask, [](const std::string& row) { return row.find('1') != std::string::npos; });
}

void pixel_classes(const Scene& scene, Names& names) {
  const Pixels& truth = oracle::truth::pixel(scene);
  const Raster& raster = *scene.raster;
  names.push_back(shapes(scene));
  const bool seen = any(truth.sampled[0]) && any(truth.sampled[1]);
  const bool overlap = truth.overlap.count > 0;
  names.emplace_back(seen ? "both sampled" : "one not sampled");
  names.emplace_back(overlap ? "masks overlap" : "masks apart");
  if (truth.overlap.count > 63) names.emplace_back("more than 63 common pixels");
  if (raster.columns > 64) names.emplace_back("more than one word");
  if (raster.shift_x != 0 || raster.shift_y != 0) names.emplace_back("shifted");
  const bool meet = any(truth.meet_sampled);
  const bool touch = any(truth.meet_conservative);
  names.emplace_back(meet ? "meet above a centre" : touch ? "meet between centres" : "do not meet");
  if (truth.sampled != truth.conservative) names.emplace_back("squares beyond the samples");
}

/// The classes that time_of_impact and simulation share.
void motion_classes(const Scene& scene, Names& names) {
  const auto any_body = [&](auto&& is) { return std::ranges::any_of(scene.bodies, is); };
  const auto when = [&names](bool is, const char* name) {
    if (is) names.emplace_back(name);
  };
  when(!scene.gravity.isZero(0), "gravity");
  when(!scene.motion->forces.empty(), "applied forces");
  when(any_body([](const Body& b) { return std::holds_alternative<Fixed>(b.mass); }), "one body fixed");
  when(any_body([](const Body& b) { return !b.velocity.w_WB.isZero(0); }), "spins");
  when(any_body([](const Body& b) { return std::holds_alternative<Sphere>(b.shape); }), "a ball");
  when(any_body([](const Body& b) { return std::holds_alternative<Polytope>(b.shape); }), "a polytope");
}

void time_of_impact_classes(const Scene& scene, Names& names) {
  motion_classes(scene, names);
  const reference::TimeOfImpactTruth& truth = oracle::truth::time_of_impact(scene);
  const bool hit = truth.status == TimeOfImpact::Status::hit;
  names.emplace_back(hit ? "hit" : truth.status == TimeOfImpact::Status::miss ? "miss" : "undecided");
  if (hit && truth.at_start) names.emplace_back("hit at the start");
  if (!scene.motion->start_times.empty()) names.emplace_back("starts of their own");
}

void run_classes(const Scene& scene, Names& names) {
  motion_classes(scene, names);
  names.emplace_back(scene.bodies.size() <= 2 ? "one or two bodies" : "three bodies or more");
  double least = 1, most = 0;
  for (const Body& body : scene.bodies) {
    least = std::min(least, body.material.restitution);
    most = std::max(most, body.material.friction);
  }
  if (least == 1) names.emplace_back("elastic");
  if (most > 0) names.emplace_back("friction");
}

std::vector<Class> with_shapes(std::vector<Class> classes) {
  for (const char* pair :
       {"box-box", "box-polytope", "box-sphere", "polytope-polytope", "polytope-sphere", "sphere-sphere"}) {
    classes.push_back({pair, 0.002});
  }
  classes.push_back({"binary32", 0.5});
  return classes;
}

std::vector<Class> distance_classes() {
  std::vector<Class> all = {{"separated", 0.15},
                            {"touching", 0.15},
                            {"overlapping", 0.15},
                            {"separated within 2^-40", 0.01},
                            {"separated within 2^-12", 0.03},
                            {"separated clear", 0.05}};
  for (const char* kinds : {"vertex-vertex", "edge-vertex", "face-vertex", "edge-edge", "edge-face", "face-face"}) {
    all.push_back({kinds, 0.01});
    all.push_back({"touching " + std::string(kinds), 0.005});
  }
  for (const char* kinds : {"sphere-vertex", "edge-sphere", "face-sphere", "sphere-sphere"})
    all.push_back({kinds, 0.002});
  all.push_back({"compound-compound", 0.002});
  return with_shapes(all);
}

std::vector<Class> with_kinds_of_body(std::vector<Class> classes) {
  for (const char* kind : {"sphere", "box", "polytope", "compound", "turned", "not turned", "negative coordinates"}) {
    classes.push_back({kind, 0.02});
  }
  classes.push_back({"binary32", 0.5});
  return classes;
}

void constraint_classes(const Scene& scene, Names& names) {
  using Truth = reference::ConstraintTruth;
  const auto* truth = std::get_if<Truth>(&oracle::truth::constraint(scene));
  if (truth == nullptr) {
    names.push_back("laws alone");
    return;
  }
  const auto mode = [&](Truth::Mode m) {
    names.push_back(m == Truth::Mode::rolling ? "rolls" : m == Truth::Mode::sliding ? "slides" : "flies");
  };
  mode(truth->first.mode);
  int impacts = 0;
  for (const Truth::Change& change : truth->changes) {
    mode(change.segment.mode);
    if (change.kind == Event::Kind::release) names.push_back("a contact ends");
    if (change.kind == Event::Kind::impact) ++impacts;
    if (change.kind == Event::Kind::contact && change.rate > 0) names.push_back("slip stops");
  }
  if (impacts > 0) names.push_back("an impact");
  if (impacts > 1) names.push_back("two impacts or more");
  const double step = oracle::tolerance::granted_step(scene);
  const auto sure = oracle::tolerance::rolling(scene, *truth, Precision::binary64, step).size();
  names.push_back(sure == scene.motion->sample_times.size() ? "sure to the end" : "not sure to the end");
}

}  // namespace

std::vector<std::string> classes_of(const Scene& scene, const std::string& query) {
  Names names;
  if (query == "distance" && scene.bodies.size() == 2) pair_classes(scene, names);
  if (query == "penetration" && scene.bodies.size() == 2) depth_classes(scene, names);
  if (query == "mass") mass_classes(scene, names);
  if (query == "bounds") shape_classes(scene, names);
  if (query == "broad_phase") broad_phase_classes(scene, names);
  if (query == "pixel" && scene.raster && scene.bodies.size() == 2) pixel_classes(scene, names);
  if (query == "impulse" && scene.contact) impulse_classes(scene, names);
  if (query == "time_of_impact" && scene.motion && scene.bodies.size() == 2) time_of_impact_classes(scene, names);
  if (query == "simulation" && scene.motion) run_classes(scene, names);
  if (query == "constraint" && scene.motion) constraint_classes(scene, names);
  if (oracle::exact_in(scene, Precision::binary32)) names.push_back("binary32");
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

const std::vector<Class>& classes(const std::string& query) {
  static const std::vector<Class> mass =
      with_kinds_of_body({{"given", 0.005}, {"fixed", 0.005}, {"density", 0.02}, {"slender", 0.05}, {"compact", 0.2}});
  static const std::vector<Class> bounds = with_kinds_of_body({});
  static const std::vector<Class> broad_phase = {{"two bodies", 0.3},
                                                 {"3 to 12 bodies", 0.05},
                                                 {"more than 12 bodies", 0.01},
                                                 {"touching boxes", 0.08},
                                                 {"overlapping boxes", 0.2},
                                                 {"no pair", 0.05},
                                                 {"equal end points", 0.2},
                                                 {"binary32", 0.5},
                                                 {"sequence", 0.1},
                                                 {"sequence: empty frame", 0.02},
                                                 {"sequence: pairs begin", 0.08},
                                                 {"sequence: pairs end", 0.05},
                                                 {"sequence: unchanged pose", 0.01},
                                                 {"sequence: body removed", 0.05},
                                                 {"sequence: two removed at once", 0.01},
                                                 {"sequence: touching boxes", 0.04},
                                                 {"sequence: more than 16 bodies", 0.02}};
  static const std::vector<Class> distance = distance_classes();
  static const std::vector<Class> penetration = with_shapes({{"separated", 0.15},
                                                             {"touching", 0.15},
                                                             {"overlapping", 0.15},
                                                             {"overlapping within 2^-40", 0.01},
                                                             {"overlapping within 2^-12", 0.03},
                                                             {"overlapping clear", 0.05}});
  static const std::vector<Class> pixel = {{"both sampled", 0.3},
                                           {"one not sampled", 0.1},
                                           {"masks overlap", 0.2},
                                           {"masks apart", 0.2},
                                           {"more than 63 common pixels", 0.01},
                                           {"more than one word", 0.03},
                                           {"shifted", 0.3},
                                           {"meet above a centre", 0.2},
                                           {"meet between centres", 0.03},
                                           {"do not meet", 0.15},
                                           {"squares beyond the samples", 0.5},
                                           {"box-box", 0.1},
                                           {"box-sphere", 0.02},
                                           {"polytope-polytope", 0.05},
                                           {"compound-compound", 0.01},
                                           {"binary32", 0.5}};
  static const std::vector<Class> impulse = {
      {"Poisson", 0.3},        {"Stronge", 0.1},       {"Newton", 0.1},
      {"approaching", 0.5},    {"parting", 0.02},      {"neither approaching nor parting", 0.005},
      {"no slip", 0.05},       {"no friction", 0.05},  {"infinite friction", 0.05},
      {"e = 0", 0.1},          {"e = 1", 0.1},         {"normal and slip uncoupled", 0.05},
      {"jam-capable", 0.1},    {"cond(K) to 10", 0.2}, {"cond(K) beyond 1e4", 0.03},
      {"one body fixed", 0.2}, {"no body fixed", 0.2}, {"binary32", 0.5}};
  static const std::vector<Class> constraint = {{"rolls", 0.19},
                                                {"slides", 0.1},
                                                {"flies", 0.15},
                                                {"slip stops", 0.03},
                                                {"a contact ends", 0.08},
                                                {"an impact", 0.1},
                                                {"two impacts or more", 0.01},
                                                {"sure to the end", 0.16},
                                                {"laws alone", 0.1},
                                                {"binary32", 0.1}};
  static const std::vector<Class> time_of_impact_classes = {{"hit", 0.3},
                                                            {"miss", 0.15},
                                                            {"hit at the start", 0.01},
                                                            {"gravity", 0.1},
                                                            {"applied forces", 0.03},
                                                            {"one body fixed", 0.08},
                                                            {"spins", 0.2},
                                                            {"a ball", 0.1},
                                                            {"a polytope", 0.1},
                                                            {"starts of their own", 0.03},
                                                            {"binary32", 0.5}};
  static const std::vector<Class> runs = {{"gravity", 0.15},
                                          {"applied forces", 0.03},
                                          {"one body fixed", 0.1},
                                          {"spins", 0.2},
                                          {"a ball", 0.3},
                                          {"a polytope", 0.08},
                                          {"one or two bodies", 0.15},
                                          {"three bodies or more", 0.2},
                                          {"elastic", 0.1},
                                          {"friction", 0.2},
                                          {"binary32", 0.5}};
  static const std::map<std::string, const std::vector<Class>*> all = {{"mass", &mass},
                                                                       {"bounds", &bounds},
                                                                       {"broad_phase", &broad_phase},
                                                                       {"distance", &distance},
                                                                       {"penetration", &penetration},
                                                                       {"pixel", &pixel},
                                                                       {"impulse", &impulse},
                                                                       {"time_of_impact", &time_of_impact_classes},
                                                                       {"simulation", &runs},
                                                                       {"constraint", &constraint}};
  const auto found = all.find(query);
  if (found == all.end()) throw InputError("query " + query, unknown_among(query, oracle::query_names()));
  return *found->second;
}

}  // namespace touchstone::properties
