// Errors of an answer against what is known of a scene's future.
#pragma once

#include <functional>
#include <map>

#include "app/motion/energy_report.h"
#include "app/motion/motion_scenes.h"

namespace touchstone::app {

using Error = std::function<double(const Trajectory&)>;

/// The position of a body's origin (m) at time t (s).
using Path = std::function<Real3(Real t)>;

/// |p_WB − path(t)| / scale, the worst over the named bodies.
Error off_paths(const Scene& scene, const std::map<int, Path>& paths, double scale);

/// |ω − spin(t)| / scale of one body, about the vertical (rad/s).
Error off_spin(const Scene& scene, int body, const std::function<Real(Real t)>& spin, double scale);

/// The greatest displacement of any point of a body from its initial position, relative to the body's size. Requires
/// bodies at rest.
Error off_rest(const Scene& scene);

/// |E − E₀| / E₀. This and the following functions require a completed scene.
Error off_energy(const Scene& scene);

/// max(E − E₀, 0) / E₀. Friction and restitution may only lose energy.
Error gained_energy(const Scene& scene);

/// The worse of |T − T₀| / T₀ and |L − L₀| / |L₀|.
Error off_free_turn(const Scene& scene);

}  // namespace touchstone::app
