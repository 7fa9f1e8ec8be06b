// Notices a question that is outside what a subject vouches for on its card: its domain, and its dynamics.
#pragma once

#include <optional>
#include <string>
#include <type_traits>

#include "oracle/passing_on.h"

namespace touchstone::app {

/// Passes all questions on. A law asks about a scene and then about the scene after a change, and either may be
/// outside. `subject` must outlive this object.
class DomainWatch final : public oracle::PassingOn<DomainWatch> {
 public:
  using PassingOn::PassingOn;

  /// How the first question that was outside exceeds the domain, or what differs; empty if there was none.
  const std::string& beyond() const { return beyond_; }

  Answer<oracle::Work> work(const std::string& query, const Scene& scene) override {
    if (beyond_.empty()) beyond_ = oracle::beyond(card().domain, scene).value_or("");
    return subject_.work(query, scene);
  }

 private:
  friend PassingOn;

  template <class T>
  Answer<T> pass(Answer<T> (Subject::*query)(const Scene&), const Scene& scene) {
    if (beyond_.empty()) beyond_ = oracle::beyond(card().domain, scene).value_or("");
    if (beyond_.empty()) beyond_ = beyond_laws<T>(scene).value_or("");
    return (subject_.*query)(scene);
  }

  /// Why the answer depends on how the engine's dynamics differ, as its card declares.
  template <class T>
  std::optional<std::string> beyond_laws(const Scene& scene) const {
    if constexpr (std::is_same_v<T, Impulse>) {
      if (scene.contact) return oracle::beyond_impact(card().dynamics, scene);
    } else if constexpr (std::is_same_v<T, Trajectory>) {
      if (scene.motion) return oracle::beyond_motion(card().dynamics, scene);
    }
    return std::nullopt;
  }

  std::string beyond_;
};

}  // namespace touchstone::app
