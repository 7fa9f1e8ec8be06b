// The clauses about work of docs/spec: for each query, no answer takes more steps than the subject promises.
#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "oracle/domain.h"
#include "oracle/judge/words.h"
#include "oracle/minimise/scene_edit.h"
#include "oracle/query.h"
#include "oracle/tolerance/tolerance.h"
#include "properties/cases/central_ball.h"
#include "properties/judging/asking.h"
#include "properties/queries.h"
#include "properties/random.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Subject;
using oracle::Work;
using oracle::WorkLimit;
namespace judge = oracle::judge;
namespace tolerance = oracle::tolerance;
namespace words = oracle::words;

std::size_t vertices_of(const ConvexShape& shape) { return std::max<std::size_t>(1, oracle::corners(shape).size()); }

double vertices(const Scene& scene) {
  std::size_t sum = 0;
  for (const oracle::Slot slot : oracle::slots(scene)) sum += vertices_of(oracle::shape_at(scene, slot));
  return static_cast<double>(sum);
}

double placements(const Scene& scene) {
  std::size_t sum = 0;
  for (const SequenceFrame& frame : scene.frames) sum += frame.size();
  return static_cast<double>(sum);
}

double seconds(const Scene& scene) {
  return scene.motion && !scene.motion->sample_times.empty() ? scene.motion->sample_times.back() : 0;
}

/// By how much the bodies would turn in the time of the motion if they kept their angular velocities. A ball that turns
/// about its centre stays where it is.
double radians(const Scene& scene) {
  double sum = 0;
  for (const Body& body : scene.bodies) {
    if (!is_central_ball(body)) sum += seconds(scene) * body.velocity.w_WB.norm();
  }
  return sum;
}

/// A size of the scene by its name in oracle/work.h.
std::optional<double> size_of(const Scene& scene, const std::string& name) {
  const auto bodies = static_cast<double>(scene.bodies.size());
  if (name == "bodies") return bodies;
  if (name == "pairs") return bodies * (bodies - 1) / 2;
  if (name == "vertices") return vertices(scene);
  if (name == "frames") return static_cast<double>(scene.frames.size());
  if (name == "placements") return placements(scene);
  if (name == "pixels") return scene.raster ? double{1} * scene.raster->columns * scene.raster->rows : 0;
  if (name == "samples") return scene.motion ? static_cast<double>(scene.motion->sample_times.size()) : 0;
  if (name == "seconds") return seconds(scene);
  if (name == "body_seconds") return bodies * seconds(scene);
  if (name == "radians") return radians(scene);
  if (name == "aspect") return std::min(oracle::sizes_of(scene).aspect, 0x1p20);  // a greater one says nothing
  return std::nullopt;
}

double times(const Work& work, const std::string& count) {
  const auto found = work.find(count);
  return found == work.end() ? 0 : static_cast<double>(found->second);
}

double promised(const WorkLimit& limit, const Scene& scene, const Work& work) {
  double most = limit.base;
  for (const auto& [name, factor] : limit.per) most += factor * size_of(scene, name).value_or(times(work, name));
  return most;
}

double from_to(double lo, double hi, Random& random) { return lo + (hi - lo) * random.unit(); }

Quaternion any_rotation(Random& random) {
  Quaternion q;
  for (double* component : {&q.w, &q.x, &q.y, &q.z}) *component = from_to(-1, 1, random);
  return q;
}

/// A point inside, rotated; 0 for a ball. Not the mean of the vertices, which may lie in a plane of symmetry.
Vec3 inside(const Body& body, Random& random) {
  Scene alone;
  alone.bodies = {body};
  Vec3 sum = Vec3::Zero();
  double weights = 0;
  for (const Vec3& corner : oracle::corners(oracle::shape_at(alone, {}))) {
    const double weight = from_to(1, 2, random);
    sum += weight * corner;
    weights += weight;
  }
  if (weights > 0) sum /= weights;
  const auto& [w, x, y, z] = body.X_WB.q_WB;
  return Eigen::Quaterniond(w, x, y, z).normalized() * sum;
}

/// The two bodies in generic rotations: apart, by less than a quarter of their sizes, or for `penetration` with points
/// inside them near each other. The points are generic too: one body may be a speck inside the other.
Scene placed(const Scene& scene, const std::string& query, int number) {
  Random random(1, "work", static_cast<std::uint64_t>(number));
  Scene generic = scene;
  Body& A = generic.bodies[0];
  Body& B = generic.bodies[1];
  A.X_WB = {Vec3::Zero(), any_rotation(random)};
  B.X_WB = {Vec3::Zero(), any_rotation(random)};
  Vec3 direction;
  for (double& component : direction) component = from_to(-1, 1, random);
  direction.normalize();
  const double a = tolerance::radius(A), b = tolerance::radius(B), share = from_to(0x1p-6, 0x1p-2, random);
  if (query != "penetration") {
    B.X_WB.p_WB = (1 + share) * (a + b) * direction;
    return generic;
  }
  const Vec3 in_A = inside(A, random), in_B = inside(B, random);
  B.X_WB.p_WB = in_A - in_B + share * std::min(a, b) * direction;
  return generic;
}

/// By the count that exceeds its limit by the greatest factor.
Finding judged(const Work& work, const std::vector<WorkLimit>& limits, const Scene& scene) {
  Finding worst = judge::holds();
  for (const WorkLimit& limit : limits) {
    const double count = times(work, limit.count);
    const double most = promised(limit, scene, work);
    const judge::Allowance allowance{.bound = 1, .unit = 1, .unit_name = "times the promised work"};
    constexpr double none = 0.5;  // where no step is promised, one is too many
    Finding finding = judge::at_most(
        count / std::max(most, none), allowance, Defect::too_much_work,
        [&] { return words::text(count) + " of " + limit.count; }, [&] { return "at most " + words::text(most); });
    if (finding.error >= worst.error) worst = std::move(finding);
  }
  return worst;
}

/// Two convex bodies. In slivers, which have no generic placement, doubles seldom decide: the limit is a choice.
bool has_generic_placements(const Scene& scene) {
  constexpr double greatest_aspect = 1024;
  return scene.bodies.size() == 2 && oracle::slots(scene).size() == 2 &&
         oracle::sizes_of(scene).aspect <= greatest_aspect;
}

/// The promises about the query, by the number of placements that they are about.
std::map<int, std::vector<WorkLimit>> limits_of(const std::string& query, const Scene& scene, const Subject& subject) {
  std::map<int, std::vector<WorkLimit>> limits;
  for (const WorkLimit& limit : subject.card().work_limits) {
    if (limit.query == query) limits[limit.placements].push_back(limit);
  }
  if (!limits.empty() && !has_generic_placements(scene)) {
    std::erase_if(limits, [](const auto& of_placements) { return of_placements.first > 0; });
  }
  return limits;
}

/// Of the scene, or of all its placements together.
Answer<Work> asked(const std::string& query, const Scene& scene, int placements, Subject& subject) {
  if (placements == 0) return subject.work(query, scene);
  Work sum;
  for (int number = 0; number < placements; ++number) {
    const Answer<Work> work = subject.work(query, placed(scene, query, number));
    const auto* counts = std::get_if<Work>(&work);
    if (counts == nullptr) return work;
    for (const auto& [name, count] : *counts) sum[name] += count;
  }
  return sum;
}

bool can_be_asked(const std::string& name, const Scene& scene) {
  const oracle::Query& query = *oracle::find_query(name);
  switch (query.needs) {
    case oracle::ScenePart::contact:
      return scene.contact.has_value();
    case oracle::ScenePart::raster:
      return scene.raster.has_value();
    case oracle::ScenePart::motion:
      return scene.motion.has_value() && (!query.about_two_bodies || scene.bodies.size() == 2);
    case oracle::ScenePart::none:
      break;
  }
  return !query.about_two_bodies || scene.bodies.size() == 2;
}

/// No subject has to answer where the specification defines no answer: about compounds, and for `constraint` about
/// bodies that start at different times.
bool is_defined(const std::string& query, const Scene& scene) {
  if (query != "penetration" && query != "constraint") return true;
  const bool starts_together =
      !scene.motion || std::ranges::all_of(scene.motion->start_times, [](double start) { return start == 0; });
  if (query == "constraint" && !starts_together) return false;
  return std::ranges::none_of(scene.bodies,
                              [](const Body& body) { return std::holds_alternative<Compound>(body.shape); });
}

Finding keeps_promise(const std::string& query, const Scene& scene, Subject& subject) {
  if (!can_be_asked(query, scene)) return judge::outside("not exactly two bodies, or a part of the scene is missing");
  const auto limits = limits_of(query, scene, subject);
  if (limits.empty()) return judge::outside("the card promises nothing about the work for such a scene");
  return of_scene(scene, subject, [&] {
    Finding worst = judge::holds();
    for (const auto& [placements, promises] : limits) {
      Finding finding =
          judge::given(asked(query, scene, placements, subject),
                       [&, &promises = promises](const Work& work) { return judged(work, promises, scene); });
      if (finding.outcome == oracle::Outcome::abstains && is_defined(query, scene)) {
        return judge::wrong(Defect::refused, "no answer: " + finding.why, "an answer, since its work is promised");
      }
      if (finding.outcome != oracle::Outcome::holds) return finding;
      if (finding.error >= worst.error) worst = std::move(finding);
    }
    return worst;
  });
}

Property property(const std::string& query, const std::string& clause) {
  return {query + ".work",
          query,
          {clause},
          "no answer takes more steps than the card promises",
          [query](const Scene& scene, Subject& subject) {
            const bool is_sequence = query == "broad_phase" && !scene.frames.empty();
            return keeps_promise(is_sequence ? "pair_history" : query, scene, subject);
          }};
}

}  // namespace

std::vector<Property> work_properties() {
  return {property("broad_phase", "TS-BROAD-PHASE-19"),       property("distance", "TS-DISTANCE-14"),
          property("penetration", "TS-PENETRATION-12"),       property("impulse", "TS-IMPULSE-27"),
          property("time_of_impact", "TS-TIME-OF-IMPACT-20"), property("simulation", "TS-SIMULATION-41"),
          property("constraint", "TS-CONSTRAINT-12")};
}

}  // namespace touchstone::properties
