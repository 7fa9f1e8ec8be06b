#include "oracle/truth/motion_in_doubles.h"

#include <Eigen/Geometry>

#include "oracle/truth/impact.h"
#include "oracle/truth/truth.h"

namespace touchstone::oracle {
namespace {

Real middle(const Interval& i) { return (static_cast<Real>(i.lo) + static_cast<Real>(i.hi)) / 2; }

Vec3 middle(const std::array<Interval, 3>& v) {
  return {static_cast<double>(middle(v[0])), static_cast<double>(middle(v[1])), static_cast<double>(middle(v[2]))};
}

Quaternion turn(const std::array<std::array<Interval, 3>, 3>& rows) {
  Matrix R;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      R(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = middle(rows[i][j]);
  }
  const auto q = Eigen::Quaternion<Real>(R).normalized().cast<double>();
  return {q.w(), q.x(), q.y(), q.z()};
}

}  // namespace

State ballistic_state(const Scene& scene, std::size_t body, double time) {
  const std::vector<double>& starts = scene.motion->start_times;
  if (time == (starts.empty() ? 0 : starts[body])) return {scene.bodies[body].X_WB, scene.bodies[body].velocity};
  const reference::BallisticTruth truth = truth::ballistic_state(scene, body, time);
  return {{middle(truth.p_WB), turn(truth.R_WB)}, {middle(truth.v_WBcm), middle(truth.w_WB)}};
}

Scene pair_at(const Scene& scene, double time) {
  Scene there = scene;
  there.motion.reset();
  for (std::size_t i = 0; i < 2; ++i) {
    const State state = ballistic_state(scene, i, time);
    there.bodies[i].X_WB = state.X_WB;
    there.bodies[i].velocity = state.velocity;
  }
  return there;
}

}  // namespace touchstone::oracle
