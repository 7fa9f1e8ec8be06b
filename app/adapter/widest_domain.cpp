#include "app/adapter/widest_domain.h"

#include <algorithm>
#include <cmath>

#include "app/adapter/paper/paper_scene.h"
#include "app/system/interruption.h"
#include "app/trial/counted_hangs.h"
#include "app/trial/effort.h"
#include "oracle/query.h"
#include "oracle/truth/truth.h"
#include "properties/judging/remembered_answers.h"
#include "properties/random.h"
#include "properties/transforms/scene.h"

namespace touchstone::app {
namespace {

using properties::Property;

/// Choices: enough scenes for all shapes and verdicts, and few enough for a trajectory at each exponent.
constexpr std::size_t plain_pairs = 12, plain_trajectories = 4;

void flatten(Sphere&, double) {}
void flatten(Box& box, double by) { box.half_extents.z() *= by; }
void flatten(Polytope& hull, double by) {
  for (Vec3& v : hull.vertices) v.z() *= by;
}
void flatten(Compound&, double) {}

/// The bodies as thin as 2^-exponent of what they were, along their own z.
std::optional<Scene> flattened(Scene scene, int exponent) {
  for (Body& body : scene.bodies) {
    std::visit([&](auto& shape) { flatten(shape, std::ldexp(1.0, -exponent)); }, body.shape);
  }
  return scene;
}

/// The first body with a density 2^exponent times as large.
std::optional<Scene> heavier(Scene scene, int exponent) {
  Density* density = scene.bodies.empty() ? nullptr : std::get_if<Density>(&scene.bodies.front().mass);
  if (density == nullptr) return std::nullopt;
  density->value *= std::ldexp(1.0, exponent);
  return scene;
}

/// About 2^exponent points of a sphere that are multiples of 2^-12, and their hull. The sphere is as large as the body.
Polytope round_hull(const Polytope& like, int exponent) {
  double size = 0;
  for (const Vec3& v : like.vertices) size = std::max(size, v.norm());
  size = std::exp2(std::round(std::log2(size)));
  properties::Random random(1, "round_hull", static_cast<std::uint64_t>(exponent));
  std::vector<Vec3> points;
  while (points.size() < (std::size_t{1} << exponent)) {
    const Vec3 p(random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5);
    if (p.norm() < 0.125 || p.norm() > 0.5) continue;
    points.push_back(size * (p.normalized() * 0x1p12).array().round().matrix() * 0x1p-12);
  }
  return oracle::truth::convex_hull(points);
}

/// The polytopes with 2^exponent vertices.
std::optional<Scene> rounded(Scene scene, int exponent) {
  bool any = false;
  for (Body& body : scene.bodies) {
    Polytope* hull = std::get_if<Polytope>(&body.shape);
    if (hull != nullptr) any = true, *hull = round_hull(*hull, exponent);
  }
  return any ? std::optional(scene) : std::nullopt;
}

std::vector<Scene> plain_scenes(const std::string& query) {
  const std::vector<PaperScene> all = paper_scenes(query);
  const std::size_t wanted = std::min(all.size(), is_simulated(query) ? plain_trajectories : plain_pairs);
  std::vector<Scene> chosen;
  for (std::size_t i = 0; i < wanted; ++i) chosen.push_back(all[i * all.size() / wanted].scene);
  return chosen;
}

bool moves(const std::string& query) { return query == "impulse" || query == "time_of_impact" || is_simulated(query); }

struct Tally {
  long holds = 0, fails = 0;
};

/// What each property says of all scenes, changed to that exponent.
std::vector<Tally> tallies(oracle::Subject& subject, const std::vector<Scene>& plain, const Axis& axis, int exponent,
                           const std::vector<HeldRange*>& asked) {
  std::vector<Tally> found(asked.size());
  for (const Scene& scene : plain) {
    const std::optional<Scene> changed = axis.at(scene, exponent);
    if (!changed) continue;
    properties::RememberedAnswers remembered(subject);
    for (std::size_t i = 0; i < asked.size(); ++i) {
      const Property& property = *asked[i]->property;
      const oracle::Finding finding = property.check(*changed, remembered.asked_by(property));
      found[i].holds += finding.outcome == oracle::Outcome::holds;
      found[i].fails += failed(finding);
    }
  }
  return found;
}

/// Widens the ranges by steps of ±1 from the start, as long as they hold.
template <class Go>
void walk(std::vector<HeldRange*> alive, const Axis& axis, int step, Go&& tallies_at) {
  for (int k = axis.start + step; axis.least <= k && k <= axis.most && !alive.empty() && !interrupted(); k += step) {
    const std::vector<Tally> found = tallies_at(k, alive);
    std::vector<HeldRange*> still;
    for (std::size_t i = 0; i < alive.size(); ++i) {
      if (found[i].fails > 0) {
        (step < 0 ? alive[i]->fails_below : alive[i]->fails_above) = true;
      } else if (found[i].holds > 0) {
        (step < 0 ? alive[i]->least : alive[i]->most) = k;
        still.push_back(alive[i]);
      }
    }
    alive = std::move(still);
  }
}

/// The ranges of one query's properties along one axis.
template <class Go>
std::vector<HeldRange> along(const Axis& axis, const std::string& query, Go&& tallies_at) {
  std::vector<HeldRange> ranges;
  for (const Property& property : properties::all()) {
    if (property.query == query) ranges.push_back({.property = &property, .axis = &axis});
  }
  std::vector<HeldRange*> all, holding;
  for (HeldRange& range : ranges) all.push_back(&range);
  const std::vector<Tally> at_start = tallies_at(axis.start, all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (at_start[i].fails > 0) {
      all[i]->fails_below = all[i]->fails_above = true;
    } else if (at_start[i].holds > 0) {
      all[i]->least = all[i]->most = axis.start;
      holding.push_back(all[i]);
    }
  }
  walk(holding, axis, 1, tallies_at);
  walk(holding, axis, -1, tallies_at);
  std::erase_if(ranges, [](const HeldRange& range) { return range.least > range.most && !range.fails_above; });
  return ranges;
}

}  // namespace

oracle::Domain default_domain(oracle::Precision precision) {
  const bool single = precision == oracle::Precision::binary32;
  const double most = std::ldexp(1.0, single ? 3 : 17), ratio = std::ldexp(1.0, single ? 14 : 43);
  oracle::Domain domain;
  domain.lengths = Interval{1 / most, most};
  domain.reach = most;
  domain.aspect = most * most;
  domain.mass_ratio = ratio;
  domain.speed = most;
  domain.angular_speed = ratio;
  return domain;
}

const std::vector<Axis>& axes() {
  static const std::vector<Axis> all = {
      {"length", 0, -40, 40, false, [](const Scene& scene, int k) { return properties::scaled(scene, k); }},
      {"aspect", 0, 0, 30, false, flattened},
      {"vertices", 3, 3, 9, false, rounded},
      {"mass ratio", 0, 0, 40, true, heavier},
      {"speed", 0, -20, 20, true, [](const Scene& scene, int k) { return properties::sped_up(scene, k); }}};
  return all;
}

std::vector<HeldRange> widest_domain(oracle::Subject& subject, const std::vector<std::string>& queries,
                                     const std::function<void(const std::string& query)>& asked) {
  std::vector<HeldRange> found;
  for (const oracle::Query& query : oracle::queries()) {
    const bool claimed = std::ranges::count(subject.card().answers, query.name) > 0;
    if (!claimed || (!queries.empty() && std::ranges::count(queries, query.name) == 0)) continue;
    const std::vector<Scene> plain = plain_scenes(query.name);
    int hangs = 0;
    CountedHangs counted(subject, hangs);
    for (const Axis& axis : axes()) {
      if ((axis.of_motion && !moves(query.name)) || hangs >= most_hangs || interrupted()) continue;
      const std::vector<HeldRange> ranges = along(axis, query.name, [&](int k, const std::vector<HeldRange*>& alive) {
        asked(query.name);
        return tallies(counted, plain, axis, k, alive);
      });
      found.insert(found.end(), ranges.begin(), ranges.end());
    }
  }
  return found;
}

}  // namespace touchstone::app
