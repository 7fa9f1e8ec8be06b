// How far an answer is from what is known of a scene's future.
#pragma once

#include <functional>
#include <map>

#include "app/motion_books.h"
#include "app/motion_scenes.h"

namespace touchstone::app {

using Error = std::function<double(const Trajectory&)>;

/// Where a body's origin is (m) at time t (s).
using Path = std::function<Real3(Real t)>;

/// |p_WB − path(t)| / scale, the worst of the bodies named.
Error off_paths(const Scene& scene, const std::map<int, Path>& paths, double scale);

/// |ω − spin(t)| / scale of a body, about the vertical (rad/s).
Error off_spin(const Scene& scene, int body, const std::function<Real(Real t)>& spin, double scale);

/// How far a point of any body has left where it stood at first, relative to the body's size. Requires bodies that
/// rest.
Error off_rest(const Scene& scene);

/// |E − E₀| / E₀. Requires a completed scene, as all that follow.
Error off_energy(const Scene& scene);

/// max(E − E₀, 0) / E₀: what friction and restitution may do is lose.
Error gained_energy(const Scene& scene);

/// The worse of |T − T₀| / T₀ and |L − L₀| / |L₀|.
Error off_free_turn(const Scene& scene);

}  // namespace touchstone::app
