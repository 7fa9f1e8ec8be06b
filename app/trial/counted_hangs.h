// Counts how often a subject hangs.
#pragma once

#include "oracle/passing_on.h"

namespace touchstone::app {

/// Passes all questions on and counts those that hang: each of them costs the whole time limit. `subject` and `hangs`
/// must outlive this object.
class CountedHangs final : public oracle::PassingOn<CountedHangs> {
 public:
  CountedHangs(oracle::Subject& subject, int& hangs) : PassingOn(subject), hangs_(hangs) {}

  Answer<oracle::Work> work(const std::string& query, const Scene& scene) override {
    Answer<oracle::Work> counts = subject_.work(query, scene);
    if (hung(counts)) ++hangs_;
    return counts;
  }

 private:
  friend PassingOn;

  template <class T>
  Answer<T> pass(Answer<T> (Subject::*query)(const Scene&), const Scene& scene) {
    Answer<T> answer = (subject_.*query)(scene);
    if (hung(answer)) ++hangs_;
    return answer;
  }

  int& hangs_;
};

}  // namespace touchstone::app
