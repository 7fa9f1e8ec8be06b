// Notices a question that is outside the domain which a subject's card declares.
#pragma once

#include <string>

#include "oracle/passing_on.h"

namespace touchstone::app {

/// Passes all questions on. A law asks about a scene and then about the scene after a change, and either may be
/// outside. `subject` must outlive this object.
class DomainWatch final : public oracle::PassingOn<DomainWatch> {
 public:
  using PassingOn::PassingOn;

  /// How the first question that was outside exceeds the domain; empty if there was none.
  const std::string& beyond() const { return beyond_; }

 private:
  friend PassingOn;

  template <class T>
  Answer<T> pass(Answer<T> (Subject::*query)(const Scene&), const Scene& scene) {
    if (beyond_.empty()) beyond_ = oracle::beyond(card().domain, scene).value_or("");
    return (subject_.*query)(scene);
  }

  std::string beyond_;
};

}  // namespace touchstone::app
