#include "reference/simulation.h"

#include <algorithm>
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
#include "reference/simultaneous/outcome.h"
#include "reference/time_of_impact/next_impact.h"

namespace touchstone::reference {
namespace {

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
    ImpactTimes next;
    for (const PendingEvent& impact : impacts_) {
      if (impact.known) next[{impact.a, impact.b}] = impact.time;
    }
    const ImpactOutcome outcome = impact_outcome(then, pending.time, {pending.a, pending.b}, envelope(now_), next);
    if (!outcome.undecided.empty()) return outcome.undecided;
    std::set<int> hit;
    for (const Event& event : outcome.events) {
      for (const auto& [i, after] : {std::pair(event.a, &event.after_a), {event.b, &event.after_b}}) {
        if (hit.insert(i).second) restart(i, pending.time);
        body(i).velocity = after->velocity;
      }
      trajectory_.events->push_back(event);
    }
    predict_impacts_of({hit.begin(), hit.end()});
    return {};
  }

  /// All bodies at this time; those that start later, as they start.
  Scene at(double time) {
    Scene then = now_;
    for (int i = 0; i < bodies(); ++i) {
      if (start_time(i) < time) then.bodies[static_cast<std::size_t>(i)] = moved(alone({i}), 0, time);
    }
    return then;
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
