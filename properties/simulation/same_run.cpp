// The clauses of docs/spec/simulation.md about changes of a scene that change no bit of its run, as executable
// properties.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "oracle/judge/words.h"
#include "properties/cases/trajectory_case.h"
#include "properties/queries.h"
#include "properties/transforms/motion.h"
#include "properties/transforms/scene.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Subject;
namespace judge = oracle::judge;
namespace words = oracle::words;

// Multiples of four, so that square and cube roots of masses, inertias and energies stay exact.
constexpr int length_scale = 24, mass_scale = 24;

void scale(Vec3& v, int k) {
  for (double& x : v) x = std::ldexp(x, k);
}

void scale_length(State& state, int k) {
  scale(state.X_WB.p_WB, k);
  scale(state.velocity.v_WBcm, k);
}

/// The same run in other units: lengths times 2^lengths, masses times 2^masses.
Trajectory in_units(Trajectory said, int lengths, int masses) {
  for (std::vector<State>& states : said.states) {
    for (State& state : states) scale_length(state, lengths);
  }
  if (said.contact_solver) said.contact_solver->residual = std::ldexp(said.contact_solver->residual, lengths);
  if (!said.events) return said;
  for (Event& event : *said.events) {
    scale(event.p_WC, lengths);
    scale(event.P_A_W, masses + lengths);
    scale_length(event.after_a, lengths);
    scale_length(event.after_b, lengths);
  }
  return said;
}

/// A run that comes to rest by ever smaller velocities ends with numbers whose products underflow, in one unit sooner
/// than in the other. The limits are choices: a square of 2^-25 is 2^76 times the least normal single.
bool underflows(const Trajectory& said, oracle::Precision precision) {
  const double least = precision == oracle::Precision::binary32 ? 0x1p-25 : 0x1p-200;
  const auto tiny = [least](const Vec3& v) {
    return std::any_of(v.begin(), v.end(), [=](double x) { return x != 0 && std::abs(x) < least; });
  };
  const auto in = [&](const State& state) { return tiny(state.velocity.v_WBcm) || tiny(state.velocity.w_WB); };
  return std::ranges::any_of(said.states, [&](const auto& states) { return std::ranges::any_of(states, in); }) ||
         std::ranges::any_of(*said.events,
                             [&](const Event& e) { return in(e.after_a) || in(e.after_b) || tiny(e.P_A_W); });
}

/// Where two runs differ first, in words; "" if they do not. The text of `gave_up` may name lengths.
std::string difference(const Scene& scene, const Trajectory& one, const Trajectory& other) {
  if (one.complete_until != other.complete_until) return "another time until which the run is complete";
  for (std::size_t sample = 0; sample < std::min(one.states.size(), other.states.size()); ++sample) {
    if (one.states[sample] == other.states[sample]) continue;
    return "other states at " + words::text(scene.motion->sample_times[sample]) + " s";
  }
  if (one.states.size() != other.states.size()) return "another number of samples";
  if (one.events != other.events) return "other events";
  return one.contact_solver == other.contact_solver ? "" : "other counts of the solver of contacts";
}

/// The run of the changed scene, brought back by `back`, is the same to the last bit.
template <class Back>
Finding same_run(const Scene& scene, const std::optional<Scene>& other, Defect defect, Back&& back, Subject& subject) {
  return of_timeline(scene, subject, [&](const TrajectoryCase& asked, const Timeline&) {
    if (asked.stepping) return judge::outside("a time-stepper");
    if (underflows(asked.said, asked.precision))
      return judge::outside("velocities or impulses whose products underflow");
    return of_moved(other, subject, [&](const Scene& changed) {
      return judge::given(subject.simulation(changed), [&](const Trajectory& said) {
        const std::string differs = difference(scene, back(said), asked.said);
        return differs.empty() ? judge::holds() : judge::wrong(defect, differs, "the same bits as without the change");
      });
    });
  });
}

// A power of two rounds nothing, so only a length that is written into the program makes a difference.
Finding lengths(const Scene& scene, Subject& subject) {
  if (!scene.motion) return judge::outside("no motion");
  return same_run(
      scene, scaled(scene, length_scale), Defect::scaled,
      [](Trajectory said) { return in_units(std::move(said), -length_scale, -3 * length_scale); }, subject);
}

Finding masses(const Scene& scene, Subject& subject) {
  if (!scene.motion) return judge::outside("no motion");
  return same_run(
      scene, heavier(scene, mass_scale), Defect::scaled,
      [](Trajectory said) { return in_units(std::move(said), 0, -mass_scale); }, subject);
}

/// The scene with one more sample before each, but none before all bodies have started.
Scene sampled_twice_as_often(Scene scene) {
  std::vector<double> times;
  const std::vector<double>& starts = scene.motion->start_times;
  double last = starts.empty() ? 0 : std::ranges::max(starts);
  for (const double time : scene.motion->sample_times) {
    const double between = last + (time - last) * 0.375;  // not a half: steps may end there
    if (between > last && between < time) times.push_back(between);
    times.push_back(time);
    last = time;
  }
  scene.motion->sample_times = times;
  return scene;
}

Finding samples(const Scene& scene, Subject& subject) {
  if (!scene.motion) return judge::outside("no motion");
  const Scene more = sampled_twice_as_often(scene);
  const auto only_those_asked_for_before = [&](Trajectory said) {
    std::vector<std::vector<State>> kept;
    std::size_t before = 0;
    for (std::size_t i = 0; i < std::min(said.states.size(), more.motion->sample_times.size()); ++i) {
      if (more.motion->sample_times[i] != scene.motion->sample_times[before]) continue;
      kept.push_back(std::move(said.states[i]));
      ++before;
    }
    said.states = std::move(kept);
    return said;
  };
  return same_run(scene, more, Defect::inconsistent, only_those_asked_for_before, subject);
}

}  // namespace

std::vector<Property> simulation_same_run_properties() {
  const std::string query = "simulation", clause = "TS-SIMULATION-";
  return {
      {"simulation.scaled", query, {clause + "36"}, "scaling all lengths by 2^24 scales the run exactly", lengths},
      {"simulation.heavier", query, {clause + "36"}, "scaling all masses by 2^24 changes no motion", masses},
      {"simulation.sampled", query, {clause + "37"}, "further samples change no bit of a run", samples},
  };
}

}  // namespace touchstone::properties
