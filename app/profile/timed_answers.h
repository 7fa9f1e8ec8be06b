// Measures how long a subject takes to answer.
#pragma once

#include <variant>

#include "app/profile/run_times.h"
#include "oracle/passing_on.h"
#include "oracle/process/pipe.h"

namespace touchstone::app {

/// Passes all questions on and counts the CPU time of each that is answered; neither abstentions nor breaks count. Of a
/// subject in a process of its own it is the time of that process, which reads the question as JSON and writes the
/// answer; of one in this process, that of the call. `subject` and `times` must outlive this object.
class TimedAnswers final : public oracle::PassingOn<TimedAnswers> {
 public:
  TimedAnswers(oracle::Subject& subject, RunTimes& times)
      : PassingOn(subject), pipe_(dynamic_cast<const oracle::PipeSubject*>(&subject)), times_(times) {}

 private:
  friend PassingOn;

  template <class T>
  Answer<T> pass(Answer<T> (Subject::*query)(const Scene&), const Scene& scene) {
    const double before = thread_cpu_seconds();
    Answer<T> answer = (subject_.*query)(scene);
    if (std::holds_alternative<T>(answer)) {
      times_.count(pipe_ != nullptr ? pipe_->cpu_seconds_of_answer() : thread_cpu_seconds() - before);
    }
    return answer;
  }

  const oracle::PipeSubject* pipe_;  ///< null: in this process
  RunTimes& times_;
};

}  // namespace touchstone::app
