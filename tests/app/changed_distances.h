// A subject that is right but for its distances.
#pragma once

#include <functional>
#include <type_traits>
#include <utility>
#include <variant>

#include "oracle/passing_on.h"

namespace touchstone::tests {

/// Passes all questions on to `truthful`, which must outlive it, and changes each distance that is answered.
class ChangedDistances final : public oracle::PassingOn<ChangedDistances> {
 public:
  using Change = std::function<void(const Scene&, Distance&)>;

  ChangedDistances(oracle::Subject& truthful, Change change) : PassingOn(truthful), change_(std::move(change)) {}

 private:
  friend PassingOn;

  template <class T>
  Answer<T> pass(Answer<T> (Subject::*query)(const Scene&), const Scene& scene) {
    Answer<T> answer = (subject_.*query)(scene);
    if constexpr (std::is_same_v<T, Distance>) {
      if (Distance* said = std::get_if<Distance>(&answer)) change_(scene, *said);
    }
    return answer;
  }

  Change change_;
};

}  // namespace touchstone::tests
