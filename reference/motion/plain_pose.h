// Poses as plain GMP rationals, computed in the most direct way. Independent of reference/exact/exact_pose.cpp on
// purpose: tests compare the two.
#pragma once

#include <gmpxx.h>

#include <array>

#include "model/frame.h"

namespace touchstone::reference {

using Triple = std::array<mpq_class, 3>;

inline Triple triple(const Vec3& v) { return {mpq_class(v.x()), mpq_class(v.y()), mpq_class(v.z())}; }

inline mpq_class dot(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// p ↦ R p + t, with the rows of R.
struct Motion {
  std::array<Triple, 3> rows;
  Triple translation;

  Triple operator()(const Triple& p) const {
    Triple moved;
    for (std::size_t i = 0; i < 3; ++i) moved[i] = dot(rows[i], p) + translation[i];
    return moved;
  }
};

inline Motion motion(const Pose& pose) {
  const mpq_class w(pose.q_WB.w);
  const mpq_class x(pose.q_WB.x);
  const mpq_class y(pose.q_WB.y);
  const mpq_class z(pose.q_WB.z);
  const mpq_class n = w * w + x * x + y * y + z * z;
  const auto over_n = [&](const mpq_class& a) { return mpq_class(a / n); };
  return {{{{over_n(w * w + x * x - y * y - z * z), over_n(2 * (x * y - w * z)), over_n(2 * (x * z + w * y))},
            {over_n(2 * (x * y + w * z)), over_n(w * w - x * x + y * y - z * z), over_n(2 * (y * z - w * x))},
            {over_n(2 * (x * z - w * y)), over_n(2 * (y * z + w * x)), over_n(w * w - x * x - y * y + z * z)}}},
          triple(pose.p_WB)};
}

/// X_WP = X_WB X_BP.
inline Motion composed(const Motion& X_WB, const Motion& X_BP) {
  Motion X_WP;
  X_WP.translation = X_WB(X_BP.translation);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      X_WP.rows[i][j] = dot(X_WB.rows[i], {X_BP.rows[0][j], X_BP.rows[1][j], X_BP.rows[2][j]});
    }
  }
  return X_WP;
}

}  // namespace touchstone::reference
