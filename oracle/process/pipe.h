// A subject in a process of its own, queried over JSON lines (docs/protocol.md). No failure of it ends the run.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/process/child_process.h"
#include "oracle/subject.h"

namespace touchstone::oracle {

struct PipeLimits {
  double cpu_seconds = 2;                            ///< the subject's own CPU time per query; beyond it, it hangs
  double wall_seconds = 20;                          ///< per query; a second limit, for a subject that sleeps
  double simulation_factor = 1;                      ///< factor of both limits for trajectories, and exact subjects
  int recycle_after = 0;                             ///< queries until a fresh process is started; 0: never
  std::size_t longest_line = std::size_t{64} << 20;  ///< bytes; a longer answer is garbage
  bool (*given_up)() = nullptr;                      ///< polled; true: the answer is no longer needed

  enum class Way { sent, received };
  void (*trace)(Way way, std::string_view line) = nullptr;  ///< called with each line, without its \n
};

/// Each object owns its process. Several threads may each use objects of their own.
class PipeSubject : public Subject {
 public:
  /// Starts `command` (program and arguments; looked up in PATH if it has no slash) and reads its card. Throws
  /// InputError if it does not start or does not introduce itself.
  explicit PipeSubject(std::vector<std::string> command, PipeLimits limits = {});
  ~PipeSubject() override;

  const Card& card() const override { return card_; }

  /// A query that the card does not list is answered with Abstains, without asking the process.
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

  /// Only a query that the card's `reproduces` lists is passed on.
  Answer<std::string> reproduce(const std::string& query, const Scene& scene, const std::string& expected) override;

  /// Only a query of one of the card's `work_limits` is passed on.
  Answer<Work> work(const std::string& query, const Scene& scene) override;

  /// Ends the process. The next query starts a fresh one.
  void restart();

  /// s: the CPU time of the subject's process, all threads, from the last question to its answer: it reads the question
  /// and writes the answer, and does not start. 0 if it broke.
  double cpu_seconds_of_answer() const { return cpu_seconds_of_answer_; }

 private:
  template <class T>
  Answer<T> ask(const std::string& query, const Scene& scene);
  template <class T, class Write, class Read>
  Answer<T> answer_to(Write&& write, Read&& read, double times);
  Card start();

  std::vector<std::string> command_;
  PipeLimits limits_;
  Card card_;
  std::unique_ptr<ChildProcess> child_;
  std::int64_t seq_ = 0;
  int asked_ = 0;  ///< queries to this process
  double cpu_seconds_of_answer_ = 0;
};

/// The names of the subjects whose programs (`touchstone-subject-NAME`) are in `folder`, sorted.
std::vector<std::string> subjects_beside(const std::string& folder);

/// Connects to `NAME` (a program in `folder`) or `exec:COMMAND LINE` (quoting as in a shell). Throws InputError; for an
/// unknown name it lists the known ones.
std::unique_ptr<Subject> connect(const std::string& connectable, const std::string& folder, PipeLimits limits = {});

}  // namespace touchstone::oracle
