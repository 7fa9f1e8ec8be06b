#include "reference/simultaneous/outcome.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "reference/distance.h"
#include "reference/exact/linear.h"
#include "reference/exact/rational.h"
#include "reference/impulse.h"
#include "reference/impulse/exact_vectors.h"
#include "reference/motion/ballistic_motion.h"
#include "reference/simultaneous/contact_rows.h"
#include "reference/time_of_impact/initial_contact.h"

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

bool moves(const Scene& then, int i) { return !std::holds_alternative<Fixed>(body(then, i).mass); }

/// The bodies that have started and are within the envelope of body i, by number.
std::vector<int> near(const Scene& then, double time, int i, double envelope) {
  std::vector<int> found;
  for (int j = 0; j < static_cast<int>(then.bodies.size()); ++j) {
    if (j == i || then.motion->start_times[index(j)] > time) continue;
    if (distance(pair_of(then, i, j)).distance.lo <= envelope) found.push_back(j);
  }
  return found;
}

/// The regions of the pair, and of all pairs that approach and are connected to it by such pairs through bodies that
/// move, sorted by pair. Empty if the pair itself has none.
std::vector<ContactRegion> connected_regions(const Scene& then, double time, const BodyPair& pair, double envelope) {
  std::vector<ContactRegion> regions;
  std::set<BodyPair> asked;
  std::vector<int> connected;
  const auto ask = [&](int i, int j) {
    const BodyPair two = std::minmax(i, j);
    if (!asked.insert(two).second) return;
    const std::vector<ContactRegion> found = approaching_regions(then, two.first, two.second, envelope);
    if (found.empty()) return;
    regions.insert(regions.end(), found.begin(), found.end());
    connected.insert(connected.end(), {i, j});
  };
  ask(pair.first, pair.second);
  for (std::size_t k = 0; k < connected.size(); ++k) {
    const int i = connected[k];
    if (!moves(then, i)) continue;
    for (const int j : near(then, time, i, envelope)) ask(i, j);
  }
  std::ranges::stable_sort(regions, {}, [](const ContactRegion& region) { return std::pair(region.a, region.b); });
  return regions;
}

/// The bodies that move and are connected to the pair by pairs within the envelope, whether these approach or not.
std::set<int> cluster(const Scene& then, double time, const BodyPair& pair, double envelope) {
  std::vector<int> connected;
  std::set<int> known;
  const auto add = [&](int i) {
    if (moves(then, i) && known.insert(i).second) connected.push_back(i);
  };
  add(pair.first);
  add(pair.second);
  for (std::size_t k = 0; k < connected.size(); ++k) {
    for (const int j : near(then, time, connected[k], envelope)) add(j);
  }
  return known;
}

/// The time (s) in which the pair that has these regions would cross the envelope.
double crossing_time(const Scene& then, const std::vector<ContactRegion>& regions, const BodyPair& pair,
                     double envelope) {
  Scene two = pair_of(then, pair.first, pair.second);
  two.motion = touchstone::Motion{.sample_times = then.motion->sample_times};
  const BallisticStart a = ballistic_start(two, 0), b = ballistic_start(two, 1);
  double speed = 0;
  for (const ContactRegion& region : regions) {
    if (BodyPair(region.a, region.b) != pair) continue;
    for (const Vec3& x : region.points_W) {
      const Triple u = minus(velocity(a, triple(x)), velocity(b, triple(x)));
      speed = std::max(speed, -region.nhat_BA_W.normalized().dot(rounded(u)));
    }
  }
  return envelope / speed;
}

ImpactOutcome of_regions(const Scene& then, double time, const std::vector<ContactRegion>& regions) {
  return regions.size() == 1 ? alone(then, time, regions.front()) : together(then, time, regions);
}

}  // namespace

ImpactOutcome impact_outcome(const Scene& then, double time, const BodyPair& pair, double envelope,
                             const ImpactTimes& next) {
  const std::vector<ContactRegion> regions = connected_regions(then, time, pair, envelope);
  if (regions.empty()) return {{}, "where they touch is undecided"};
  ImpactOutcome all = of_regions(then, time, regions);
  if (!all.undecided.empty()) return all;
  std::set<int> acting;
  const auto note = [&](const std::vector<ContactRegion>& some) {
    for (const ContactRegion& region : some) acting.insert({region.a, region.b});
  };
  note(regions);
  const double until = time + crossing_time(then, regions, pair, envelope);
  const auto is_new = [&](int i) { return moves(then, i) && !acting.contains(i); };
  std::optional<std::set<int>> connected;
  for (const auto& [other, due] : next) {
    if (due > until || !(is_new(other.first) || is_new(other.second))) continue;
    if (!connected) connected = cluster(then, time, pair, envelope);
    if (!connected->contains(other.first) && !connected->contains(other.second)) continue;
    if (distance(pair_of(then, other.first, other.second)).distance.lo > envelope) continue;
    const std::vector<ContactRegion> apart = connected_regions(then, time, other, envelope);
    if (apart.empty()) continue;
    const ImpactOutcome outcome = of_regions(then, time, apart);
    if (!outcome.undecided.empty()) continue;
    all.events.insert(all.events.end(), outcome.events.begin(), outcome.events.end());
    note(apart);
  }
  std::ranges::stable_sort(all.events, {}, [](const Event& event) { return std::pair(event.a, event.b); });
  return all;
}

}  // namespace touchstone::reference
