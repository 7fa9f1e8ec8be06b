#include "app/profile/atlas.h"

#include <algorithm>
#include <cmath>

#include "app/trial/effort.h"
#include "model/infinity.h"
#include "oracle/judge/judge.h"
#include "oracle/truth/impact.h"
#include "oracle/truth/truth.h"

namespace touchstone::app {
namespace {

using oracle::Domain;

/// Decades near 1, wider classes far from it: a choice, so that a table is not wider than what is known.
const std::vector<double> decades = {1e-12, 1e-9, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1,
                                     1,     10,   100,  1e3,  1e4,  1e5,  1e6,  1e9};

/// From 0, a class of its own, through the sizes of rounding to 1.
const std::vector<double> gaps = {0, 1e-17, 1e-16, 1e-15, 1e-12, 1e-9, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1};

const std::vector<double> ratios = {1, 2, 10, 100, 1e3, 1e4, 1e5, 1e6, 1e9, 1e12};
const std::vector<double> speeds = {0, 1e-9, 1e-6, 1e-3, 1e-2, 0.1, 1, 10, 100, 1e3, 1e6, 1e9};

std::optional<Interval> up_to(const std::optional<double>& most) {
  return most ? std::optional(Interval{0, *most}) : std::nullopt;
}

std::optional<Interval> longest(const Domain& domain) {
  return domain.lengths ? std::optional(Interval{0, domain.lengths->hi}) : std::nullopt;
}

std::optional<Interval> thinnest(const Domain& domain) {
  return domain.lengths ? std::optional(Interval{domain.lengths->lo, infinity}) : std::nullopt;
}

std::optional<Interval> reach(const Domain& domain) { return up_to(domain.reach); }
std::optional<Interval> aspect(const Domain& domain) { return up_to(domain.aspect); }
std::optional<Interval> vertices(const Domain& domain) { return up_to(domain.vertices); }
std::optional<Interval> ratio_of_masses(const Domain& domain) { return up_to(domain.mass_ratio); }
std::optional<Interval> speed(const Domain& domain) { return up_to(domain.speed); }
std::optional<Interval> spin(const Domain& domain) { return up_to(domain.angular_speed); }

/// Indices of `atlas_axes`.
enum AxisIndex {
  gap_axis,
  length_axis,
  thickness_axis,
  reach_axis,
  aspect_axis,
  vertices_axis,
  mass_axis,
  slip_axis,
  friction_axis,
  speed_axis,
  spin_axis
};

/// m: the exact distance of a scene of `distance`, the exact depth of one of `penetration`.
std::optional<double> gap_of(const Scene& scene, const std::string& query) {
  if (query == "distance") return oracle::truth::distance(scene).distance.lo;
  if (query != "penetration") return std::nullopt;
  const double margin = oracle::judge::margin(scene).lo;
  return std::isfinite(margin) ? std::optional(margin) : std::nullopt;
}

int class_of(const AtlasAxis& axis, double value) {
  return static_cast<int>(std::ranges::lower_bound(axis.edges, value) - axis.edges.begin());
}

/// The places of one scene, as they are found.
class Places {
 public:
  void add(AxisIndex axis, double value) {
    if (!std::isnan(value)) found_.emplace_back(axis, class_of(atlas_axes()[static_cast<std::size_t>(axis)], value));
  }

  std::vector<AtlasPlace> take() { return std::move(found_); }

 private:
  std::vector<AtlasPlace> found_;
};

bool asks_about_motion(const std::string& query) {
  return query == "impulse" || query == "time_of_impact" || is_simulated(query);
}

double greatest_friction(const Scene& scene) {
  double greatest = 0;
  for (const Body& body : scene.bodies) greatest = std::max(greatest, body.material.friction);
  return greatest;
}

void add_motion(Places& places, const Scene& scene, const oracle::SceneSizes& sizes, const std::string& query) {
  places.add(speed_axis, sizes.speed);
  places.add(spin_axis, sizes.angular_speed);
  places.add(mass_axis, oracle::mass_ratio(scene));
  if (scene.contact) {
    places.add(slip_axis, static_cast<double>(oracle::impact(scene).u_t().norm()));
    places.add(friction_axis, scene.contact->friction);
  } else if (is_simulated(query)) {
    places.add(friction_axis, greatest_friction(scene));
  }
}

}  // namespace

const std::vector<AtlasAxis>& atlas_axes() {
  static const std::vector<AtlasAxis> all = {
      {"gap", "1", "exact distance, or exact depth, over the scene's scale", gaps, nullptr},
      {"length", "m", "length of the longest body", decades, longest},
      {"thickness", "m", "thickness of the thinnest body", decades, thinnest},
      {"reach", "m", "largest coordinate of any point of a body", decades, reach},
      {"aspect", "1", "length over thickness of the most slender body", ratios, aspect},
      {"vertices", "1", "vertices of the largest polytope", {0, 4, 8, 16, 32, 64, 128, 256, 512}, vertices},
      {"mass ratio", "1", "greatest mass over least mass", ratios, ratio_of_masses},
      {"slip", "m/s", "speed of the contact point of A along B", speeds, nullptr},
      {"friction", "1", "coefficient of the contact, or the largest of a body", {0, 0.01, 0.1, 0.3, 1, 10}, nullptr},
      {"speed", "m/s", "largest speed of a centre of mass at the start", speeds, speed},
      {"spin", "rad/s", "largest angular speed at the start", speeds, spin}};
  return all;
}

std::vector<AtlasPlace> places_of(const Scene& scene, const std::string& query) {
  const oracle::SceneSizes sizes = oracle::sizes_of(scene);
  Places places;
  if (const auto gap = gap_of(scene, query)) places.add(gap_axis, *gap / sizes.reach);
  places.add(length_axis, sizes.lengths.hi);
  places.add(thickness_axis, sizes.lengths.lo);
  places.add(reach_axis, sizes.reach);
  places.add(aspect_axis, sizes.aspect);
  places.add(vertices_axis, sizes.vertices);
  if (asks_about_motion(query)) add_motion(places, scene, sizes, query);
  return places.take();
}

void SceneOutcome::add(const oracle::Finding& finding) {
  if (finding.outcome == oracle::Outcome::abstains || finding.outcome == oracle::Outcome::outside) return;
  answered = true;
  failed |= oracle::failed(finding);
  broken |= finding.outcome == oracle::Outcome::breaks;
  excess = std::max(excess, oracle::excess(finding));
}

void AtlasCell::merge(const AtlasCell& later) {
  scenes += later.scenes;
  failing += later.failing;
  broken += later.broken;
  excess = std::max(excess, later.excess);
}

void add(Atlas& atlas, const std::vector<AtlasPlace>& places, const SceneOutcome& outcome) {
  if (!outcome.answered) return;
  const AtlasCell one{1, outcome.failed ? 1 : 0, outcome.broken ? 1 : 0, outcome.excess};
  for (const AtlasPlace& place : places) atlas[place].merge(one);
}

void merge(Atlas& atlas, const Atlas& later) {
  for (const auto& [place, cell] : later) atlas[place].merge(cell);
}

DomainSide side_of(const AtlasAxis& axis, int k, const Domain& domain) {
  const std::optional<Interval> limits = axis.declared == nullptr ? std::nullopt : axis.declared(domain);
  if (!limits) return DomainSide::inside;
  const auto [above, up_to] = class_bounds(axis, k);
  if (up_to <= limits->hi && above >= limits->lo) return DomainSide::inside;
  return above >= limits->hi || up_to < limits->lo ? DomainSide::outside : DomainSide::across;
}

Interval class_bounds(const AtlasAxis& axis, int k) {
  const auto i = static_cast<std::size_t>(k);
  return {i == 0 ? 0 : axis.edges[i - 1], i < axis.edges.size() ? axis.edges[i] : infinity};
}

}  // namespace touchstone::app
