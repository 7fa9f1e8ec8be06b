#include "fast/simulation/recorder.h"

namespace touchstone::fast::simulation {
namespace {

std::string reason(const Stopped& stopped) {
  const std::string text = stopped.why + ": bodies[" + std::to_string(stopped.a) + "]";
  return stopped.b < 0 ? text : text + " and bodies[" + std::to_string(stopped.b) + "]";
}

}  // namespace

Recorder::Recorder(const World& world, const Islands& islands, bool keep_events) : world_(&world), islands_(&islands) {
  if (keep_events) trajectory_.events.emplace();
}

double Recorder::next_sample() const {
  const std::vector<double>& times = world_->scene().motion->sample_times;
  return sampled_ < times.size() ? times[sampled_] : never;
}

void Recorder::sample_before(double time) {
  for (; next_sample() < time; ++sampled_) sample(next_sample());
}

void Recorder::sample_through(double time) {
  for (; next_sample() <= time; ++sampled_) sample(next_sample());
}

void Recorder::sample(double time) {
  std::vector<State>& states = trajectory_.states.emplace_back();
  for (const BodyMotion& body : world_->bodies()) states.push_back(body.state(time));
  for (const auto& [key, island] : islands_->all()) {
    const std::vector<State> island_states = island.states_at(time);
    const std::vector<IslandBody>& bodies = island.graph().bodies();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (!bodies[i].fixed()) states[bodies[i].id] = island_states[i];
    }
  }
}

void Recorder::record(const Event& event) {
  ++statistics_.count[static_cast<std::size_t>(event.kind)];
  last_event_ = event.time;
  if (trajectory_.events) trajectory_.events->push_back(event);
}

Simulated Recorder::take(const std::optional<Stopped>& stopped) {
  Simulated done;
  done.trajectory = std::move(trajectory_);
  done.statistics = statistics_;
  done.stopped = stopped;
  if (statistics_.contact_steps > 0) {
    done.trajectory.contact_solver = {static_cast<int>(statistics_.contact_steps),
                                      static_cast<int>(statistics_.unconverged), statistics_.residual};
  }
  if (stopped) {
    done.trajectory.complete_until = stopped->time;
    done.trajectory.gave_up = reason(*stopped);
  }
  return done;
}

}  // namespace touchstone::fast::simulation
