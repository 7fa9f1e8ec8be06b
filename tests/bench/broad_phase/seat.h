// Runs a contestant in a process of its own, so that one that hangs can be killed while the others continue.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "tests/bench/broad_phase/contestant.h"
#include "tests/bench/broad_phase/workload.h"

namespace touchstone::bench {

/// Plays its sequence forward and backward in an endless loop, one round at a time: a round is the sequence there and
/// back, or as many frames as fit in a slice of CPU time.
class Seat {
 public:
  /// Returns when the contestant has been set up and has played a frame. The system kills it when it has used `budget`
  /// CPU seconds.
  Seat(const Entrant& entrant, const FrameSequence& sequence, unsigned budget);
  ~Seat();
  Seat(const Seat&) = delete;
  Seat& operator=(const Seat&) = delete;

  void play_round();

  const Entrant& entrant() const { return entrant_; }
  bool left_out() const { return left_out_; }
  double ns_per_body_and_frame() const;  ///< median over the rounds
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
