// Simpler contacts: simple coefficients, a normal along an axis, velocities with few components, shapes without effect.
#include <cmath>

#include "oracle/minimise/shrink.h"

namespace touchstone::oracle::shrink {
namespace {

template <class Change>
Move changed_impact(Change change) {
  return [change](const Scene& before) -> std::optional<Scene> {
    if (!before.contact) return std::nullopt;
    Scene scene = before;
    change(scene);
    return scene;
  };
}

/// An impact uses only a shape's mass properties, and nothing of it if these are given.
void sphere_for_shape(Body& body) { body.shape = Sphere{1}; }

void normal_along_axis(Scene& scene) {
  Vec3& n = scene.contact->nhat_BA_W;
  Eigen::Index axis = 0;
  n.cwiseAbs().maxCoeff(&axis);
  const double sign = n[axis] < 0 ? -1 : 1;
  n = sign * Vec3::Unit(axis);
}

/// C at the origin; the bodies keep their places relative to it.
void contact_at_origin(Scene& scene) {
  const Vec3 origin = scene.contact->p_WC;
  for (Body& body : scene.bodies) body.X_WB.p_WB -= origin;
  scene.contact->p_WC.setZero();
}

/// B at rest, A with the same velocity relative to it.
void seen_from_B(Scene& scene) {
  const Vec3 v = scene.bodies[1].velocity.v_WBcm;
  for (Body& body : scene.bodies) body.velocity.v_WBcm -= v;
}

}  // namespace

std::vector<Move> shrink_contacts(const Scene& scene) {
  if (!scene.contact) return {};
  std::vector<Move> moves = {changed_impact([](Scene& s) { s.contact.reset(); }), changed_impact(normal_along_axis),
                             changed_impact(contact_at_origin), changed_impact(seen_from_B),
                             changed_impact([](Scene& s) { s.contact->law = Law::poisson; })};
  for (const double plain : {0.0, 1.0}) {
    moves.push_back(changed_impact([plain](Scene& s) { s.contact->friction = plain; }));
    moves.push_back(changed_impact([plain](Scene& s) { s.contact->restitution = plain; }));
  }
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    moves.push_back(changed_impact([i](Scene& s) { s.bodies[i].mass = Fixed{}; }));
    moves.push_back(changed_impact([i](Scene& s) { sphere_for_shape(s.bodies[i]); }));
    moves.push_back(changed_impact([i](Scene& s) { s.bodies[i].velocity.w_WB.setZero(); }));
    moves.push_back(changed_impact([i](Scene& s) { s.bodies[i].velocity.v_WBcm.setZero(); }));
  }
  return moves;
}

}  // namespace touchstone::oracle::shrink
