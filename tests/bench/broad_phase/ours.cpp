#include "fast/broad_phase/strategies.h"
#include "tests/bench/broad_phase/contestant.h"

namespace touchstone::bench {
namespace {

class Ours final : public Contestant {
 public:
  Ours(const fast::Strategy& strategy, const std::vector<Aabb>& boxes) : broad_phase_(strategy.make()) {
    for (std::size_t i = 0; i < boxes.size(); ++i) broad_phase_->insert(static_cast<fast::BodyId>(i), boxes[i]);
    broad_phase_->update();
  }

  std::size_t pairs_after(const Frame& frame) override {
    for (const Change& change : frame) broad_phase_->move(static_cast<fast::BodyId>(change.body), change.box);
    broad_phase_->update();
    return broad_phase_->pairs().size();
  }

 private:
  std::unique_ptr<fast::BroadPhase> broad_phase_;
};

}  // namespace

std::vector<Entrant> our_strategies() {
  std::vector<Entrant> entrants;
  for (const fast::Strategy& strategy : fast::strategies()) {
    const bool quadratic = strategy.name == "all_pairs" || strategy.name == "sweep_and_prune";
    entrants.push_back({strategy.name, false, quadratic, [&strategy](const auto& boxes, const Aabb&) {
                          return std::make_unique<Ours>(strategy, boxes);
                        }});
  }
  return entrants;
}

}  // namespace touchstone::bench
