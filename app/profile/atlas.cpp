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

/// m: the exact distance of a scene of `distance`, the exact depth of one of `penetration`.
std::optional<double> gap(const SizedScene& asked) {
  if (asked.query == "distance") return oracle::truth::distance(asked.scene).distance.lo;
  if (asked.query != "penetration") return std::nullopt;
  const double margin = oracle::judge::margin(asked.scene).lo;
  return std::isfinite(margin) ? std::optional(margin) : std::nullopt;
}

std::optional<double> gap_over_scale(const SizedScene& asked) {
  const std::optional<double> found = gap(asked);
  return found ? std::optional(*found / asked.sizes.reach) : std::nullopt;
}

int class_of(const AtlasAxis& axis, double value) {
  return static_cast<int>(std::ranges::lower_bound(axis.edges, value) - axis.edges.begin());
}

bool asks_about_motion(const SizedScene& asked) {
  return asked.query == "impulse" || asked.query == "time_of_impact" || is_simulated(asked.query);
}

std::optional<double> of_motion(const SizedScene& asked, double value) {
  return asks_about_motion(asked) ? std::optional(value) : std::nullopt;
}

std::optional<double> slip(const SizedScene& asked) {
  if (!asks_about_motion(asked) || !asked.scene.contact) return std::nullopt;
  return static_cast<double>(oracle::impact(asked.scene).u_t().norm());
}

std::optional<double> friction(const SizedScene& asked) {
  if (!asks_about_motion(asked)) return std::nullopt;
  if (asked.scene.contact) return asked.scene.contact->friction;
  if (!is_simulated(asked.query)) return std::nullopt;
  double greatest = 0;
  for (const Body& body : asked.scene.bodies) greatest = std::max(greatest, body.material.friction);
  return greatest;
}

std::optional<double> mass_ratio(const SizedScene& asked) {
  return asks_about_motion(asked) ? std::optional(oracle::mass_ratio(asked.scene)) : std::nullopt;
}

}  // namespace

const std::vector<AtlasAxis>& atlas_axes() {
  static const std::vector<AtlasAxis> all = {
      {"gap", "1", "exact distance, or exact depth, over the scene's scale", gaps, gap_over_scale, nullptr},
      {"length", "m", "length of the longest body", decades,
       [](const SizedScene& asked) { return std::optional(asked.sizes.lengths.hi); },
       [](const Domain& domain) { return domain.lengths ? up_to(domain.lengths->hi) : std::nullopt; }},
      {"thickness", "m", "thickness of the thinnest body", decades,
       [](const SizedScene& asked) { return std::optional(asked.sizes.lengths.lo); },
       [](const Domain& domain) {
         return domain.lengths ? std::optional(Interval{domain.lengths->lo, infinity}) : std::nullopt;
       }},
      {"reach", "m", "largest coordinate of any point of a body", decades,
       [](const SizedScene& asked) { return std::optional(asked.sizes.reach); },
       [](const Domain& domain) { return up_to(domain.reach); }},
      {"aspect", "1", "length over thickness of the most slender body", ratios,
       [](const SizedScene& asked) { return std::optional(asked.sizes.aspect); },
       [](const Domain& domain) { return up_to(domain.aspect); }},
      {"vertices",
       "1",
       "vertices of the largest polytope",
       {0, 4, 8, 16, 32, 64, 128, 256, 512},
       [](const SizedScene& asked) { return std::optional<double>(asked.sizes.vertices); },
       [](const Domain& domain) { return up_to(domain.vertices); }},
      {"mass ratio", "1", "greatest mass over least mass", ratios, mass_ratio,
       [](const Domain& domain) { return up_to(domain.mass_ratio); }},
      {"slip", "m/s", "speed of the contact point of A along B", speeds, slip, nullptr},
      {"friction",
       "1",
       "coefficient of the contact, or the largest of a body",
       {0, 0.01, 0.1, 0.3, 1, 10},
       friction,
       nullptr},
      {"speed", "m/s", "largest speed of a centre of mass at the start", speeds,
       [](const SizedScene& asked) { return of_motion(asked, asked.sizes.speed); },
       [](const Domain& domain) { return up_to(domain.speed); }},
      {"spin", "rad/s", "largest angular speed at the start", speeds,
       [](const SizedScene& asked) { return of_motion(asked, asked.sizes.angular_speed); },
       [](const Domain& domain) { return up_to(domain.angular_speed); }}};
  return all;
}

std::vector<AtlasPlace> places_of(const Scene& scene, const std::string& query) {
  const SizedScene asked{scene, query, oracle::sizes_of(scene)};
  std::vector<AtlasPlace> places;
  for (std::size_t axis = 0; axis < atlas_axes().size(); ++axis) {
    const std::optional<double> value = atlas_axes()[axis].value(asked);
    if (value && !std::isnan(*value)) places.emplace_back(axis, class_of(atlas_axes()[axis], *value));
  }
  return places;
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
