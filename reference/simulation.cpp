#include "reference/simulation.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "model/input_error.h"
#include "model/limits.h"
#include "reference/impulse.h"
#include "reference/next_impact_impl.h"

namespace touchstone::reference {
namespace {

bool is_fixed(const Body& body) { return std::holds_alternative<Fixed>(body.mass); }

Vec3 nearest(const ExactVec3& v) { return {v[0].nearest(), v[1].nearest(), v[2].nearest()}; }

State state_of(const Body& body) { return {body.X_WB, body.velocity}; }

/// What ends a flight next. A push has b = −1; not known: the pair's future after `time`.
struct Due {
  double time;
  int a, b;
  bool known;
  bool rattles = false;

  bool operator<(const Due& other) const { return std::tie(time, a, b) < std::tie(other.time, other.a, other.b); }
};

/// All flights under way: the scene, with each body at its latest start.
class Course {
 public:
  Course(const Scene& scene, const SimulationLimits& limits) : now_(scene), limits_(limits) {
    now_.flight.value().since.resize(now_.bodies.size());  // g++ 14 takes -> for one that may be missing
    for (const Push& push : scene.flight->pushes) {
      if (push.time > since(push.body) && push.time <= scene.flight->times.back())
        pushes_.push_back({push.time, push.body, -1, true});
    }
    trajectory_.events.emplace();
  }

  Trajectory run() {
    try {
      follow();
    } catch (const Lost& lost) {
      trajectory_.complete_until = whole_until_;
      trajectory_.gave_up = lost.what();
    }
    return std::move(trajectory_);
  }

 private:
  void follow() {
    for (int b = 1; b < bodies(); ++b) {
      for (int a = 0; a < b; ++a) look_ahead(a, b);
    }
    while (const std::optional<Due> due = next()) {
      look_until(due->time);
      if (due->b >= 0) {
        const std::string why = due->known ? strike(*due) : "whether they meet is undecided";
        if (!why.empty()) return give_up(*due, why);
      }
      if (due->b < 0) push(*due);
      whole_until_ = due->time;
    }
    look_until(now_.flight->times.back());
  }

  int bodies() const { return static_cast<int>(now_.bodies.size()); }
  Body& body(int i) { return now_.bodies[static_cast<std::size_t>(i)]; }
  double& since(int i) { return now_.flight->since[static_cast<std::size_t>(i)]; }

  /// These bodies alone, pushed as they are now.
  Scene alone(const std::vector<int>& few) {
    Scene scene;
    scene.gravity = now_.gravity;
    scene.flight = Flight{.times = {now_.flight->times.back()}, .law = now_.flight->law};
    scene.flight->force_bound = now_.flight->force_bound;
    for (const int i : few) {
      scene.bodies.push_back(body(i));
      scene.flight->since.push_back(since(i));
    }
    for (Push begun : now_.flight->pushes) {
      const auto it = std::ranges::find(few, begun.body);
      if (it == few.end() || begun.time > since(begun.body)) continue;
      begun.body = static_cast<int>(it - few.begin());
      scene.flight->pushes.push_back(begun);
    }
    return scene;
  }

  void look_ahead(int a, int b) {
    if (is_fixed(body(a)) && is_fixed(body(b))) return;
    const NextImpact impact = next_impact(alone({a, b}), envelope(now_));
    if (std::isfinite(impact.time)) impacts_.push_back({impact.time, a, b, impact.known, impact.rattles});
  }

  std::optional<Due> next() const {
    std::optional<Due> first;
    for (const std::vector<Due>* list : {&impacts_, &pushes_}) {
      const auto least = std::ranges::min_element(*list, std::less<>());
      if (least != list->end() && (!first || *least < *first)) first = *least;
    }
    return first;
  }

  /// The body's flight ends here, and another begins.
  void restart(int i, double time) {
    body(i) = moved(alone({i}), 0, time);
    since(i) = time;
    std::erase_if(impacts_, [i](const Due& due) { return due.a == i || due.b == i; });
  }

  void look_ahead_of(const std::vector<int>& few) {
    for (int b = 1; b < bodies(); ++b) {
      for (int a = 0; a < b; ++a) {
        if (std::ranges::find(few, a) != few.end() || std::ranges::find(few, b) != few.end()) look_ahead_again(a, b);
      }
    }
  }

  /// Where doubles put two bodies into each other, nothing is known any more.
  void look_ahead_again(int a, int b) {
    try {
      look_ahead(a, b);
    } catch (const InputError&) {
      impacts_.push_back({std::max(since(a), since(b)), a, b, false});
    }
  }

  void push(const Due& due) {
    std::erase_if(pushes_, [&](const Due& other) { return other.time == due.time && other.a == due.a; });
    restart(due.a, due.time);
    Event event;
    event.kind = Event::Kind::push;
    event.time = due.time;
    event.a = due.a;
    event.after_a = state_of(body(due.a));
    trajectory_.events->push_back(event);
    look_ahead_of({due.a});
  }

  void give_up(const Due& due, const std::string& why) {
    trajectory_.complete_until = due.time;
    trajectory_.gave_up = why + ": bodies[" + std::to_string(due.a) + "] and bodies[" + std::to_string(due.b) + "]";
  }

  /// Says why not, if there is no certain answer to what happens, or too much happens.
  std::string strike(const Due& due) {
    int& rattles = rattles_[{due.a, due.b}];
    rattles = due.rattles ? rattles + 1 : 0;
    if (impacts_so_far_++ == limits_.impacts) return "more impacts than allowed";
    if (rattles > limits_.rattles) return "impacts pile up: they rest on each other, which is not followed";
    Scene pair = alone({due.a, due.b});
    for (std::size_t k = 0; k < 2; ++k) {
      if (pair.flight->since[k] != due.time) pair.bodies[k] = moved(pair, k, due.time);
      pair.flight->since[k] = due.time;
    }
    pair.contact = contact(pair);
    if (!pair.contact) return "where they touch is undecided";
    const ImpulseTruth impulse = reference::impulse(pair);
    if (impulse.modes.separating) return "whether they approach is undecided";
    if (impulse.ambiguous) return "more than one impulse is right";
    restart(due.a, due.time);
    restart(due.b, due.time);
    const auto velocity = [&](std::size_t k) {
      return Velocity{nearest(impulse.after[k].v_WBcm), nearest(impulse.after[k].w_WB)};
    };
    body(due.a).velocity = velocity(0);
    body(due.b).velocity = velocity(1);
    Event event;
    event.time = due.time;
    event.a = due.a;
    event.b = due.b;
    event.p_WC = pair.contact->p_WC;
    event.nhat_BA_W = pair.contact->nhat_BA_W;
    event.P_A_W = nearest(impulse.P_A_W);
    event.after_a = state_of(body(due.a));
    event.after_b = state_of(body(due.b));
    trajectory_.events->push_back(event);
    look_ahead_of({due.a, due.b});
    return {};
  }

  /// States at the scene's times that have come.
  void look_until(double time) {
    const std::vector<double>& times = now_.flight->times;
    for (; trajectory_.states.size() < times.size() && times[trajectory_.states.size()] <= time;) {
      std::vector<State> states;
      for (int i = 0; i < bodies(); ++i)
        states.push_back(state_of(moved(alone({i}), 0, times[trajectory_.states.size()])));
      whole_until_ = times[trajectory_.states.size()];
      trajectory_.states.push_back(std::move(states));
    }
  }

  Scene now_;
  SimulationLimits limits_;
  int impacts_so_far_ = 0;
  std::map<std::pair<int, int>, int> rattles_;  ///< so far, one after another
  double whole_until_ = 0;
  std::vector<Due> impacts_, pushes_;
  Trajectory trajectory_;
};

}  // namespace

Trajectory simulation(const Scene& scene, const SimulationLimits& limits) {
  if (!scene.flight) throw InputError("flight", "missing; expected one for a question about motion");
  return Course(scene, limits).run();
}

}  // namespace touchstone::reference
