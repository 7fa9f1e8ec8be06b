#include "oracle/subjects/touchstone_fast.h"

#include <stdexcept>

#include "fast/bounds.h"
#include "fast/broad_phase.h"
#include "fast/distance.h"
#include "oracle/subjects/fast_strategies.h"

namespace touchstone::oracle::subjects {
namespace {

class Fast : public Subject {
 public:
  const Card& card() const override { return card_; }
  Answer<Bounds> bounds(const Scene& scene) override { return fast::bounds(scene); }
  Answer<PairSet> broad_phase(const Scene& scene) override { return fast::broad_phase(scene); }
  Answer<PairHistory> pair_history(const Scene& scene) override { return pair_history_in(default_world_, scene); }
  Answer<Distance> distance(const Scene& scene) override {
    try {
      return fast::distance(scene);
    } catch (const std::range_error& beyond) {
      return Abstains{beyond.what()};
    }
  }

 private:
  const MakeWorld default_world_ = world_of_fast_strategy("wrapped_grid");
  const Card card_{
      .name = "fast",
      .version = "0.1.0",
      .answers = {"bounds", "broad_phase", "pair_history", "distance"},
      .knows_touching = true,
      .about = "Touchstone's optimised algorithms, default strategy; Lin-Canny from a corner, exact verdicts",
      .homepage = "",
      .deviations = {}};
};

}  // namespace

std::unique_ptr<Subject> make_fast() { return std::make_unique<Fast>(); }

}  // namespace touchstone::oracle::subjects
