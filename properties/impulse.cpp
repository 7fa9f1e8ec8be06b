// The clauses of docs/spec/impulse.md about a single answer as executable properties.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "oracle/judge/words.h"
#include "oracle/tolerance/precision.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/truth.h"
#include "properties/cases/impact_case.h"
#include "properties/queries.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Subject;
namespace judge = oracle::judge;
namespace tolerance = oracle::tolerance;

Point exact(const reference::ExactVec3& v) {
  return {static_cast<Real>(v[0].nearest()), static_cast<Real>(v[1].nearest()), static_cast<Real>(v[2].nearest())};
}

// Compares the claimed velocities with those that a known impulse gives.
Finding moves_as(const ImpactCase& asked, const SaidImpact& said, const After& expected) {
  return judge::at_most(
      static_cast<double>(difference(asked, said.after, expected)), of_energy(asked, said.allowed),
      Defect::wrong_velocity, [&] { return text(said.after); }, [&] { return text(expected); });
}

Finding agrees(const Scene& scene, Subject& subject) {
  return of_answered_impact(scene, subject, [](const ImpactCase& asked, const SaidImpact& said) {
    const reference::ImpulseTruth& truth = oracle::truth::impulse(asked.scene);
    if (truth.ambiguous || asked.law_jumps())
      return judge::outside("the impulse is a discontinuous function of the data here");
    After expected;
    for (std::size_t i = 0; i < 2; ++i) expected[i] = {exact(truth.after[i].v_WBcm), exact(truth.after[i].w_WB)};
    return moves_as(asked, said, expected);
  });
}

Finding error_bound(const Scene& scene, Subject& subject) {
  return of_answered_impact(scene, subject, [](const ImpactCase& asked, const SaidImpact& said) {
    if (!said.answer.error || !said.answer.P_A_W) return judge::silent("an error bound of its impulse");
    const reference::ImpulseTruth& truth = oracle::truth::impulse(asked.scene);
    if (truth.ambiguous || asked.law_jumps())
      return judge::outside("the impulse is a discontinuous function of the data here");
    const Point off = said.answer.P_A_W->cast<Real>() - exact(truth.P_A_W);
    // The truth's own error plus the rounding of its three coordinates to doubles.
    const double enclosed =
        truth.error + 0x1p-53 * static_cast<double>(exact(truth.P_A_W).norm() * std::sqrt(asked.impact.K.trace()));
    return judge::at_most(
        static_cast<double>(std::sqrt(std::max<Real>(0, off.dot(asked.impact.K * off)))),
        of_energy(asked, *said.answer.error + enclosed), Defect::broken_enclosure,
        [&] { return "off by at most " + oracle::words::text(*said.answer.error); },
        [&] { return text(exact(truth.P_A_W)); });
  });
}

Finding decided(const Scene& scene, Subject& subject) {
  return of_answered_impact(scene, subject, [](const ImpactCase& asked, const SaidImpact& said) {
    if (!asked.regular()) return judge::outside("mu |K_tn| > K_nn: the impulse may be discontinuous");
    if (asked.law_jumps())
      return judge::outside("infinite friction stops slip if the bodies approach, and else does not");
    if (!said.answer.ambiguous) return judge::holds();
    return judge::wrong(Defect::inconsistent, "ambiguous: the impulse is discontinuous near these data",
                        "not ambiguous: the impulse is continuous here");
  });
}

Finding momentum(const Scene& scene, Subject& subject) {
  return of_answered_impact(scene, subject, [](const ImpactCase& asked, const SaidImpact& said) {
    Point change = Point::Zero();
    Real size = said.P.norm();
    for (std::size_t i = 0; i < 2; ++i) {
      const oracle::ImpactBody& body = asked.impact.bodies[i];
      if (body.fixed) return judge::outside("one body is fixed, and takes up momentum");
      change += body.mass * (said.after[i].v_WBcm - body.v_WBcm);
      size += body.mass * said.after[i].v_WBcm.norm();
    }
    const double allowed =
        tolerance::momentum(asked.scene, asked.impact, said.answer.after, said.P.norm(), asked.precision);
    return judge::at_most(
        static_cast<double>(change.norm()), in_ulps_of(asked, size, allowed, "the momenta"), Defect::wrong_momentum,
        [&] { return "the pair's momentum changes by " + text(change); }, [] { return std::string("no change"); });
  });
}

// An impulse at C has no moment about C. So the gain of a body's spin equals the loss of its centre's angular momentum
// about C.
Finding angular_momentum(const Scene& scene, Subject& subject) {
  return of_answered_impact(scene, subject, [](const ImpactCase& asked, const SaidImpact& said) {
    Finding worst;
    for (std::size_t i = 0; i < 2; ++i) {
      const oracle::ImpactBody& body = asked.impact.bodies[i];
      if (body.fixed) continue;
      const Point gained = body.mass * (said.after[i].v_WBcm - body.v_WBcm);
      const Point spin = body.angular_momentum(said.after[i].w_WB - body.w_WB);
      const Point moment = body.p_BcmC_W.cross(gained), rest = spin - moment;
      const Real P = std::max(said.P.norm(), gained.norm());
      const double allowed =
          tolerance::angular_momentum(asked.scene, asked.impact, i, said.answer.after[i], P, asked.precision);
      const Real size = body.moments[2] * said.after[i].w_WB.norm() + body.p_BcmC_W.norm() * P;
      const Finding finding = judge::at_most(
          static_cast<double>(rest.norm()), in_ulps_of(asked, size, allowed, "the angular momentum"),
          Defect::wrong_momentum, [&] { return "angular momentum changes by " + text(spin); },
          [&] { return text(moment) + ", the moment of the impulse"; });
      if (finding.outcome == oracle::Outcome::fails || finding.error > worst.error) worst = finding;
      if (worst.outcome == oracle::Outcome::fails) return worst;
    }
    return worst;
  });
}

Finding fixed(const Scene& scene, Subject& subject) {
  return of_answered_impact(scene, subject, [&](const ImpactCase& asked, const SaidImpact& said) {
    for (std::size_t i = 0; i < 2; ++i) {
      const oracle::ImpactBody& before = asked.impact.bodies[i];
      if (!before.fixed) continue;
      const Body& body = asked.scene.bodies[i];
      const Moving& after = said.after[i];
      const Real radius = tolerance::radius(body), speed = before.v_WBcm.norm() + radius * before.w_WB.norm();
      const Real change = (after.v_WBcm - before.v_WBcm).norm() + radius * (after.w_WB - before.w_WB).norm();
      const double bound = tolerance::velocity_as_kept(body, asked.precision, subject.card().stepping);
      return judge::at_most(
          static_cast<double>(change), in_ulps_of(asked, speed, bound, "its speed"), Defect::wrong_velocity,
          [&] { return text(said.after); }, [] { return std::string("the fixed body keeps its velocity"); });
    }
    return judge::outside("no body is fixed");
  });
}

Finding stated(const Scene& scene, Subject& subject) {
  return of_answered_impact(scene, subject, [](const ImpactCase& asked, const SaidImpact& said) {
    if (!said.answer.P_A_W) return judge::silent("the impulse");
    const Point P = said.answer.P_A_W->cast<Real>();
    const After made = asked.moved_by(P);
    // The stated impulse is rounded too.
    const Real rounded = oracle::unit_roundoff(asked.precision) * P.norm() * std::sqrt(asked.impact.K.trace());
    return judge::at_most(
        static_cast<double>(difference(asked, said.after, made)),
        of_energy(asked, said.allowed + static_cast<double>(rounded)), Defect::inconsistent,
        [&] { return text(said.after); }, [&] { return text(made) + ", from the stated impulse"; });
  });
}

// Judges by how much an impulse violates `law`, against the rounding bound: first the impulse recovered from the
// velocities, then the stated one, if any. Returns the first failure.
template <class Beyond>
Finding impulses(const ImpactCase& asked, const SaidImpact& said, double allowed, Real cone, Defect defect,
                 const std::string& law, Beyond&& beyond) {
  const auto judged = [&](const Point& P, double bound) {
    return judge::at_most(
        static_cast<double>(std::max<Real>(0, beyond(P))), in_ulps_of(asked, P.norm(), bound, "the impulse"), defect,
        [&] { return "P = " + text(P); }, [&] { return law; });
  };
  const Finding recovered = judged(said.P, allowed);
  if (!said.answer.P_A_W || recovered.outcome == oracle::Outcome::fails) return recovered;
  const Point P = said.answer.P_A_W->cast<Real>();
  const Finding stated = judged(P, tolerance::cone(P.norm(), cone, asked.precision));
  return stated.outcome == oracle::Outcome::fails ? stated : recovered;
}

Finding push(const Scene& scene, Subject& subject) {
  return of_answered_impact(scene, subject, [](const ImpactCase& asked, const SaidImpact& said) {
    return impulses(asked, said, said.per_normal, 0, Defect::pulls, "P·n ≥ 0",
                    [&](const Point& P) { return -asked.impact.nhat_BA_W.dot(P); });
  });
}

Finding cone(const Scene& scene, Subject& subject) {
  return of_answered_impact(scene, subject, [](const ImpactCase& asked, const SaidImpact& said) {
    if (!std::isfinite(asked.contact.friction)) return judge::outside("infinite friction has no cone");
    // |dP_t| ≤ √λ √(dPᵀ K dP), where λ is the greatest eigenvalue of K⁻¹.
    const double across = said.allowed * static_cast<double>(std::sqrt(asked.impact.K_inverse().trace()));
    return impulses(asked, said, across + asked.contact.friction * said.per_normal, asked.mu(), Defect::beyond_cone,
                    "|P_t| ≤ mu P·n", [&](const Point& P) {
                      const Real P_n = asked.impact.nhat_BA_W.dot(P);
                      return (P - P_n * asked.impact.nhat_BA_W).norm() - asked.mu() * P_n;
                    });
  });
}

// The greatest change of kinetic energy that theory allows (J): at most 0. None if theory does not bound it.
std::optional<Real> greatest_gain(const ImpactCase& asked, const SaidImpact& said) {
  const Real e = asked.e(), P_n = asked.impact.nhat_BA_W.dot(said.P), u_n = asked.impact.u_n();
  const bool free = asked.uncoupled() || asked.contact.friction == 0;
  if (asked.contact.law == Law::newton && !free) return std::nullopt;
  if (!asked.approaching() || !asked.regular()) return 0;
  if (asked.contact.law == Law::poisson) {
    const Real K_inverse_nn = asked.impact.nhat_BA_W.dot(asked.impact.impulse_for(asked.impact.nhat_BA_W));
    return -(1 - e) / (1 + e) * P_n * P_n / (2 * K_inverse_nn);
  }
  const Real steepest = asked.impact.K_nn() + (free ? 0 : asked.mu() * asked.impact.k().norm());
  return -(1 - e * e) * u_n * u_n / (2 * steepest);
}

// Compares dT with an upper (`above`) or a lower bound. The error of the velocities enters dT in proportion to the
// velocities, and the bound in proportion to the impulse.
Finding gain(const ImpactCase& asked, const SaidImpact& said, bool above, Real bound, const std::string& law) {
  const Real before = asked.kinetic_energy(moving({asked.scene.bodies[0].velocity, asked.scene.bodies[1].velocity}));
  const Real after = asked.kinetic_energy(said.after), dT = after - before;
  const Real P = asked.impact.energy_norm(said.u - asked.impact.u);
  const double slack = static_cast<double>((std::sqrt(2 * after) + P + said.allowed) * said.allowed);
  return judge::at_most(
      static_cast<double>(std::max<Real>(0, above ? dT - bound : bound - dT)),
      in_ulps_of(asked, before, slack, "the kinetic energy"), Defect::wrong_energy, [&] { return "dT = " + text(dT); },
      [&] { return law + " " + text(bound); });
}

Finding energy(const Scene& scene, Subject& subject) {
  return of_answered_impact(scene, subject, [](const ImpactCase& asked, const SaidImpact& said) {
    if (asked.fixed_body_moves()) return judge::outside("a fixed body that moves does work");
    const std::optional<Real> most = greatest_gain(asked, said);
    if (!most) return judge::outside("Newton's law with friction may gain energy");
    return gain(asked, said, true, *most, "dT ≤");
  });
}

Finding energy_floor(const Scene& scene, Subject& subject) {
  return of_answered_impact(scene, subject, [](const ImpactCase& asked, const SaidImpact& said) {
    if (asked.fixed_body_moves()) return judge::outside("a fixed body that moves does work");
    const Real N = asked.impact.energy_norm(asked.impact.u);
    return gain(asked, said, false, -N * N / 2, "dT ≥ −½ uᵀ K⁻¹ u =");
  });
}

Finding frictionless(const Scene& scene, Subject& subject) {
  return of_answered_impact(scene, subject, [](const ImpactCase& asked, const SaidImpact& said) {
    if (asked.contact.friction != 0 || !asked.approaching()) return judge::outside("friction, or no approach");
    const Real P_n = -(1 + asked.e()) * asked.impact.u_n() / asked.impact.K_nn();
    return moves_as(asked, said, asked.moved_by(P_n * asked.impact.nhat_BA_W));
  });
}

// Without slip, and |M⁻¹ k| ≤ mu, it sticks from the start: du/dp = n/(K⁻¹)_nn.
Finding stuck(const Scene& scene, Subject& subject) {
  return of_answered_impact(scene, subject, [](const ImpactCase& asked, const SaidImpact& said) {
    if (asked.slips() || !asked.approaching()) return judge::outside("slip, or no approach");
    const Point held = asked.impact.impulse_for(asked.impact.nhat_BA_W);  // ∝ (−M⁻¹ k, 1)
    const Real along = asked.impact.nhat_BA_W.dot(held), across = (held - along * asked.impact.nhat_BA_W).norm();
    if (!(across <= asked.mu() * along * (1 - 0x1p-40L)))
      return judge::outside("friction is too weak for sticking from the start");
    return moves_as(asked, said, asked.moved_by(-(1 + asked.e()) * asked.impact.u_n() * held));
  });
}

// K_tn = 0, and the slip direction is an eigenvector of K: slip keeps its line and stays 0 once it is 0.
Finding straight(const Scene& scene, Subject& subject) {
  return of_answered_impact(scene, subject, [](const ImpactCase& asked, const SaidImpact& said) {
    const oracle::Impact& impact = asked.impact;
    if (!asked.uncoupled() || !asked.approaching()) return judge::outside("K couples normal and slip, or no approach");
    const Real P_n = -(1 + asked.e()) * impact.u_n() / impact.K_nn(), s = impact.u_t().norm();
    Point P = P_n * impact.nhat_BA_W;
    if (asked.slips()) {
      const Point along = impact.u_t() / s;
      const Real M = along.dot(impact.K * along);
      if ((impact.K * along - M * along).norm() > 0x1p-58L * M)
        return judge::outside("the direction of slip changes during the impact");
      P -= std::min(asked.contact.friction == 0 ? 0 : asked.mu() * P_n, s / M) * along;
    }
    return moves_as(asked, said, asked.moved_by(P));
  });
}

// Judges the normal velocity after the impact, with |du_n| ≤ √K_nn √(duᵀ K⁻¹ du).
Finding normal_velocity(const ImpactCase& asked, const SaidImpact& said, Real error, const std::string& law) {
  const Real size = std::sqrt(asked.impact.K_nn());
  return judge::at_most(
      static_cast<double>(error),
      in_ulps_of(asked, size * asked.impact.energy_norm(asked.impact.u), said.allowed * static_cast<double>(size),
                 "the impact's velocity"),
      Defect::wrong_velocity, [&] { return "u·n = " + text(asked.impact.nhat_BA_W.dot(said.u)) + " after"; },
      [&] { return law; });
}

Finding no_approach(const Scene& scene, Subject& subject) {
  return of_answered_impact(scene, subject, [](const ImpactCase& asked, const SaidImpact& said) {
    if (!asked.regular())
      return judge::outside("mu |K_tn| > K_nn: under some laws the bodies still approach afterwards");
    const Real left = -asked.impact.nhat_BA_W.dot(said.u);
    return normal_velocity(asked, said, std::max<Real>(0, left), "u·n ≥ 0");
  });
}

Finding newton(const Scene& scene, Subject& subject) {
  return of_answered_impact(scene, subject, [](const ImpactCase& asked, const SaidImpact& said) {
    if (asked.contact.law != Law::newton || !asked.approaching()) return judge::outside("another law, or no approach");
    if (std::isinf(asked.contact.friction) && asked.slips() && !asked.uncoupled()) {
      return judge::outside("infinite friction stops slip at once, and u_n changes with it");
    }
    const Real wanted = -asked.e() * asked.impact.u_n();
    return normal_velocity(asked, said, std::abs(asked.impact.nhat_BA_W.dot(said.u) - wanted), "u·n = " + text(wanted));
  });
}

Finding plastic(const Scene& scene, Subject& subject) {
  return of_answered_impact(scene, subject, [](const ImpactCase& asked, const SaidImpact& said) {
    if (asked.contact.restitution != 0 || !asked.approaching()) return judge::outside("e > 0, or no approach");
    if (!asked.regular()) return judge::outside("mu |K_tn| > K_nn: a second compression may follow");
    return normal_velocity(asked, said, std::abs(asked.impact.nhat_BA_W.dot(said.u)), "u·n = 0");
  });
}

Finding separating(const Scene& scene, Subject& subject) {
  return of_answered_impact(scene, subject, [](const ImpactCase& asked, const SaidImpact& said) {
    if (asked.approaching()) return judge::outside("the bodies approach");
    if (asked.law_jumps()) return judge::outside("the impulse is a discontinuous function of the data here");
    return moves_as(asked, said, asked.moved_by(Point::Zero()));
  });
}

std::string fault(const Impulse& said) {
  if (said.error && *said.error < 0) return "an error below 0";
  return said.ambiguous && *said.ambiguous < 0 ? "a distance below 0" : "";
}

Finding survives_any(const Scene& scene, Subject& subject) {
  return of_impact(scene, subject,
                   [&](const ImpactCase&) { return survives(&Subject::impulse, scene, subject, fault); });
}

}  // namespace

std::vector<Property> impulse_properties() {
  const std::string query = "impulse";
  return {
      {"impulse.agrees",
       query,
       {"TS-IMPULSE-1"},
       "the velocities after the impact are those of the impact law",
       agrees},
      {"impulse.error_bound",
       query,
       {"TS-IMPULSE-2"},
       "the error of the impulse is within the stated bound",
       error_bound},
      {"impulse.decided",
       query,
       {"TS-IMPULSE-3"},
       "an impact is not called ambiguous where the impulse is a continuous function of the data",
       decided},
      {"impulse.momentum", query, {"TS-IMPULSE-4"}, "the momentum of the pair is conserved", momentum},
      {"impulse.angular_momentum",
       query,
       {"TS-IMPULSE-5"},
       "the angular momentum of each body about C is conserved",
       angular_momentum},
      {"impulse.fixed", query, {"TS-IMPULSE-6"}, "a fixed body keeps its velocity", fixed},
      {"impulse.stated", query, {"TS-IMPULSE-7"}, "the velocities follow from the stated impulse", stated},
      {"impulse.push", query, {"TS-IMPULSE-8"}, "the normal impulse is not negative", push},
      {"impulse.cone", query, {"TS-IMPULSE-9"}, "the impulse is in the friction cone", cone},
      {"impulse.energy", query, {"TS-IMPULSE-10"}, "the impact loses at least the energy that theory requires", energy},
      {"impulse.energy_floor",
       query,
       {"TS-IMPULSE-11"},
       "the impact loses no more energy than is possible",
       energy_floor},
      {"impulse.frictionless",
       query,
       {"TS-IMPULSE-12"},
       "without friction the impulse is −(1 + e) u_n/K_nn along the normal",
       frictionless},
      {"impulse.stuck",
       query,
       {"TS-IMPULSE-13"},
       "if contact sticks from the start, the impulse is −(1 + e) u_n K⁻¹ n",
       stuck},
      {"impulse.straight",
       query,
       {"TS-IMPULSE-14"},
       "if normal and slip are uncoupled, the friction impulse is mu P_n until slip stops",
       straight},
      {"impulse.no_approach", query, {"TS-IMPULSE-15"}, "the bodies do not approach after the impact", no_approach},
      {"impulse.newton",
       query,
       {"TS-IMPULSE-16"},
       "by Newton's law the speed of separation is e times the speed of approach",
       newton},
      {"impulse.plastic", query, {"TS-IMPULSE-17"}, "with e = 0 the bodies do not separate along the normal", plastic},
      {"impulse.separating", query, {"TS-IMPULSE-18"}, "separating bodies get no impulse", separating},
      {"impulse.survives", query, {"TS-IMPULSE-25"}, "every valid impact has a finite answer", survives_any},
  };
}

}  // namespace touchstone::properties
