// A subject in a process of its own, asked over JSON lines (docs/protocol.md): whatever it does, the run goes on.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "oracle/child_process.h"
#include "oracle/subject.h"

namespace touchstone::oracle {

struct PipeLimits {
  double cpu_seconds = 2;                            ///< of the subject's own time a question; beyond it, it hangs
  double wall_seconds = 20;                          ///< a question; the backstop for one that sleeps
  double flights = 1;                                ///< both, times this, for a question of simulation or constraint
  int recycle_after = 0;                             ///< questions, then a fresh process; 0: never
  std::size_t longest_line = std::size_t{64} << 20;  ///< bytes; a longer answer is garbage
  bool (*given_up)() = nullptr;  ///< asked again and again: does nobody wait for the answer any more?
};

/// Each object owns its process; several threads may each own objects of their own.
class PipeSubject : public Subject {
 public:
  /// Starts `command` (program and arguments; looked up in PATH if it has no slash) and reads its card. Throws
  /// InputError if it does not start or does not introduce itself.
  explicit PipeSubject(std::vector<std::string> command, PipeLimits limits = {});
  ~PipeSubject() override;

  const Card& card() const override { return card_; }

  /// A query that the card does not claim is abstained from without asking.
  Answer<Masses> mass(const Scene& scene) override;
  Answer<Bounds> bounds(const Scene& scene) override;
  Answer<PairSet> broad_phase(const Scene& scene) override;
  Answer<PairHistory> pair_history(const Scene& scene) override;
  Answer<Distance> distance(const Scene& scene) override;
  Answer<Penetration> penetration(const Scene& scene) override;
  Answer<Impulse> impulse(const Scene& scene) override;
  Answer<Pixels> pixel(const Scene& scene) override;
  Answer<TimeOfImpact> time_of_impact(const Scene& scene) override;
  Answer<Trajectory> simulation(const Scene& scene) override;
  Answer<Trajectory> constraint(const Scene& scene) override;

  /// Ends the process; the next question is asked of a fresh one.
  void restart();

 private:
  template <class T>
  Answer<T> ask(const std::string& query, const Scene& scene);
  Card start();

  std::vector<std::string> command_;
  PipeLimits limits_;
  Card card_;
  std::unique_ptr<ChildProcess> child_;
  std::int64_t seq_ = 0;
  int asked_ = 0;  ///< of this process
};

/// The names of the subjects whose programs (`touchstone-subject-NAME`) stand in `folder`, sorted.
std::vector<std::string> subjects_beside(const std::string& folder);

/// `NAME` (a program in `folder`) or `exec:COMMAND LINE` (quoting as in a shell). Throws InputError; for an unknown
/// name it lists those that there are.
std::unique_ptr<Subject> connect(const std::string& connectable, const std::string& folder, PipeLimits limits = {});

}  // namespace touchstone::oracle
