#include "reference/simultaneous/outcome.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "reference/distance.h"
#include "reference/exact/linear.h"
#include "reference/exact/rational.h"
#include "reference/impulse.h"
#include "reference/impulse/exact_vectors.h"
#include "reference/simultaneous/components.h"
#include "reference/simultaneous/contact_rows.h"

namespace touchstone::reference {
namespace {

Vec3 rounded(const ExactVec3& v) { return {v[0].nearest(), v[1].nearest(), v[2].nearest()}; }

Vec3 rounded(const Triple& v) { return {nearest(v[0]), nearest(v[1]), nearest(v[2])}; }

const Body& body(const Scene& scene, int i) { return scene.bodies[index(i)]; }

Scene pair_of(const Scene& scene, int a, int b) {
  Scene pair;
  pair.bodies = {body(scene, a), body(scene, b)};
  return pair;
}

Event event_of(const Scene& then, double time, const ContactRegion& region, const Vec3& p_WC, const Vec3& P_A_W,
               const std::array<Velocity, 2>& after) {
  Event event;
  event.time = time;
  event.a = region.a;
  event.b = region.b;
  event.p_WC = p_WC;
  event.nhat_BA_W = region.nhat_BA_W;
  event.P_A_W = P_A_W;
  event.after_a = {body(then, region.a).X_WB, after[0]};
  event.after_b = {body(then, region.b).X_WB, after[1]};
  return event;
}

/// One impact at C, by the law of one contact point.
struct LoneImpact {
  Vec3 p_WC;
  ImpulseTruth impulse;
};

LoneImpact impact_at(const Scene& then, const ContactRegion& region, const Vec3& p_WC) {
  Scene pair = pair_of(then, region.a, region.b);
  pair.contact.emplace();
  pair.contact->p_WC = p_WC;
  pair.contact->nhat_BA_W = region.nhat_BA_W;
  pair.contact->law = then.motion->law;
  pair.contact->restitution = restitution(then, region);
  pair.contact->friction = friction(then, region);
  return {p_WC, reference::impulse(pair)};
}

/// A region that slides on to the end acts at its sliding centre; else at the centre of pressure without friction.
LoneImpact lone_impact(const Scene& then, const ContactRegion& region) {
  if (region.points_W.size() == 1) return impact_at(then, region, region.points_W.front());
  if (friction(then, region) != 0) {
    if (const std::optional<Vec3> centre = sliding_centre(then, region)) {
      LoneImpact sliding = impact_at(then, region, *centre);
      if (sliding.impulse.modes.straight && !sliding.impulse.modes.slip_stops_in_compression &&
          !sliding.impulse.modes.slip_stops_in_restitution) {
        return sliding;
      }
    }
  }
  return impact_at(then, region, compression(then, {region}).value().front().centre_W);
}

ImpactOutcome alone(const Scene& then, double time, const ContactRegion& region) {
  const auto [p_WC, impulse] = lone_impact(then, region);
  if (impulse.modes.separating) return {{}, "whether they approach is undecided"};
  if (impulse.ambiguous) return {{}, "more than one impulse is right"};
  const auto velocity = [&after = impulse.after](std::size_t k) {
    return Velocity{rounded(after[k].v_WBcm), rounded(after[k].w_WB)};
  };
  return {{event_of(then, time, region, p_WC, rounded(impulse.P_A_W), {velocity(0), velocity(1)})}, ""};
}

ImpactOutcome together(const Scene& then, double time, const std::vector<ContactRegion>& regions) {
  for (const ContactRegion& region : regions) {
    if (friction(then, region) != 0) return {{}, "impacts act together with friction: the law leaves the outcome open"};
  }
  const auto rounds = all_rounds(then, regions);
  if (!rounds) return {{}, "a body is clamped between others"};
  std::map<int, std::array<Triple, 2>> velocities;  // v and w so far, by body, not yet rounded
  ImpactOutcome outcome;
  for (std::size_t k = 0; k < regions.size(); ++k) {
    const RegionImpulse& impulse = rounds->impulses[k];
    const Triple P = triple(impulse.P_A_W);
    if (P == Triple{}) continue;
    const std::array<int, 2> ends = {regions[k].a, regions[k].b};
    std::array<Velocity, 2> after;
    for (std::size_t side = 0; side < 2; ++side) {
      const Velocity& before = body(then, ends[side]).velocity;
      const auto now =
          velocities.try_emplace(ends[side], std::array<Triple, 2>{triple(before.v_WBcm), triple(before.w_WB)});
      auto& [v, w] = now.first->second;
      v = plus(v, triple(impulse.changes[side].v_WBcm));
      w = plus(w, triple(impulse.changes[side].w_WB));
      after[side] = {rounded(v), rounded(w)};
    }
    outcome.events.push_back(event_of(then, time, regions[k], impulse.centre_W, rounded(P), after));
  }
  return outcome;
}

/// By the moving bodies that they share; each in the order of `regions`.
std::vector<std::vector<ContactRegion>> by_shared_bodies(const Scene& then, const std::vector<ContactRegion>& regions) {
  const auto moving = [&](int i) {
    return std::holds_alternative<Fixed>(body(then, i).mass) ? std::nullopt : std::optional(i);
  };
  std::vector<MovingPair> pairs;
  for (const ContactRegion& region : regions) pairs.push_back({moving(region.a), moving(region.b)});
  std::vector<std::size_t> all(regions.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::vector<std::vector<ContactRegion>> parts;
  for (const std::vector<std::size_t>& component : components(pairs, all)) {
    parts.emplace_back();
    for (const std::size_t r : component) parts.back().push_back(regions[r]);
  }
  return parts;
}

}  // namespace

std::vector<ContactRegion> acting_regions(const Scene& then, double time, int a, int b, double envelope) {
  std::vector<ContactRegion> regions = approaching_regions(then, std::min(a, b), std::max(a, b), envelope);
  if (regions.empty()) return regions;
  std::set<std::pair<int, int>> asked = {std::minmax(a, b)};
  std::set<int> known = {a, b};
  std::vector<int> connected = {a, b};
  const auto has_started = [&](int j) { return then.motion->start_times[index(j)] <= time; };
  for (std::size_t k = 0; k < connected.size(); ++k) {
    const int i = connected[k];
    if (std::holds_alternative<Fixed>(body(then, i).mass)) continue;
    for (int j = 0; j < static_cast<int>(then.bodies.size()); ++j) {
      if (j == i || !has_started(j) || distance(pair_of(then, i, j)).distance.lo > envelope) continue;
      if (known.insert(j).second) connected.push_back(j);
      if (!asked.insert(std::minmax(i, j)).second) continue;
      const auto found = approaching_regions(then, std::min(i, j), std::max(i, j), envelope);
      regions.insert(regions.end(), found.begin(), found.end());
    }
  }
  std::ranges::stable_sort(regions, {}, [](const ContactRegion& region) { return std::pair(region.a, region.b); });
  return regions;
}

ImpactOutcome impact_outcome(const Scene& then, double time, const std::vector<ContactRegion>& regions) {
  if (regions.empty()) return {{}, "where they touch is undecided"};
  ImpactOutcome all;
  for (const std::vector<ContactRegion>& part : by_shared_bodies(then, regions)) {
    ImpactOutcome outcome = part.size() == 1 ? alone(then, time, part.front()) : together(then, time, part);
    if (!outcome.undecided.empty()) return outcome;
    all.events.insert(all.events.end(), outcome.events.begin(), outcome.events.end());
  }
  std::ranges::stable_sort(all.events, {}, [](const Event& event) { return std::pair(event.a, event.b); });
  return all;
}

}  // namespace touchstone::reference
