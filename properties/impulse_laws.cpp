// The clauses of docs/spec/impulse.md about pairs of answers as executable properties.
#include <cmath>
#include <functional>

#include "properties/cases/impact_case.h"
#include "properties/queries.h"
#include "properties/transforms/exact_sum.h"
#include "properties/transforms/scene.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Subject;
namespace judge = oracle::judge;

// Predicts the velocities after the impact in the changed scene from those in the original one.
using Predict = std::function<Moving(const Moving&)>;

Moving same(const Moving& V) { return V; }

// Queries both scenes and compares the second answer with the prediction from the first. `times` is the factor on the
// energy norm.
Finding changes(const Scene& scene, const std::optional<Scene>& other, Subject& subject, Defect defect,
                const Predict& predict, Real times = 1, bool exchanged = false) {
  return of_answered_impact(scene, subject, [&](const ImpactCase& asked, const SaidImpact& first) {
    if (asked.law_jumps()) return judge::outside("the impulse is a discontinuous function of the data here");
    return of_moved(other, subject, [&](const Scene& second_scene) {
      return of_answered_impact(second_scene, subject, [&](const ImpactCase& asked_then, const SaidImpact& second) {
        After expected;
        for (std::size_t i = 0; i < 2; ++i) expected[i] = predict(first.after[exchanged ? 1 - i : i]);
        const double allowed = static_cast<double>(times) * first.allowed + second.allowed;
        return judge::at_most(
            static_cast<double>(difference(asked_then, second.after, expected)), of_energy(asked_then, allowed), defect,
            [&] { return text(second.after); }, [&] { return text(expected) + ", from the other answer"; });
      });
    });
  });
}

Finding swapped_bodies(const Scene& scene, Subject& subject) {
  if (!scene.contact) return judge::outside("no contact");
  return changes(scene, swapped(scene), subject, Defect::asymmetric, same, 1, true);
}

Finding moved(const Scene& scene, Subject& subject) {
  if (!scene.contact) return judge::outside("no contact");
  return changes(scene, translated(scene), subject, Defect::moved_with_frame, same);
}

Finding turned_world(const Scene& scene, Subject& subject) {
  if (!scene.contact) return judge::outside("no contact");
  const auto by_third = [](const Moving& V) {
    const auto third = [](const Point& p) { return Point(p.z(), p.x(), p.y()); };
    return Moving{third(V.v_WBcm), third(V.w_WB)};
  };
  const auto by_half = [](const Moving& V) {
    const auto half = [](const Point& p) { return Point(p.x(), -p.y(), -p.z()); };
    return Moving{half(V.v_WBcm), half(V.w_WB)};
  };
  const Finding third = changes(scene, turned(scene), subject, Defect::moved_with_frame, by_third);
  if (failed(third)) return third;
  return changes(scene, half_turned(scene), subject, Defect::moved_with_frame, by_half);
}

// Reflection in the plane x = 0. Spins are axial vectors.
Finding mirrored_world(const Scene& scene, Subject& subject) {
  if (!scene.contact) return judge::outside("no contact");
  return changes(scene, mirrored(scene), subject, Defect::moved_with_frame, [](const Moving& V) {
    return Moving{{-V.v_WBcm.x(), V.v_WBcm.y(), V.v_WBcm.z()}, {V.w_WB.x(), -V.w_WB.y(), -V.w_WB.z()}};
  });
}

Finding galilean(const Scene& scene, Subject& subject) {
  if (!scene.contact) return judge::outside("no contact");
  const std::optional<Scene> other = boosted(scene);
  if (!other) return judge::outside("the boost is not exact in doubles for this scene");
  const Point v = (other->bodies[0].velocity.v_WBcm - scene.bodies[0].velocity.v_WBcm).cast<Real>();
  return changes(scene, other, subject, Defect::moved_with_frame, [v](const Moving& V) {
    return Moving{V.v_WBcm + v, V.w_WB};
  });
}

// Lengths times s at the same density: masses times s³, velocities times s, energies times s⁵.
Finding scaled_world(const Scene& scene, Subject& subject) {
  if (!scene.contact) return judge::outside("no contact");
  for (const int k : {10, -10}) {
    const Real s = std::ldexp(1.0L, k);
    const Finding finding = changes(
        scene, scaled(scene, k), subject, Defect::scaled,
        [s](const Moving& V) {
          return Moving{s * V.v_WBcm, V.w_WB};
        },
        std::sqrt(s * s * s * s * s));
    if (finding.outcome != oracle::Outcome::holds || k < 0) return finding;
  }
  return judge::holds();
}

// All velocities times s: Coulomb's law and the three laws of restitution have no velocity scale.
Finding faster(const Scene& scene, Subject& subject) {
  if (!scene.contact) return judge::outside("no contact");
  for (const int k : {20, -20}) {
    const Real s = std::ldexp(1.0L, k);
    const Finding finding = changes(
        scene, sped_up(scene, k), subject, Defect::scaled,
        [s](const Moving& V) {
          return Moving{s * V.v_WBcm, s * V.w_WB};
        },
        s);
    if (finding.outcome != oracle::Outcome::holds || k < 0) return finding;
  }
  return judge::holds();
}

Scene with(Scene scene, Law law, double e) {
  scene.contact->law = law;
  scene.contact->restitution = e;
  return scene;
}

// P_n = (1 + e) p_c, where p_c is the normal impulse with e = 0.
Finding poisson(const Scene& scene, Subject& subject) {
  return of_answered_impact(scene, subject, [&](const ImpactCase& asked, const SaidImpact& said) {
    if (asked.contact.law != Law::poisson || !asked.regular())
      return judge::outside("another law, or a second compression");
    const Scene plastic = with(scene, Law::poisson, 0);
    const ImpactCase asked_then(plastic, asked.precision);
    return answered(asked_then, subject, [&](const SaidImpact& compressed) {
      const Real P_n = asked.impact.nhat_BA_W.dot(said.P), p_c = asked.impact.nhat_BA_W.dot(compressed.P);
      const Real wanted = (1 + asked.e()) * p_c;
      const double allowed = said.per_normal + static_cast<double>(1 + asked.e()) * compressed.per_normal;
      return judge::at_most(
          static_cast<double>(std::abs(P_n - wanted)), in_ulps_of(asked, wanted, allowed, "the impulse"),
          Defect::inconsistent, [&] { return "P·n = " + text(P_n); },
          [&] { return text(wanted) + ", 1 + e times that with e = 0"; });
    });
  });
}

// The three laws agree where the slope of u_n is constant: where K_tn = 0 or without friction.
Finding laws(const Scene& scene, Subject& subject) {
  return of_impact(scene, subject, [&](const ImpactCase& asked) {
    if (!asked.uncoupled() && asked.contact.friction != 0) return judge::outside("the laws differ here");
    Finding last = judge::holds();
    for (const Law law : {Law::poisson, Law::stronge, Law::newton}) {
      if (law == asked.contact.law || last.outcome != oracle::Outcome::holds) continue;
      last = changes(scene, with(scene, law, asked.contact.restitution), subject, Defect::inconsistent, same);
    }
    return last;
  });
}

Finding repeats_itself(const Scene& scene, Subject& subject) {
  return of_impact(scene, subject, [&](const ImpactCase&) {
    return repeats(&Subject::impulse, scene, half_turned(swapped(scene)), subject);
  });
}

}  // namespace

std::vector<Property> impulse_law_properties() {
  const std::string query = "impulse";
  return {
      {"impulse.poisson",
       query,
       {"TS-IMPULSE-19"},
       "by Poisson's law the normal impulse is 1 + e times that with e = 0",
       poisson},
      {"impulse.laws",
       query,
       {"TS-IMPULSE-20"},
       "where the laws of Poisson, Stronge and Newton agree in theory, their answers agree",
       laws},
      {"impulse.swapped", query, {"TS-IMPULSE-21"}, "swapping A and B changes no velocity", swapped_bodies},
      {"impulse.moved", query, {"TS-IMPULSE-22"}, "translating the world changes no velocity", moved},
      {"impulse.turned", query, {"TS-IMPULSE-22"}, "rotating the world rotates the velocities", turned_world},
      {"impulse.mirrored", query, {"TS-IMPULSE-22"}, "reflecting the world reflects the velocities", mirrored_world},
      {"impulse.galilean",
       query,
       {"TS-IMPULSE-23"},
       "a velocity added to both bodies is added to the result",
       galilean},
      {"impulse.scaled", query, {"TS-IMPULSE-24"}, "scaling all lengths by s scales the velocities by s", scaled_world},
      {"impulse.faster",
       query,
       {"TS-IMPULSE-24"},
       "scaling the velocities before by s scales those after by s",
       faster},
      {"impulse.repeats", query, {"TS-IMPULSE-26"}, "the same impact has the same answer, bit for bit", repeats_itself},
  };
}

}  // namespace touchstone::properties
