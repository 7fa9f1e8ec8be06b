// What a simulation reports: sampled states, events and statistics.
#pragma once

#include "fast/simulation.h"
#include "fast/simulation/island/islands.h"

namespace touchstone::fast::simulation {

class Recorder {
 public:
  /// The world and the islands must outlive the recorder. Without `keep_events` events are only counted.
  Recorder(const World& world, const Islands& islands, bool keep_events);

  double next_sample() const;  ///< s; never if there is none
  /// Samples the states at the scene's sample times before `time`; those at `time` itself show what its events change.
  void sample_before(double time);
  /// Also those at `time`, after its events.
  void sample_through(double time);
  void record(const Event& event);
  double last_event() const { return last_event_; }  ///< s; 0 if there was none

  Statistics& statistics() { return statistics_; }
  const Statistics& statistics() const { return statistics_; }
  /// What has been recorded, and why the run stopped. The recorder is then empty.
  Simulated take(const std::optional<Stopped>& stopped);

 private:
  void sample(double time);

  const World* world_;
  const Islands* islands_;
  std::size_t sampled_ = 0;  ///< sample times so far
  double last_event_ = 0;    ///< s
  Trajectory trajectory_;
  Statistics statistics_;
};

}  // namespace touchstone::fast::simulation
