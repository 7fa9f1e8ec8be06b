// The overlapping pairs in each frame of a sequence of poses, computed by a plan.
#include <algorithm>
#include <memory>
#include <optional>

#include "fast/bounds.h"
#include "fast/bounds/tight_box.h"
#include "fast/broad_phase/strategies.h"
#include "fast/plan.h"

namespace touchstone::fast {
namespace {

/// A body's tight box at any pose, computed as the plan says.
class Bounder {
 public:
  Bounder(const Body& body, BoundKind kind) : body_(body) {
    if (kind == BoundKind::climb) climbing_.emplace(body.shape);
  }

  Aabb at(const Pose& X_WB) {
    if (climbing_) return climbing_->at(X_WB);
    body_.X_WB = X_WB;
    return box(body_);
  }

 private:
  Body body_;
  std::optional<TightBox> climbing_;
};

PairSet sorted(const std::vector<BodyPair>& pairs) {
  PairSet set;
  for (const auto& [a, b] : pairs) set.emplace_back(static_cast<int>(a), static_cast<int>(b));
  std::ranges::sort(set);
  return set;
}

}  // namespace

PairHistory pair_history(const Scene& sequence, const Plan& plan) {
  const std::unique_ptr<BroadPhase> strategy = find_strategy(plan.strategy).make();
  std::vector<Bounder> bounders;
  for (std::size_t i = 0; i < sequence.bodies.size(); ++i) bounders.emplace_back(sequence.bodies[i], plan.bounds[i]);
  std::vector<bool> there(sequence.bodies.size(), false);
  PairHistory history;
  for (const SequenceFrame& frame : sequence.frames) {
    for (const auto& [body, X_WB] : frame) {
      const auto i = static_cast<std::size_t>(body);
      const auto id = static_cast<BodyId>(body);
      if (!X_WB) {
        strategy->remove(id);
      } else if (there[i]) {
        strategy->move(id, bounders[i].at(*X_WB));
      } else {
        strategy->insert(id, bounders[i].at(*X_WB));
      }
      there[i] = X_WB.has_value();
    }
    strategy->update();
    history.push_back({sorted(strategy->pairs()), sorted(strategy->begun()), sorted(strategy->ended())});
  }
  return history;
}

}  // namespace touchstone::fast
