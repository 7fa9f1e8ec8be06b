#include "app/motion/scenes/truths.h"

#include <algorithm>
#include <cmath>

#include "model/limits.h"

namespace touchstone::app {
namespace {

using Misses = std::function<Real(Real t, const std::vector<State>& states)>;

/// The worst over all samples. An answer without samples shows nothing: NaN.
Error worst_sample(const Scene& scene, Misses misses) {
  return [times = scene.motion->sample_times, misses = std::move(misses)](const Trajectory& answer) {
    Real worst = answer.states.empty() ? static_cast<Real>(NAN) : 0;
    for (std::size_t k = 0; k < answer.states.size(); ++k) {
      const Real missed = misses(times.at(k), answer.states[k]);
      if (!(missed <= worst)) worst = missed;  // NaN is the worst
    }
    return static_cast<double>(worst);
  };
}

/// The masses, which are exact, are worked out where an answer is judged: each start of the program makes all scenes.
Error booked(const Scene& scene, const std::function<Real(const Energies& first, const Energies& now)>& misses) {
  return [=](const Trajectory& answer) {
    const EnergyReport report(scene);
    const Energies first = report.at_start();
    return worst_sample(
        scene, [&](Real, const std::vector<State>& states) { return misses(first, report.at(states)); })(answer);
  };
}

/// An upper bound of the displacement of all points within `reach` of the body's origin.
Real moved(const Pose& from, const Pose& to, Real reach) {
  const Eigen::Matrix<Real, 3, 3> turn = rotation(to.q_WB) - rotation(from.q_WB);
  return (to.p_WB - from.p_WB).cast<Real>().norm() + reach * turn.norm() / std::sqrt(Real(2));
}

}  // namespace

Error off_paths(const Scene& scene, const std::map<int, Path>& paths, double scale) {
  return worst_sample(scene, [=](Real t, const std::vector<State>& states) {
    Real worst = 0;
    for (const auto& [body, path] : paths) {
      const Real3 p = states.at(static_cast<std::size_t>(body)).X_WB.p_WB.cast<Real>();
      const Real missed = (p - path(t)).norm() / scale;
      if (!(missed <= worst)) worst = missed;
    }
    return worst;
  });
}

Error off_spin(const Scene& scene, int body, const std::function<Real(Real t)>& spin, double scale) {
  return worst_sample(scene, [=](Real t, const std::vector<State>& states) {
    return std::abs(states.at(static_cast<std::size_t>(body)).velocity.w_WB.z() - spin(t)) / scale;
  });
}

Error off_rest(const Scene& scene) {
  return worst_sample(scene, [bodies = scene.bodies](Real, const std::vector<State>& states) {
    Real worst = 0;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const Real extent = size(bodies[b].shape);
      const Real missed = moved(bodies[b].X_WB, states.at(b).X_WB, extent) / extent;
      if (!(missed <= worst)) worst = missed;
    }
    return worst;
  });
}

Error off_energy(const Scene& scene) {
  return booked(scene, [](const Energies& first, const Energies& now) {
    return std::abs(now.energy() - first.energy()) / first.energy();
  });
}

Error gained_energy(const Scene& scene) {
  return booked(scene, [](const Energies& first, const Energies& now) {
    const Real gained = (now.energy() - first.energy()) / first.energy();
    return gained < 0 ? Real(0) : gained;
  });
}

Error off_free_turn(const Scene& scene) {
  return booked(scene, [](const Energies& first, const Energies& now) {
    const Real L = (now.angular_momentum - first.angular_momentum).norm() / first.angular_momentum.norm();
    return std::max(L, std::abs(now.kinetic - first.kinetic) / first.kinetic);
  });
}

}  // namespace touchstone::app
