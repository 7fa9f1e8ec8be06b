#include "fast/constraint/pair_events.h"

namespace touchstone::fast::constraint {

std::optional<Event::Kind> PairEvents::update(const PairStep& step, double weight) {
  if (!step.pushes()) {
    const bool held = phase_ == Phase::holds;
    phase_ = Phase::apart;
    return held ? std::optional(Event::Kind::release) : std::nullopt;
  }
  if (phase_ != Phase::holds && step.approach > explained_by_weight * weight) {
    phase_ = Phase::struck;
    return Event::Kind::impact;
  }
  if (phase_ == Phase::holds && step.slips == slips_) return std::nullopt;
  phase_ = Phase::holds;
  slips_ = step.slips;
  return Event::Kind::contact;
}

}  // namespace touchstone::fast::constraint
