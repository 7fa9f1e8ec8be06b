// Islands: bodies connected by contacts, which take their steps together.
#pragma once

#include "fast/simulation/island/island_step.h"
#include "fast/simulation/island/step_bound.h"

namespace touchstone::fast::simulation {

/// A contact graph with a clock of its own: its states are those at `since`, and it is within a step that ends at
/// `until`, asleep, or waits for its next step to begin.
class Island {
 public:
  Island(ContactGraph graph, double now) : graph_(std::move(graph)), since_(now) {}

  const ContactGraph& graph() const { return graph_; }
  ContactGraph& graph() { return graph_; }

  double since() const { return since_; }  ///< s; the time of the states
  double until() const { return until_; }  ///< s; the end of the current step; never: the island sleeps
  bool waits() const { return waits_; }    ///< the next step has not begun
  bool sleeps() const { return until_ == never; }
  const StepPlan& plan() const { return *plan_; }                ///< of the current step
  const StepDeviation& deviation() const { return deviation_; }  ///< of the current step
  /// The speed at which bodies may leave their represented trajectories within the step (m/s), up to its margin.
  double drift() const { return deviation_.margin > 0 ? 2 * deviation_.margin / (until_ - since_) : 0; }

  /// The states at `time` inside the current step, from a step of length `time - since`. Changes no state.
  std::vector<State> states_at(double time) const;

  /// Begins a step: one of `steps` while a body falls by its size, turns by a radian or moves by its size, at most
  /// `most` (s), or shorter (`shorten`, island_step.h).
  void begin_step(double steps, double most);
  void sleep();
  /// Ends the current step at `time`: its planned end or an earlier one. Returns the residual of the step that was
  /// taken (m, contact/step.h); none if time did not advance, or if the island sleeps.
  std::optional<double> end_step(double time);
  /// Makes the next steps shorter for a while, but not shorter than `least_share` of the longest step, and not much
  /// longer than `expected`, in which a contact should come (s). Returns false if the current step is as short as
  /// `least_share` already, and true if there has been no step.
  bool shorten(double least_share, double expected = never);
  /// The bound that this makes.
  StepBound& bound() { return bound_; }

  /// Sets the velocity of a body. Its contacts may separate, so events for those that remain are emitted again.
  void set_velocity(BodyId id, const Velocity& velocity);
  /// Counts an impact at the current time. Returns false if there have been so many at this time that each seems to
  /// cause the next.
  bool allows_impact();

  /// Adds the bodies and contact pairs of another island, which must be at the same time.
  void absorb(const Island& other);
  /// The islands that its contact pairs still connect, which wait.
  std::vector<Island> components() const;

 private:
  struct Impacts {
    double time = -never;   ///< s
    std::size_t count = 0;  ///< at that time
  };

  ContactGraph graph_;
  double since_, until_ = 0;
  StepBound bound_;
  double step_length_ = 0;  ///< s; the longest step
  StepDeviation deviation_;
  bool waits_ = true;
  std::optional<StepPlan> plan_;
  Impacts impacts_;
};

/// Of the longest step: no step is requested to be shorter.
inline constexpr double shortest_step = 0x1p-20;

}  // namespace touchstone::fast::simulation
