// What a pair's contact did, step after step, told as events.
#pragma once

#include <optional>

#include "model/answers.h"

namespace touchstone::fast::constraint {

/// Steps of free fall: an approach that so many explain is noise of a contact that holds, no impact.
inline constexpr double explained_by_weight = 4;

/// A pair in one step: its impulse, 0 if it does not push.
struct PairStep {
  Vec3 P_A_W = Vec3::Zero();
  Vec3 p_WC = Vec3::Zero();
  Vec3 nhat_BA_W = Vec3::Zero();
  double approach = 0;  ///< m/s: the greatest −u_n of its points before the step; of a pair that does not push, 0
  bool slips = false;   ///< at one of its points

  bool pushes() const { return !P_A_W.isZero(0); }
};

/// The first impulse of a pair is an `impact` if weight does not explain its approach; a push in
/// the next step begins a `contact`. A contact that begins or ends to slip is told as `contact` again; the first step
/// without a push as `release`.
class PairWatch {
 public:
  /// The event of this step, if there is one. `weight`: the velocity that gravity adds in a step (m/s).
  std::optional<Event::Kind> see(const PairStep& step, double weight);

 private:
  enum class Phase { apart, struck, holds };
  Phase phase_ = Phase::apart;
  bool slips_ = false;
};

}  // namespace touchstone::fast::constraint
