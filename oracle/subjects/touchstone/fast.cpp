#include "oracle/subjects/touchstone/fast.h"

#include <stdexcept>

#include "fast/bounds.h"
#include "fast/broad_phase.h"
#include "fast/constraint.h"
#include "fast/distance.h"
#include "fast/impulse.h"
#include "fast/mass.h"
#include "fast/penetration.h"
#include "fast/pixel.h"
#include "fast/plan.h"
#include "fast/simulation.h"
#include "fast/time_of_impact.h"
#include "model/input_error.h"
#include "oracle/subject.h"
#include "oracle/subjects/touchstone/fast_work.h"
#include "oracle/subjects/touchstone/fast_work_limits.h"

namespace touchstone::oracle::subjects {
namespace {

class Fast : public Subject {
 public:
  const Card& card() const override { return card_; }
  Answer<Work> work(const std::string& query, const Scene& scene) override { return fast_work(*this, query, scene); }

  Answer<Masses> mass(const Scene& scene) override { return fast::mass(scene); }
  Answer<Bounds> bounds(const Scene& scene) override { return fast::bounds(scene); }
  Answer<PairSet> broad_phase(const Scene& scene) override { return fast::broad_phase(scene); }
  Answer<PairHistory> pair_history(const Scene& scene) override {
    try {
      return fast::pair_history(scene, fast::plan(scene));
    } catch (const InputError& beyond) {
      return Abstains{beyond.what()};
    }
  }
  Answer<Distance> distance(const Scene& scene) override {
    try {
      return fast::distance(scene);
    } catch (const std::range_error& beyond) {
      return Abstains{beyond.what()};
    }
  }
  Answer<Penetration> penetration(const Scene& scene) override {
    try {
      return fast::penetration_depth(scene).answer;
    } catch (const InputError& beyond) {
      return Abstains{beyond.what()};
    } catch (const std::range_error& beyond) {
      return Abstains{beyond.what()};
    }
  }
  Answer<Impulse> impulse(const Scene& scene) override { return fast::impulse_of(scene); }

  Answer<Trajectory> constraint(const Scene& scene) override {
    try {
      return fast::constrained(scene);
    } catch (const InputError& beyond) {
      return Abstains{beyond.what()};
    }
  }

  Answer<Pixels> pixel(const Scene& scene) override {
    try {
      return fast::pixels(scene);
    } catch (const std::range_error& beyond) {
      return Abstains{beyond.what()};
    }
  }

  Answer<Trajectory> simulation(const Scene& scene) override {
    // A question has 5 to 10 s: some half a second for each body (docs/design/simulation.md#limits).
    const fast::SimulationOptions limits{.most_work_per_body = 500'000'000};
    try {
      return fast::simulate(scene, limits).trajectory;
    } catch (const fast::BeyondDoubles& beyond) {
      return Abstains{beyond.what()};
    } catch (const std::range_error& beyond) {
      return Abstains{beyond.what()};
    }
  }

  Answer<TimeOfImpact> time_of_impact(const Scene& scene) override {
    try {
      return fast::time_of_impact_of(scene);
    } catch (const std::range_error& beyond) {
      return Abstains{beyond.what()};
    }
  }

 private:
  const Card card_{
      .name = "fast",
      .version = "0.1.0",
      .answers = {"mass", "bounds", "broad_phase", "pair_history", "distance", "penetration", "impulse", "pixel",
                  "time_of_impact", "constraint", "simulation"},
      .knows_touching = true,
      .about = "Touchstone's optimised algorithms, as planned for each scene; Lin-Canny from a corner, exact verdicts",
      .homepage = "",
      .deviations = {},
      .work_limits = fast_work_limits()};
};

}  // namespace

std::unique_ptr<Subject> make_fast() { return std::make_unique<Fast>(); }

}  // namespace touchstone::oracle::subjects
