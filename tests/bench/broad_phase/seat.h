// A contestant in a process of its own, so that one that never comes back can be ended and the others go on.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "tests/bench/broad_phase/contestant.h"
#include "tests/bench/broad_phase/workload.h"

namespace touchstone::bench {

/// Plays its film forward and backward without end, a round at a time: one film's length there and back, or as many
/// frames as fit a slice of CPU time.
class Seat {
 public:
  /// Returns once it has entered and played a frame. The system ends it when it has used `budget` CPU seconds.
  Seat(const Entrant& entrant, const Film& film, unsigned budget);
  ~Seat();
  Seat(const Seat&) = delete;
  Seat& operator=(const Seat&) = delete;

  void play_round();

  const Entrant& entrant() const { return entrant_; }
  bool left_out() const { return left_out_; }
  double ns_per_body_and_frame() const;  ///< median of the rounds
  double pairs_per_body() const { return pairs_per_body_; }

 private:
  void hear();

  const Entrant& entrant_;
  pid_t child_ = 0;
  int to_child_ = -1;
  int from_child_ = -1;
  bool left_out_ = false;
  std::vector<double> ns_;
  double pairs_per_body_ = 0;
};

}  // namespace touchstone::bench
