#include <map>

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

/// Sweep and prune: "expected O(n)" is I-COLLIDE's claim for coherent motion.
const std::map<std::string, std::string> laws{
    {"all_pairs", "n^2"},  {"sweep_and_prune", "n"}, {"sweep_2d", "n log n"},    {"bsp", "n log n"},
    {"octree", "n log n"}, {"uniform_grid", "n"},    {"hierarchical_hash", "n"}, {"wrapped_grid", "n"}};

}  // namespace

std::vector<Entrant> our_strategies() {
  std::vector<Entrant> entrants;
  for (const fast::Strategy& strategy : fast::strategies()) {
    entrants.push_back({strategy.name, false, laws.at(strategy.name), [&strategy](const auto& boxes, const Aabb&) {
                          return std::make_unique<Ours>(strategy, boxes);
                        }});
  }
  return entrants;
}

}  // namespace touchstone::bench
