#include "reference/simulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "model/input_error.h"
#include "model/limits.h"
#include "reference/distance.h"
#include "reference/exact/linear.h"
#include "reference/exact/rational.h"
#include "reference/impulse.h"
#include "reference/motion/plain_pose.h"
#include "reference/simultaneous.h"
#include "reference/time_of_impact/next_impact.h"

namespace touchstone::reference {
namespace {

bool is_fixed(const Body& body) { return std::holds_alternative<Fixed>(body.mass); }

Vec3 nearest(const ExactVec3& v) { return {v[0].nearest(), v[1].nearest(), v[2].nearest()}; }

Triple exact(const ExactVec3& v) { return {value_of(v[0]), value_of(v[1]), value_of(v[2])}; }

Vec3 rounded(const Triple& v) {
  using reference::nearest;
  return {nearest(v[0]), nearest(v[1]), nearest(v[2])};
}

State state_of(const Body& body) { return {body.X_WB, body.velocity}; }

/// The event that may come next. An applied force has b = −1. Not `known`: the pair's motion after `time` is unknown.
struct PendingEvent {
  double time;
  int a, b;
  bool known;
  bool micro_bounces = false;

  bool operator<(const PendingEvent& other) const {
    return std::tie(time, a, b) < std::tie(other.time, other.a, other.b);
  }
};

/// All ballistic motions under way: the scene, with each body at its latest start.
class Simulation {
 public:
  Simulation(const Scene& scene, const SimulationLimits& limits) : now_(scene), limits_(limits) {
    now_.motion.value().start_times.resize(now_.bodies.size());  // g++ 14 takes -> for one that may be missing
    for (const AppliedForce& applied : scene.motion->forces) {
      if (applied.time > start_time(applied.body) && applied.time <= scene.motion->sample_times.back())
        pending_forces_.push_back({applied.time, applied.body, -1, true});
    }
    trajectory_.events.emplace();
  }

  Trajectory run() {
    try {
      follow();
    } catch (const MotionUnknown& lost) {
      trajectory_.complete_until = complete_until_;
      trajectory_.gave_up = lost.what();
    }
    return std::move(trajectory_);
  }

 private:
  void follow() {
    for (int b = 1; b < bodies(); ++b) {
      for (int a = 0; a < b; ++a) predict_impact(a, b);
    }
    while (const std::optional<PendingEvent> pending = next()) {
      sample_until(pending->time);
      if (pending->b >= 0) {
        const std::string why = pending->known ? apply_impact(*pending) : "whether the bodies touch is undecided";
        if (!why.empty()) return give_up(*pending, why);
      }
      if (pending->b < 0) apply_force(*pending);
      complete_until_ = pending->time;
    }
    sample_until(now_.motion->sample_times.back());
  }

  int bodies() const { return static_cast<int>(now_.bodies.size()); }
  Body& body(int i) { return now_.bodies[static_cast<std::size_t>(i)]; }
  double& start_time(int i) { return now_.motion->start_times[static_cast<std::size_t>(i)]; }

  /// A scene of these bodies only, under the forces that act now.
  Scene alone(const std::vector<int>& few) {
    Scene scene;
    scene.gravity = now_.gravity;
    scene.motion = touchstone::Motion{.sample_times = {now_.motion->sample_times.back()}, .law = now_.motion->law};
    scene.motion->force_bound = now_.motion->force_bound;
    for (const int i : few) {
      scene.bodies.push_back(body(i));
      scene.motion->start_times.push_back(start_time(i));
    }
    for (AppliedForce begun : now_.motion->forces) {
      const auto it = std::ranges::find(few, begun.body);
      if (it == few.end() || begun.time > start_time(begun.body)) continue;
      begun.body = static_cast<int>(it - few.begin());
      scene.motion->forces.push_back(begun);
    }
    return scene;
  }

  void predict_impact(int a, int b) {
    if (is_fixed(body(a)) && is_fixed(body(b))) return;
    const NextImpact impact = next_impact(alone({a, b}), envelope(now_));
    if (std::isfinite(impact.time)) impacts_.push_back({impact.time, a, b, impact.known, impact.micro_bounces});
  }

  std::optional<PendingEvent> next() const {
    std::optional<PendingEvent> first;
    for (const std::vector<PendingEvent>* list : {&impacts_, &pending_forces_}) {
      const auto least = std::ranges::min_element(*list, std::less<>());
      if (least != list->end() && (!first || *least < *first)) first = *least;
    }
    return first;
  }

  /// Ends the body's ballistic motion and starts the next one here.
  void restart(int i, double time) {
    body(i) = moved(alone({i}), 0, time);
    start_time(i) = time;
    std::erase_if(impacts_, [i](const PendingEvent& pending) { return pending.a == i || pending.b == i; });
  }

  void predict_impacts_of(const std::vector<int>& few) {
    for (int b = 1; b < bodies(); ++b) {
      for (int a = 0; a < b; ++a) {
        if (std::ranges::find(few, a) != few.end() || std::ranges::find(few, b) != few.end())
          predict_impact_again(a, b);
      }
    }
  }

  /// If rounding to doubles makes two bodies overlap, their next impact is unknown.
  void predict_impact_again(int a, int b) {
    try {
      predict_impact(a, b);
    } catch (const InputError&) {
      impacts_.push_back({std::max(start_time(a), start_time(b)), a, b, false});
    }
  }

  void apply_force(const PendingEvent& pending) {
    std::erase_if(pending_forces_,
                  [&](const PendingEvent& other) { return other.time == pending.time && other.a == pending.a; });
    restart(pending.a, pending.time);
    Event event;
    event.kind = Event::Kind::force;
    event.time = pending.time;
    event.a = pending.a;
    event.after_a = state_of(body(pending.a));
    trajectory_.events->push_back(event);
    predict_impacts_of({pending.a});
  }

  void give_up(const PendingEvent& pending, const std::string& why) {
    trajectory_.complete_until = pending.time;
    trajectory_.gave_up =
        why + ": bodies[" + std::to_string(pending.a) + "] and bodies[" + std::to_string(pending.b) + "]";
  }

  /// Returns the reason if the outcome is not certain or a limit is reached; else "".
  std::string apply_impact(const PendingEvent& pending) {
    int& micro_bounces = micro_bounces_[{pending.a, pending.b}];
    micro_bounces = pending.micro_bounces ? micro_bounces + 1 : 0;
    if (impacts_so_far_++ == limits_.impacts) return "more impacts than allowed";
    if (micro_bounces > limits_.micro_bounces) return "impacts pile up: they rest on each other, which is not followed";
    const Scene then = at(pending.time);
    const std::vector<ContactRegion> regions = acting_with(then, pending);
    if (regions.empty()) return "where they touch is undecided";
    return regions.size() == 1 ? apply_alone(then, pending.time, regions.front())
                               : apply_together(then, pending.time, regions);
  }

  /// All bodies at this time.
  Scene at(double time) {
    Scene then = now_;
    for (int i = 0; i < bodies(); ++i) {
      if (start_time(i) < time) then.bodies[static_cast<std::size_t>(i)] = moved(alone({i}), 0, time);
    }
    then.motion->start_times.assign(then.bodies.size(), time);
    return then;
  }

  /// The regions of all pairs within the envelope that approach, connected to the pair of this event through bodies
  /// that move and have started, sorted. Empty if the pair itself has none.
  std::vector<ContactRegion> acting_with(const Scene& then, const PendingEvent& pending) {
    std::vector<ContactRegion> regions;
    std::set<std::pair<int, int>> asked;
    std::vector<int> connected;
    const auto ask = [&](int i, int j) {
      const auto [a, b] = std::minmax(i, j);
      if (!asked.emplace(a, b).second) return;
      const std::optional<ContactRegion> region = approaching_region(then, a, b);
      if (!region) return;
      regions.push_back(*region);
      connected.insert(connected.end(), {a, b});
    };
    ask(pending.a, pending.b);
    for (std::size_t k = 0; k < connected.size(); ++k) {
      const int i = connected[k];
      if (is_fixed(body(i))) continue;
      for (int j = 0; j < bodies(); ++j) {
        if (j != i && start_time(j) <= pending.time && gap(then, i, j) <= envelope(now_)) ask(i, j);
      }
    }
    std::ranges::sort(regions, {}, [](const ContactRegion& region) { return std::pair(region.a, region.b); });
    return regions;
  }

  static double gap(const Scene& then, int i, int j) {
    Scene pair;
    pair.bodies = {then.bodies[static_cast<std::size_t>(i)], then.bodies[static_cast<std::size_t>(j)]};
    return distance(pair).distance.lo;
  }

  double restitution(const ContactRegion& region) {
    return std::min(body(region.a).material.restitution, body(region.b).material.restitution);
  }

  double friction(const ContactRegion& region) {
    return std::min(body(region.a).material.friction, body(region.b).material.friction);
  }

  /// One region acts through its centre of pressure, by the law of one contact point.
  std::string apply_alone(const Scene& then, double time, const ContactRegion& region) {
    Scene pair = alone({region.a, region.b});
    pair.bodies = {then.bodies[static_cast<std::size_t>(region.a)], then.bodies[static_cast<std::size_t>(region.b)]};
    pair.contact.emplace();
    pair.contact->p_WC =
        region.points_W.size() == 1 ? region.points_W.front() : compression(then, {region}).value().front().centre_W;
    pair.contact->nhat_BA_W = region.nhat_BA_W;
    pair.contact->law = pair.motion->law;
    pair.contact->restitution = restitution(region);
    pair.contact->friction = friction(region);
    const ImpulseTruth impulse = reference::impulse(pair);
    if (impulse.modes.separating) return "whether they approach is undecided";
    if (impulse.ambiguous) return "more than one impulse is right";
    restart(region.a, time);
    restart(region.b, time);
    const auto velocity = [&](std::size_t k) {
      return Velocity{nearest(impulse.after[k].v_WBcm), nearest(impulse.after[k].w_WB)};
    };
    body(region.a).velocity = velocity(0);
    body(region.b).velocity = velocity(1);
    report_impact(region, time, pair.contact->p_WC, nearest(impulse.P_A_W));
    predict_impacts_of({region.a, region.b});
    return {};
  }

  /// Several regions act at once, without friction and with one coefficient of restitution: 1 + e times the impulses of
  /// compression.
  std::string apply_together(const Scene& then, double time, const std::vector<ContactRegion>& regions) {
    const double e = restitution(regions.front());
    for (const ContactRegion& region : regions) {
      if (friction(region) != 0) return "impacts act together with friction: the law leaves the outcome open";
      if (restitution(region) != e)
        return "impacts with unlike restitution act together: the law leaves the outcome open";
    }
    const auto impulses = compression(then, regions);
    if (!impulses) return "a body is clamped between others";
    const mpq_class factor = 1 + mpq_class(e);
    std::map<int, std::array<Triple, 2>> velocities;  // v and w so far, by body, not yet rounded
    for (std::size_t k = 0; k < regions.size(); ++k) {
      const RegionImpulse& impulse = (*impulses)[k];
      const Triple P = scaled(factor, exact(impulse.P_A_W));
      if (P == Triple{}) continue;
      const std::array<int, 2> ends = {regions[k].a, regions[k].b};
      for (std::size_t side = 0; side < 2; ++side) {
        const int i = ends[side];
        if (!velocities.contains(i)) {
          restart(i, time);
          velocities[i] = {triple(body(i).velocity.v_WBcm), triple(body(i).velocity.w_WB)};
        }
        auto& [v, w] = velocities[i];
        v = plus(v, scaled(factor, exact(impulse.changes[side].v_WBcm)));
        w = plus(w, scaled(factor, exact(impulse.changes[side].w_WB)));
        body(i).velocity = {rounded(v), rounded(w)};
      }
      report_impact(regions[k], time, impulse.centre_W, rounded(P));
    }
    std::vector<int> hit;
    for (const auto& [i, velocity] : velocities) hit.push_back(i);
    predict_impacts_of(hit);
    return {};
  }

  void report_impact(const ContactRegion& region, double time, const Vec3& p_WC, const Vec3& P_A_W) {
    Event event;
    event.time = time;
    event.a = region.a;
    event.b = region.b;
    event.p_WC = p_WC;
    event.nhat_BA_W = region.nhat_BA_W;
    event.P_A_W = P_A_W;
    event.after_a = state_of(body(region.a));
    event.after_b = state_of(body(region.b));
    trajectory_.events->push_back(event);
  }

  /// Reports the states at the sample times up to `time`.
  void sample_until(double time) {
    const std::vector<double>& times = now_.motion->sample_times;
    for (; trajectory_.states.size() < times.size() && times[trajectory_.states.size()] <= time;) {
      std::vector<State> states;
      for (int i = 0; i < bodies(); ++i)
        states.push_back(state_of(moved(alone({i}), 0, times[trajectory_.states.size()])));
      complete_until_ = times[trajectory_.states.size()];
      trajectory_.states.push_back(std::move(states));
    }
  }

  Scene now_;
  SimulationLimits limits_;
  int impacts_so_far_ = 0;
  std::map<std::pair<int, int>, int> micro_bounces_;  ///< so far in succession, by pair
  double complete_until_ = 0;
  std::vector<PendingEvent> impacts_, pending_forces_;
  Trajectory trajectory_;
};

}  // namespace

Trajectory simulation(const Scene& scene, const SimulationLimits& limits) {
  if (!scene.motion) throw InputError("motion", "missing; expected one for a question about motion");
  return Simulation(scene, limits).run();
}

}  // namespace touchstone::reference
