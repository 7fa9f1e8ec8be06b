#include "tests/bench/broad_phase/seat.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <stdexcept>

#include "tests/bench/cpu_time.h"

namespace touchstone::bench {
namespace {

constexpr double slice_seconds = 0.25;

struct Round {
  double ns = 0;
  double pairs_per_body = 0;
};

class Player {
 public:
  Player(const Entrant& entrant, const FrameSequence& sequence)
      : sequence_(sequence), contestant_(entrant.enter(sequence.start, sequence.world)) {}

  void play_frame() {
    const std::size_t frames = sequence_.forward.size();
    const Frame& frame = at_ < frames ? sequence_.forward[at_] : sequence_.backward[2 * frames - 1 - at_];
    pairs_ += static_cast<double>(contestant_->pairs_after(frame));
    at_ = (at_ + 1) % (2 * frames);
    ++played_;
  }

  Round play_round() {
    const double start = cpu_seconds();
    const double bodies = static_cast<double>(sequence_.start.size());
    double used = 0;
    double frames = 0;
    while (frames < static_cast<double>(2 * sequence_.forward.size()) && used < slice_seconds) {
      play_frame();
      ++frames;
      used = cpu_seconds() - start;
    }
    return {1e9 * used / frames / bodies, pairs_ / played_ / bodies};
  }

 private:
  const FrameSequence& sequence_;
  std::unique_ptr<Contestant> contestant_;
  std::size_t at_ = 0;
  double played_ = 0;
  double pairs_ = 0;
};

[[noreturn]] void live(const Entrant& entrant, const FrameSequence& sequence, unsigned budget, int in, int out) {
  const rlimit limit{budget, budget};
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CPU, &limit);
  setrlimit(RLIMIT_CORE, &no_core);
  Player player(entrant, sequence);
  player.play_frame();
  Round round;
  char word = 0;
  while (write(out, &round, sizeof round) == sizeof round && read(in, &word, 1) == 1 && word == 'r')
    round = player.play_round();
  _exit(0);
}

}  // namespace

Seat::Seat(const Entrant& entrant, const FrameSequence& sequence, unsigned budget) : entrant_(entrant) {
  std::signal(SIGPIPE, SIG_IGN);
  std::array<int, 2> down{};
  std::array<int, 2> up{};
  if (pipe(down.data()) != 0 || pipe(up.data()) != 0) throw std::runtime_error("no pipe to be had");
  child_ = fork();
  if (child_ < 0) throw std::runtime_error("no process to be had");
  if (child_ == 0) {
    close(down[1]);
    close(up[0]);
    live(entrant, sequence, budget, down[0], up[1]);
  }
  close(down[0]);
  close(up[1]);
  to_child_ = down[1];
  from_child_ = up[0];
  hear();
  ns_.clear();
}

Seat::~Seat() {
  const ssize_t written = write(to_child_, "q", 1);
  static_cast<void>(written);  // the child may have ended already
  close(to_child_);
  close(from_child_);
  waitpid(child_, nullptr, 0);
}

void Seat::play_round() {
  if (left_out_) return;
  left_out_ = write(to_child_, "r", 1) != 1;
  hear();
}

void Seat::hear() {
  Round round;
  left_out_ = left_out_ || read(from_child_, &round, sizeof round) != sizeof round;
  ns_.push_back(round.ns);
  pairs_per_body_ = round.pairs_per_body;
}

double Seat::ns_per_body_and_frame() const {
  std::vector<double> ns = ns_;
  const auto middle = ns.begin() + static_cast<std::ptrdiff_t>(ns.size() / 2);
  std::nth_element(ns.begin(), middle, ns.end());
  return *middle;
}

}  // namespace touchstone::bench
