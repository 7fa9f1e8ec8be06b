// Canaries that lie about impacts, one for each error that engines and their authors make.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>

#include "model/infinity.h"
#include "oracle/subjects/canaries/lie.h"
#include "oracle/truth/impact.h"

namespace touchstone::oracle::subjects {
namespace {

Lies impacts(Lie<Impulse> lie) {
  Lies lies;
  lies.impulse = std::move(lie);
  return lies;
}

// Answers the truth about a changed contact.
Lies as_if(const std::function<void(Contact&, const Scene&)>& change) {
  return impacts([change](Subject& truthful, const Scene& scene, Impulse& said) {
    Scene other = scene;
    change(*other.contact, scene);
    with(truthful.impulse(other), [&](const Impulse& answer) { said = answer; });
  });
}

void set_change(Impulse& said, const Scene& scene, std::size_t i, const Point& dv, const Point& dw) {
  const Velocity& before = scene.bodies[i].velocity;
  said.after[i] = {before.v_WBcm + dv.cast<double>(), before.w_WB + dw.cast<double>()};
}

// Sets the velocities that result from an impulse on A and one on B.
void strike(Impulse& said, const Scene& scene, const Impact& impact, const Point& on_A, const Point& on_B) {
  for (std::size_t i = 0; i < 2; ++i) {
    const ImpactBody& body = impact.bodies[i];
    const Point& P = i == 0 ? on_A : on_B;
    if (body.fixed) continue;
    set_change(said, scene, i, P / body.mass, body.spin(body.p_BcmC_W.cross(P)));
  }
  said.P_A_W = on_A.cast<double>();
}

// Of what a careful computation of an ordinary impact may be wrong by, 3 to 6 times.
constexpr double few_thousand = 4000 * rounding;

Point impulse_of(const Impulse& said) { return said.P_A_W.value_or(Vec3::Zero()).cast<Real>(); }

Point normal_part(const Point& P, const Impact& impact) { return impact.nhat_BA_W.dot(P) * impact.nhat_BA_W; }

// Replaces the true impulse P by other(P); changes nothing if both are equal.
Lies with_impulse(const std::function<Point(const Point&, const Impact&, const Contact&)>& other) {
  return impacts([other](Subject&, const Scene& scene, Impulse& said) {
    const Impact it = impact(scene);
    const Point true_P = impulse_of(said), P = other(true_P, it, *scene.contact);
    if (P != true_P) strike(said, scene, it, P, -P);
  });
}

// Replaces the change of velocity of each body.
Lies with_changes(const std::function<void(std::size_t body, const Scene&, Velocity& change)>& other) {
  return impacts([other](Subject&, const Scene& scene, Impulse& said) {
    for (std::size_t i = 0; i < 2; ++i) {
      const Velocity& before = scene.bodies[i].velocity;
      Velocity change{said.after[i].v_WBcm - before.v_WBcm, said.after[i].w_WB - before.w_WB};
      other(i, scene, change);
      said.after[i] = {before.v_WBcm + change.v_WBcm, before.w_WB + change.w_WB};
    }
  });
}

Point frozen_slip(const Point& P, const Impact& impact, const Contact& contact) {
  const Point u_t = impact.u_t();
  if (P.isZero(0) || u_t.isZero(0) || !std::isfinite(contact.friction)) return P;
  const Point sigma = u_t.normalized();
  const Real slope = impact.K_nn() - contact.friction * impact.k().dot(sigma);
  if (!(slope > 0)) return P;
  const Real P_n = -(1 + contact.restitution) * impact.u_n() / slope;
  return P_n * (impact.nhat_BA_W - contact.friction * sigma);
}

// Slides where friction could hold, and sticks where it cannot.
void stick_test_reversed(Contact& contact, const Scene& scene) {
  const Impact it = impact(scene);
  const Point held = it.impulse_for(it.u_n() * it.nhat_BA_W + it.u_t() / (1 + contact.restitution));
  const Real along = std::abs(it.nhat_BA_W.dot(held)), across = (held - normal_part(held, it)).norm();
  contact.friction = across <= contact.friction * along ? 0 : infinity;
}

// Coulomb's cone replaced by a pyramid in world axes: friction is larger along the diagonals.
void friction_pyramid(Contact& contact, const Scene& scene) {
  const Point u_t = impact(scene).u_t();
  if (!u_t.isZero(0)) contact.friction *= static_cast<double>(u_t.cwiseAbs().sum() / u_t.norm());
}

void lost_below_threshold(Subject&, const Scene& scene, Impulse& said) {
  if (impact(scene).u_n() < -0.5L) return;
  for (std::size_t i = 0; i < 2; ++i) said.after[i] = scene.bodies[i].velocity;
  said.P_A_W = Vec3::Zero();
}

void friction_of_one(Subject&, const Scene& scene, Impulse& said) {
  const Impact it = impact(scene);
  const Point P = impulse_of(said);
  strike(said, scene, it, P, -normal_part(P, it));
}

void fixed_body_kicked(Subject&, const Scene& scene, Impulse& said) {
  for (std::size_t i = 0; i < 2; ++i) {
    if (std::holds_alternative<Fixed>(scene.bodies[i].mass)) said.after[i].v_WBcm.x() += 1e-9;
  }
}

// Pulls separating bodies back together.
Point sticky(const Point& P, const Impact& impact, const Contact&) {
  return impact.u_n() > 0 ? Point(-impact.u_n() / impact.K_nn() * impact.nhat_BA_W) : P;
}

Point inverse_mass_alone(const Point& P, const Impact& impact, const Contact& contact) {
  if (P.isZero(0)) return P;
  return -(1 + contact.restitution) * impact.u_n() * impact.least_mass() * impact.nhat_BA_W;
}

// Pulls separating bodies by a few thousand roundings of the impulse that would hold them together.
Point slightly_sticky(const Point& P, const Impact& impact, const Contact&) {
  if (!(impact.u_n() > 0)) return P;
  return -3 * few_thousand * impact.u_n() / impact.K_nn() * impact.nhat_BA_W;
}

Point slightly_rough(const Point& P, const Impact& impact, const Contact&) {
  return P + few_thousand * (P - normal_part(P, impact));
}

void slightly_one_sided(std::size_t body, const Scene&, Velocity& change) {
  if (body == 0) change.v_WBcm *= 1 + 100 * rounding;
}

Point friction_by_compression(const Point& P, const Impact& impact, const Contact& contact) {
  const Point normal = normal_part(P, impact);
  return normal + (P - normal) / (1 + contact.restitution);
}

Point right_handed_friction(const Point& P, const Impact& impact, const Contact&) {
  const Point across = P - normal_part(P, impact);
  return P + 1e-6L * impact.nhat_BA_W.cross(across);
}

void arm_from_the_origin(Subject&, const Scene& scene, Impulse& said) {
  const Impact it = impact(scene);
  const Point P = impulse_of(said), arm = scene.contact->p_WC.cast<Real>();
  for (std::size_t i = 0; i < 2; ++i) {
    if (it.bodies[i].fixed) continue;
    const Point moment = (i == 0 ? 1 : -1) * arm.cross(P);
    said.after[i].w_WB = scene.bodies[i].velocity.w_WB + it.bodies[i].spin(moment).cast<double>();
  }
}

void boasts_of_its_impulse(Subject&, const Scene&, Impulse& said) {
  if (said.P_A_W) *said.P_A_W *= 1 + 1e-9;
  said.error = 0;
}

void bodies_exchanged(Subject&, const Scene& scene, Impulse& said) {
  const bool both_move =
      !std::holds_alternative<Fixed>(scene.bodies[0].mass) && !std::holds_alternative<Fixed>(scene.bodies[1].mass);
  if (both_move) std::swap(said.after[0], said.after[1]);
}

}  // namespace

std::vector<Canary> canaries_about_impacts() {
  return {
      lying("canary.same_sign_on_both", "gives B the impulse of A, not its opposite",
            [] {
              return with_changes([](std::size_t i, const Scene&, Velocity& change) {
                if (i == 1) change = {-change.v_WBcm, -change.w_WB};
              });
            }),
      lying("canary.bodies_exchanged", "gives A the velocities of B", [] { return impacts(bodies_exchanged); }),
      lying("canary.frozen_slip", "keeps friction against the first slip, though slip turns and stops",
            [] { return with_impulse(frozen_slip); }),
      lying("canary.restitution_forgotten", "ends with the compression",
            [] { return as_if([](Contact& contact, const Scene&) { contact.restitution = 0; }); }),
      lying("canary.stick_test_reversed", "slides where friction holds, and holds where it slides",
            [] { return as_if(stick_test_reversed); }),
      lying("canary.e_squared", "takes e² for e",
            [] { return as_if([](Contact& contact, const Scene&) { contact.restitution *= contact.restitution; }); }),
      lying("canary.always_bounces", "takes a tenth for every e below",
            [] {
              return as_if(
                  [](Contact& contact, const Scene&) { contact.restitution = std::max(contact.restitution, 0.1); });
            }),
      lying("canary.friction_pyramid", "has a pyramid for the cone", [] { return as_if(friction_pyramid); }),
      lying("canary.friction_doubled", "doubles friction",
            [] { return as_if([](Contact& contact, const Scene&) { contact.friction *= 2; }); }),
      lying("canary.friction_by_compression", "bounds friction by the compression's impulse alone",
            [] { return with_impulse(friction_by_compression); }),
      lying("canary.friction_of_one", "lets friction act on A alone", [] { return impacts(friction_of_one); }),
      lying("canary.right_handed_friction", "turns friction a little to the left",
            [] { return with_impulse(right_handed_friction); }),
      lying("canary.impulse_flipped", "turns the impulse round",
            [] { return with_impulse([](const Point& P, const Impact&, const Contact&) { return Point(-P); }); }),
      lying("canary.energy_gain", "makes the impulse a tenth larger",
            [] { return with_impulse([](const Point& P, const Impact&, const Contact&) { return Point(1.1L * P); }); }),
      lying("canary.inverse_mass_alone", "forgets that bodies turn when they are hit",
            [] { return with_impulse(inverse_mass_alone); }),
      lying("canary.sticky", "pulls parting bodies back together", [] { return with_impulse(sticky); }),
      lying("canary.torque_forgotten", "leaves the spins as they are",
            [] { return with_changes([](std::size_t, const Scene&, Velocity& change) { change.w_WB.setZero(); }); }),
      lying(
          "canary.arm_from_the_other_side", "takes the arm from C to the centre",
          [] { return with_changes([](std::size_t, const Scene&, Velocity& change) { change.w_WB = -change.w_WB; }); }),
      lying("canary.arm_from_the_origin", "takes the arm from the world's origin",
            [] { return impacts(arm_from_the_origin); }),
      lying("canary.lost_below_threshold", "ignores impacts slower than 0.5 m/s",
            [] { return impacts(lost_below_threshold); }),
      lying("canary.newton_for_poisson", "restores by Newton's law instead of Poisson's",
            [] {
              return as_if([](Contact& contact, const Scene&) {
                if (contact.law == Law::poisson) contact.law = Law::newton;
              });
            }),
      lying("canary.poisson_for_newton", "restores by Poisson's law instead of Newton's",
            [] {
              return as_if([](Contact& contact, const Scene&) {
                if (contact.law == Law::newton) contact.law = Law::poisson;
              });
            }),
      lying("canary.stronge_without_square", "restores e of the work of compression, not e²",
            [] {
              return as_if([](Contact& contact, const Scene&) {
                if (contact.law == Law::stronge) contact.restitution = std::sqrt(contact.restitution);
              });
            }),
      lying("canary.fixed_body_kicked", "moves fixed bodies by 1e-9 m/s", [] { return impacts(fixed_body_kicked); }),
      lying("canary.impulse_on_the_other", "states the impulse on B as that on A",
            [] {
              return impacts([](Subject&, const Scene&, Impulse& said) {
                if (said.P_A_W) *said.P_A_W *= -1;
              });
            }),
      lying("canary.boasts_of_its_impulse", "states an impulse that is off by 1e-9, and no error",
            [] { return impacts(boasts_of_its_impulse); }),
      lying("canary.slightly_strong", "makes the impulse greater by a few thousand roundings",
            [] {
              return with_impulse(
                  [](const Point& P, const Impact&, const Contact&) { return Point((1 + few_thousand) * P); });
            }),
      lying("canary.slightly_weak", "makes the impulse smaller by a few thousand roundings",
            [] {
              return with_impulse(
                  [](const Point& P, const Impact&, const Contact&) { return Point((1 - few_thousand) * P); });
            }),
      lying("canary.slightly_rough", "makes friction greater by a few thousand roundings",
            [] { return with_impulse(slightly_rough); }),
      lying("canary.slightly_sticky", "pulls parting bodies back by a few thousand roundings",
            [] { return with_impulse(slightly_sticky); }),
      lying("canary.slightly_one_sided", "makes the change of A's velocity greater by 100 roundings",
            [] { return with_changes(slightly_one_sided); }),
      lying("canary.slightly_misstated", "states an impulse that is greater by a few thousand roundings",
            [] {
              return impacts([](Subject&, const Scene&, Impulse& said) {
                if (said.P_A_W) *said.P_A_W *= 1 + few_thousand;
              });
            }),
      lying("canary.slightly_boastful", "states an impulse that is greater by 20 roundings, and its error as it was",
            [] {
              return impacts([](Subject&, const Scene&, Impulse& said) {
                if (said.P_A_W) *said.P_A_W *= 1 + 20 * rounding;
              });
            }),
      lying("canary.slight_drag", "slows every body by a few thousand roundings",
            [] {
              return impacts([](Subject&, const Scene&, Impulse& said) {
                for (Velocity& V : said.after) {
                  V.v_WBcm *= 1 - 3 * few_thousand;
                  V.w_WB *= 1 - 3 * few_thousand;
                }
              });
            }),
      lying("canary.shrugs", "calls every impact ambiguous",
            [] { return impacts([](Subject&, const Scene&, Impulse& said) { said.ambiguous = 0; }); }),
      lying("canary.bodies_stop", "brings both bodies to rest",
            [] { return impacts([](Subject&, const Scene&, Impulse& said) { said.after = {}; }); }),
      lying("canary.air_drag", "slows every body by a millionth",
            [] {
              return impacts([](Subject&, const Scene&, Impulse& said) {
                for (Velocity& V : said.after) V.v_WBcm *= 1 - 1e-6;
              });
            }),
  };
}

}  // namespace touchstone::oracle::subjects
