#include "oracle/subjects/common/broad_phase_world.h"

#include <utility>
#include <vector>

namespace touchstone::oracle::subjects {
namespace {

class BroadPhaseSubject : public Subject {
 public:
  BroadPhaseSubject(Card card, MakeWorld make_world) : card_(std::move(card)), make_world_(std::move(make_world)) {}

  const Card& card() const override { return card_; }
  Answer<PairSet> broad_phase(const Scene& scene) override { return broad_phase_in(make_world_, scene); }
  Answer<PairHistory> pair_history(const Scene& sequence) override { return pair_history_in(make_world_, sequence); }

 private:
  Card card_;
  MakeWorld make_world_;
};

}  // namespace

Answer<PairSet> broad_phase_in(const MakeWorld& make_world, const Scene& scene) try {
  const std::unique_ptr<World> world = make_world(scene);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) world->put(static_cast<int>(i), scene.bodies[i].X_WB);
  return world->end_frame().pairs;
} catch (const Declined& declined) {
  return Abstains{declined.what()};
}

Answer<PairHistory> pair_history_in(const MakeWorld& make_world, const Scene& sequence) try {
  const std::unique_ptr<World> world = make_world(sequence);
  std::vector<bool> there(sequence.bodies.size(), false);
  PairHistory history;
  for (const SequenceFrame& frame : sequence.frames) {
    for (const auto& [body, X_WB] : frame) {
      const auto i = static_cast<std::size_t>(body);
      if (!X_WB) {
        world->take(body);
      } else if (there[i]) {
        world->move(body, *X_WB);
      } else {
        world->put(body, *X_WB);
      }
      there[i] = X_WB.has_value();
    }
    history.push_back(world->end_frame());
  }
  return history;
} catch (const Declined& declined) {
  return Abstains{declined.what()};
}

std::unique_ptr<Subject> broad_phase_subject(Card card, MakeWorld make_world) {
  card.answers = {"broad_phase", "pair_history"};
  return std::make_unique<BroadPhaseSubject>(std::move(card), std::move(make_world));
}

}  // namespace touchstone::oracle::subjects
