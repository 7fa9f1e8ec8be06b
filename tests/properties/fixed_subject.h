// A subject that gives the same answer to every question.
#pragma once

#include "oracle/subject.h"

namespace touchstone::tests {

struct FixedSubject : oracle::Subject {
  // Not inline: otherwise gcc 12 reports uninitialised members in the destructors of the variants.
  FixedSubject();
  ~FixedSubject() override;

  oracle::Card introduced;
  Answer<Masses> said_mass = Abstains{"not set"};
  Answer<Bounds> said_bounds = Abstains{"not set"};
  Answer<PairSet> said_pairs = Abstains{"not set"};
  Answer<PairHistory> said_history = Abstains{"not set"};
  Answer<Distance> said_distance = Abstains{"not set"};
  Answer<Penetration> said_penetration = Abstains{"not set"};
  Answer<Pixels> said_pixels = Abstains{"not set"};
  Answer<Impulse> said_impulse = Abstains{"not set"};
  Answer<TimeOfImpact> said_time_of_impact = Abstains{"not set"};
  Answer<Trajectory> said_simulation = Abstains{"not set"};
  Answer<Trajectory> said_constraint = Abstains{"not set"};
  Answer<oracle::Work> said_work = Abstains{"not set"};

  const oracle::Card& card() const override { return introduced; }
  Answer<Masses> mass(const Scene&) override { return said_mass; }
  Answer<Bounds> bounds(const Scene&) override { return said_bounds; }
  Answer<PairSet> broad_phase(const Scene&) override { return said_pairs; }
  Answer<PairHistory> pair_history(const Scene&) override { return said_history; }
  Answer<Distance> distance(const Scene&) override { return said_distance; }
  Answer<Penetration> penetration(const Scene&) override { return said_penetration; }
  Answer<Pixels> pixel(const Scene&) override { return said_pixels; }
  Answer<Impulse> impulse(const Scene&) override { return said_impulse; }
  Answer<TimeOfImpact> time_of_impact(const Scene&) override { return said_time_of_impact; }
  Answer<Trajectory> simulation(const Scene&) override { return said_simulation; }
  Answer<Trajectory> constraint(const Scene&) override { return said_constraint; }
  Answer<oracle::Work> work(const std::string&, const Scene&) override { return said_work; }
};

}  // namespace touchstone::tests
