// Turns the contact history of a pair, step after step, into events.
#pragma once

#include <optional>

#include "model/answers.h"

namespace touchstone::fast::constraint {

/// In steps of free fall: an approach no faster than this is noise of a lasting contact, not an impact.
inline constexpr double explained_by_weight = 4;

/// One step of a pair. The impulse is 0 if the pair does not press.
struct PairStep {
  Vec3 P_A_W = Vec3::Zero();
  Vec3 p_WC = Vec3::Zero();
  Vec3 nhat_BA_W = Vec3::Zero();
  double approach = 0;  ///< m/s: the greatest −u_n of its points before the step; 0 if the pair does not press
  bool slips = false;   ///< at one of its points at least

  bool pushes() const { return !P_A_W.isZero(0); }
};

/// The first impulse of a pair emits `impact` if weight does not explain its approach; an impulse in the next step
/// emits `contact`. When slip begins or ends, `contact` is emitted again. The first step without an impulse emits
/// `release`.
class PairEvents {
 public:
  /// Returns the event of this step, if any. `weight`: the velocity that gravity and forces add in a step (m/s).
  std::optional<Event::Kind> update(const PairStep& step, double weight);

 private:
  bool holds_ = false;  ///< a contact that lasts: one was emitted, and no release since
  bool slips_ = false;
};

}  // namespace touchstone::fast::constraint
