// Remembers which scene a subject was asked about last.
#pragma once

#include <optional>

#include "oracle/subject.h"

namespace touchstone::app {

/// Passes all questions on. A law asks about a scene and then about the scene after a change, so what it finds wrong is
/// the answer to the last question, or that there was none. `subject` must outlive this object.
class LastAsked final : public oracle::Subject {
 public:
  explicit LastAsked(oracle::Subject& subject) : subject_(subject) {}

  /// None before the first question.
  const std::optional<Scene>& scene() const { return scene_; }

  const oracle::Card& card() const override { return subject_.card(); }
  Answer<Masses> mass(const Scene& scene) override { return pass(&Subject::mass, scene); }
  Answer<Bounds> bounds(const Scene& scene) override { return pass(&Subject::bounds, scene); }
  Answer<PairSet> broad_phase(const Scene& scene) override { return pass(&Subject::broad_phase, scene); }
  Answer<PairHistory> pair_history(const Scene& scene) override { return pass(&Subject::pair_history, scene); }
  Answer<Distance> distance(const Scene& scene) override { return pass(&Subject::distance, scene); }
  Answer<Penetration> penetration(const Scene& scene) override { return pass(&Subject::penetration, scene); }
  Answer<Impulse> impulse(const Scene& scene) override { return pass(&Subject::impulse, scene); }
  Answer<Pixels> pixel(const Scene& scene) override { return pass(&Subject::pixel, scene); }
  Answer<TimeOfImpact> time_of_impact(const Scene& scene) override { return pass(&Subject::time_of_impact, scene); }
  Answer<Trajectory> simulation(const Scene& scene) override { return pass(&Subject::simulation, scene); }
  Answer<Trajectory> constraint(const Scene& scene) override { return pass(&Subject::constraint, scene); }

 private:
  template <class T>
  Answer<T> pass(Answer<T> (Subject::*query)(const Scene&), const Scene& scene) {
    scene_ = scene;
    return (subject_.*query)(scene);
  }

  oracle::Subject& subject_;
  std::optional<Scene> scene_;
};

}  // namespace touchstone::app
