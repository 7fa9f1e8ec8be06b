// The part that subjects share which pass all questions on to another one.
#pragma once

#include "oracle/subject.h"

namespace touchstone::oracle {

/// `Derived` has a member template Answer<T> pass(Answer<T> (Subject::*query)(const Scene&), const Scene&). `subject`
/// must outlive this object.
template <class Derived>
class PassingOn : public Subject {
 public:
  explicit PassingOn(Subject& subject) : subject_(subject) {}

  const Card& card() const override { return subject_.card(); }
  Answer<Masses> mass(const Scene& scene) override { return derived().pass(&Subject::mass, scene); }
  Answer<Bounds> bounds(const Scene& scene) override { return derived().pass(&Subject::bounds, scene); }
  Answer<PairSet> broad_phase(const Scene& scene) override { return derived().pass(&Subject::broad_phase, scene); }
  Answer<PairHistory> pair_history(const Scene& scene) override {
    return derived().pass(&Subject::pair_history, scene);
  }
  Answer<Distance> distance(const Scene& scene) override { return derived().pass(&Subject::distance, scene); }
  Answer<Penetration> penetration(const Scene& scene) override { return derived().pass(&Subject::penetration, scene); }
  Answer<Impulse> impulse(const Scene& scene) override { return derived().pass(&Subject::impulse, scene); }
  Answer<Pixels> pixel(const Scene& scene) override { return derived().pass(&Subject::pixel, scene); }
  Answer<TimeOfImpact> time_of_impact(const Scene& scene) override {
    return derived().pass(&Subject::time_of_impact, scene);
  }
  Answer<Trajectory> simulation(const Scene& scene) override { return derived().pass(&Subject::simulation, scene); }
  Answer<Trajectory> constraint(const Scene& scene) override { return derived().pass(&Subject::constraint, scene); }
  Answer<Work> work(const std::string& query, const Scene& scene) override { return subject_.work(query, scene); }

 protected:
  Subject& subject_;

 private:
  Derived& derived() { return static_cast<Derived&>(*this); }
};

}  // namespace touchstone::oracle
