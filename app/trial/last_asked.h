// Remembers which scene a subject was asked about last.
#pragma once

#include <optional>

#include "oracle/passing_on.h"

namespace touchstone::app {

/// Passes all questions on. A law asks about a scene and then about the scene after a change, so what it finds wrong is
/// the answer to the last question, or that there was none. `subject` must outlive this object.
class LastAsked final : public oracle::PassingOn<LastAsked> {
 public:
  using PassingOn::PassingOn;

  /// None before the first question.
  const std::optional<Scene>& scene() const { return scene_; }

  Answer<oracle::Work> work(const std::string& query, const Scene& scene) override {
    scene_ = scene;
    return subject_.work(query, scene);
  }

 private:
  friend PassingOn;

  template <class T>
  Answer<T> pass(Answer<T> (Subject::*query)(const Scene&), const Scene& scene) {
    scene_ = scene;
    return (subject_.*query)(scene);
  }

  std::optional<Scene> scene_;
};

}  // namespace touchstone::app
