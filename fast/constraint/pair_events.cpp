#include "fast/constraint/pair_events.h"

namespace touchstone::fast::constraint {

std::optional<Event::Kind> PairEvents::update(const PairStep& step, double weight) {
  if (!step.pushes()) {
    const bool held = holds_;
    holds_ = false;
    return held ? std::optional(Event::Kind::release) : std::nullopt;
  }
  if (!holds_ && step.approach > explained_by_weight * weight) return Event::Kind::impact;
  if (holds_ && step.slips == slips_) return std::nullopt;
  holds_ = true;
  slips_ = step.slips;
  return Event::Kind::contact;
}

}  // namespace touchstone::fast::constraint
