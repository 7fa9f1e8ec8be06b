#include "oracle/subjects/touchstone/fast_strategies.h"

#include <algorithm>

#include "fast/bounds.h"
#include "fast/broad_phase/strategies.h"
#include "model/input_error.h"
#include "oracle/subjects/common/broad_phase_world.h"

namespace touchstone::oracle::subjects {
namespace {

PairSet sorted(const std::vector<fast::BodyPair>& pairs) {
  PairSet set;
  for (const auto& [a, b] : pairs) set.emplace_back(static_cast<int>(a), static_cast<int>(b));
  std::ranges::sort(set);
  return set;
}

class FastWorld : public World {
 public:
  FastWorld(std::unique_ptr<fast::BroadPhase> strategy, const Scene& scene)
      : strategy_(std::move(strategy)), scene_(scene) {}

  void put(int body, const Pose& X_WB) override { place(&fast::BroadPhase::insert, body, X_WB); }
  void move(int body, const Pose& X_WB) override { place(&fast::BroadPhase::move, body, X_WB); }
  void take(int body) override { strategy_->remove(static_cast<fast::BodyId>(body)); }

  PairFrame end_frame() override {
    strategy_->update();
    return {sorted(strategy_->pairs()), sorted(strategy_->begun()), sorted(strategy_->ended())};
  }

 private:
  void place(void (fast::BroadPhase::*how)(fast::BodyId, const Aabb&), int body, const Pose& X_WB) {
    Body placed = scene_.bodies[static_cast<std::size_t>(body)];
    placed.X_WB = X_WB;
    try {
      (strategy_.get()->*how)(static_cast<fast::BodyId>(body), fast::box(placed));
    } catch (const InputError& beyond) {
      throw Declined(beyond.what());
    }
  }

  std::unique_ptr<fast::BroadPhase> strategy_;
  const Scene& scene_;
};

MakeWorld world_of_fast_strategy(const std::string& name) {
  const auto make = fast::find_strategy(name).make;
  return [make](const Scene& scene) { return std::make_unique<FastWorld>(make(), scene); };
}

}  // namespace

std::unique_ptr<Subject> make_fast_strategy(const std::string& name) {
  Card card;
  card.name = "fast." + name;
  card.version = "0.1.0";
  card.about = "Touchstone's broad phase: " + fast::find_strategy(name).says;
  return broad_phase_subject(std::move(card), world_of_fast_strategy(name));
}

}  // namespace touchstone::oracle::subjects
