#include "fast/motion/steady_turn.h"

#include <cmath>

#include "fast/lin_canny/rotation.h"
#include "fast/motion/sine.h"

namespace touchstone::fast::motion {

double length(const Vec3& w) {
  const double greatest = w.lpNorm<Eigen::Infinity>();
  if (greatest > 0x1p-400 && greatest < 0x1p400) return std::sqrt((w.x() * w.x() + w.y() * w.y()) + w.z() * w.z());
  if (!(greatest > 0)) return 0;
  const Vec3 s = w / greatest;
  return greatest * std::sqrt((s.x() * s.x() + s.y() * s.y()) + s.z() * s.z());
}

SteadyTurn steady_turn(const Vec3& w, double tau) {
  const double rate = length(w);
  const double angle = rate * tau;
  if (!(angle > 0)) return {};
  if (!(angle < 0x1p50)) return {{}, 2};
  const SineCosine half = sine_cosine(angle / 2);
  const Vec3 v = w / rate * half.sine;
  return {{half.cosine, v.x(), v.y(), v.z()}, (24 + 10 * angle) * u};
}

}  // namespace touchstone::fast::motion
