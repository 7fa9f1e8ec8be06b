// A cube of fixed size that contains a body at every orientation: per frame only its centre is computed.
#pragma once

#include "model/scene.h"

namespace touchstone::fast {

/// Centre c + [−r, r]³ with c = X_WB c_B, where c_B is the middle of the body's box in its own frame and r ≥ max ‖p −
/// c_B‖.
///
/// Law: contains the tight box at every pose; each side is farther out than c_i ± max ‖p − c_B‖ by at most 64 u (max
/// ‖p‖₁ + ‖c_B‖₁ + |t|∞) + 2^-1050 (a compound's part: its offset's ‖·‖₁ added). Source: I-COLLIDE's fixed-size
/// bounding cubes (Cohen, Lin, Manocha & Ponamgi 1995).
class FixedCube {
 public:
  explicit FixedCube(const Shape& shape);

  Aabb at(const Pose& X_WB) const;

 private:
  Vec3 centre_;    ///< multiples of outward::unit
  double radius_;  ///< likewise
};

}  // namespace touchstone::fast
