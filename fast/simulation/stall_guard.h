// When a run is given up, and why.
#pragma once

#include <cstdint>
#include <optional>

#include "fast/broad_phase/strategy.h"
#include "fast/simulation.h"
#include "fast/simulation/work.h"

namespace touchstone::fast::simulation {

/// Counts iterations of the main loop within a stall window of time, but for contact steps, which have a limit of their
/// own. A run stops if a window has too many of them, if it has more events, micro-bounces, contact steps or work than
/// the options allow, or if the contacts of a step could not be solved.
class StallGuard {
 public:
  /// `frame` and `end`: the lengths of a frame and of the motion (s).
  StallGuard(const SimulationOptions& options, double frame, double end, std::size_t bodies);

  /// Counts an iteration that processes the pair. Returns false, and stops the run, if time hardly goes on or the run
  /// has taken all of its work.
  bool makes_progress(double now, BodyId a, BodyId b);
  /// So many separation queries for one first contact cost as much as some iterations.
  void count_queries(int queries);
  /// An iteration whose contact changes faster than time can advance counts as many.
  void count_lost_resolution();
  void check_events(const Statistics& statistics, double now, BodyId a, BodyId b) {
    if (statistics.events() > options_.most_events) stop(now, a, b, "more events than allowed");
    if (statistics.of(Event::Kind::micro_collision) > options_.most_micro_bounces) {
      stop(now, a, b, "a resting contact takes more micro-bounces than allowed");
    }
  }
  /// Stops the run if it has taken too many contact steps, or all of its work.
  void check_steps(const Statistics& statistics, double now, BodyId a, BodyId b);
  /// Stops the run if the residual of a step (m) exceeds its bound.
  void check_residual(double residual, double bound, double now, BodyId a, BodyId b);

  /// Does not count this work: samples do not decide where a run is given up.
  void leave_out(const MarkCounts& counts) { work_.leave_out(counts); }

  /// Stops the run at the pair, or at a alone.
  void stop(double now, BodyId a, std::optional<BodyId> b, const char* why);
  const std::optional<Stopped>& stopped() const { return stopped_; }

 private:
  bool has_work_left() const { return work_.done() <= most_work_; }

  const SimulationOptions options_;
  double window_;  ///< s
  std::int64_t most_iterations_, most_work_;
  Work work_;
  double window_end_ = 0;  ///< s
  std::int64_t iterations_ = 0;
  unsigned all_iterations_ = 0;
  std::optional<Stopped> stopped_;  ///< the last reason
};

}  // namespace touchstone::fast::simulation
