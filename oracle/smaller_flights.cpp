// Shorter flights: fewer times, no pushes, one start, plainer coefficients and velocities.
#include <algorithm>

#include "oracle/smaller.h"

namespace touchstone::oracle::smaller {
namespace {

template <class Change>
Move changed(Change change) {
  return [change](const Scene& before) -> std::optional<Scene> {
    if (!before.flight) return std::nullopt;
    Scene scene = before;
    change(scene);
    return scene;
  };
}

/// Only times that are there: of shorter flights, later moves ask for less.
std::optional<Scene> without_time(Scene scene, std::size_t i) {
  if (!scene.flight || scene.flight->times.size() < 2 || i >= scene.flight->times.size()) return std::nullopt;
  std::vector<double>& times = scene.flight->times;
  times.erase(times.begin() + static_cast<std::ptrdiff_t>(i));
  return scene;
}

std::optional<Scene> without_push(Scene scene, std::size_t i) {
  if (!scene.flight || i >= scene.flight->pushes.size()) return std::nullopt;
  std::vector<Push>& pushes = scene.flight->pushes;
  pushes.erase(pushes.begin() + static_cast<std::ptrdiff_t>(i));
  return scene;
}

/// All velocities against body i's, so that it does not move.
void seen_from(Scene& scene, std::size_t i) {
  if (i >= scene.bodies.size()) return;
  const Vec3 v = scene.bodies[i].velocity.v_WBcm;
  for (Body& body : scene.bodies) body.velocity.v_WBcm -= v;
}

template <class Change>
Move of_body(std::size_t i, Change change) {
  return changed([i, change](Scene& scene) {
    if (i < scene.bodies.size()) change(scene.bodies[i]);
  });
}

}  // namespace

std::vector<Move> plainer_flights(const Scene& scene) {
  if (!scene.flight) return {};
  std::vector<Move> moves = {changed([](Scene& s) { s.flight.reset(); }),
                             changed([](Scene& s) { s.flight->times = {s.flight->times.back()}; }),
                             changed([](Scene& s) { s.flight->times = {s.flight->times.front()}; }),
                             changed([](Scene& s) { s.flight->pushes.clear(); }),
                             changed([](Scene& s) { s.flight->since.clear(); }),
                             changed([](Scene& s) { s.flight->envelope.reset(); }),
                             changed([](Scene& s) { s.flight->force_bound = 0; }),
                             changed([](Scene& s) { s.flight->law = Law::poisson; })};
  for (std::size_t i = scene.flight->times.size(); i-- > 0;) {
    moves.push_back([i](const Scene& s) { return without_time(s, i); });
  }
  for (std::size_t i = scene.flight->pushes.size(); i-- > 0;) {
    moves.push_back([i](const Scene& s) { return without_push(s, i); });
  }
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    moves.push_back(changed([i](Scene& s) { seen_from(s, i); }));
    moves.push_back(of_body(i, [](Body& body) { body.mass = Fixed{}; }));
    moves.push_back(of_body(i, [](Body& body) { body.mass = Density{}; }));
    moves.push_back(of_body(i, [](Body& body) { body.velocity.w_WB.setZero(); }));
    moves.push_back(of_body(i, [](Body& body) { body.velocity.v_WBcm.setZero(); }));
    for (const double plain : {0.0, 1.0}) {
      moves.push_back(of_body(i, [plain](Body& body) { body.material.friction = plain; }));
      moves.push_back(of_body(i, [plain](Body& body) { body.material.restitution = plain; }));
    }
  }
  return moves;
}

}  // namespace touchstone::oracle::smaller
