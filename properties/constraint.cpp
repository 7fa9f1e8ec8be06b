// The clauses of docs/spec/constraint.md as executable properties.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "oracle/judge/words.h"
#include "oracle/rotation.h"
#include "oracle/tolerance/impulse.h"
#include "oracle/tolerance/tolerance.h"
#include "properties/cases/applied_impulse.h"
#include "properties/cases/constraint_case.h"
#include "properties/cases/restitution.h"
#include "properties/cases/time_of_impact_case.h"
#include "properties/cases/trajectory_case.h"
#include "properties/queries.h"
#include "properties/transforms/scene.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Subject;
namespace judge = oracle::judge;
namespace tolerance = oracle::tolerance;
using oracle::words::text;

judge::Allowance metres(double bound, double size) { return {bound, 1, "m", size}; }

/// m: size of the smaller of two bodies.
double smaller(const Scene& pair) { return std::min(tolerance::size(pair.bodies[0]), tolerance::size(pair.bodies[1])); }

std::string at(const Scene& scene, std::size_t sample) {
  return " at " + text(scene.motion->sample_times[sample]) + " s";
}

/// The worst finding over all samples. The first failure ends the search.
template <class JudgeSample>
Finding each_sample(const RollingCase& asked, JudgeSample&& judge_sample) {
  Finding worst = judge::outside("an event may be at each of the sample times");
  for (std::size_t i = 0; i < asked.samples(); ++i) {
    const Finding finding = judge_sample(i);
    if (finding.outcome == oracle::Outcome::outside) continue;
    if (finding.outcome != oracle::Outcome::holds) return finding;
    if (worst.outcome == oracle::Outcome::outside || finding.error > worst.error) worst = finding;
  }
  return worst;
}

Finding place(const Scene& scene, Subject& subject) {
  return of_rolling(scene, subject, [](const RollingCase& asked) {
    return each_sample(asked, [&](std::size_t i) { return judge_place(asked, i); });
  });
}

Finding velocity(const Scene& scene, Subject& subject) {
  return of_rolling(scene, subject, [](const RollingCase& asked) {
    return each_sample(asked, [&](std::size_t i) {
      return asked.bounds[i].settled ? judge_velocity(asked, i) : judge::outside("an event may be at the sample time");
    });
  });
}

std::string text_of(const std::set<std::pair<int, int>>& pairs) {
  std::string all;
  for (const auto& [a, b] : pairs) all += " (" + std::to_string(a) + ", " + std::to_string(b) + ")";
  return all.empty() ? "no contact" : "contact of" + all;
}

Finding contacts(const Scene& scene, Subject& subject) {
  return of_rolling(scene, subject, [](const RollingCase& asked) {
    if (!asked.said.events) return judge::silent("its events");
    std::vector<Event> exact;
    for (const auto& change : asked.truth.changes) {
      Event event;
      event.kind = change.kind;
      event.time = change.time.hi;
      event.a = std::min(asked.truth.ball, change.other);
      event.b = std::max(asked.truth.ball, change.other);
      exact.push_back(std::move(event));
    }
    return each_sample(asked, [&](std::size_t i) {
      if (!asked.bounds[i].settled) return judge::outside("an event may be at the sample time");
      const double time = asked.scene.motion->sample_times[i];
      const auto said = in_contact(*asked.said.events, time), truth = in_contact(exact, time);
      if (said == truth) return judge::holds();
      return judge::wrong(said.size() < truth.size() ? Defect::missed : Defect::phantom,
                          text_of(said) + at(asked.scene, i), text_of(truth));
    });
  });
}

Scene as_at(Scene scene, const std::vector<State>& states) {
  for (std::size_t i = 0; i < states.size(); ++i) scene.bodies[i].X_WB = states[i].X_WB;
  return scene;
}

/// Of the two of all bodies that overlap most, or the first two that overlap too much.
Finding apart_at(const Scene& scene, const std::vector<State>& states, std::size_t sample, oracle::Precision in) {
  const Scene now = as_at(scene, states);
  Finding worst = judge::outside("no two bodies of which one moves");
  for (std::size_t a = 0; a < now.bodies.size(); ++a) {
    for (std::size_t b = a + 1; b < now.bodies.size(); ++b) {
      if (is_fixed(now.bodies[a]) && is_fixed(now.bodies[b])) continue;
      Scene pair;
      pair.bodies = {now.bodies[a], now.bodies[b]};
      const double depth = judge::overlap(pair), rounding = tolerance::rounding_of_places(scene, a, b, in);
      const double bound = tolerance::overlap_of_step(scene) + rounding;
      const Finding finding = counted(is_decisive(pair, rounding),
                                      judge::at_most(
                                          depth, metres(bound, smaller(pair)), Defect::overdeep,
                                          [&] {
                                            return "bodies " + std::to_string(a) + " and " + std::to_string(b) +
                                                   " overlap by " + text(depth) + " m" + at(scene, sample);
                                          },
                                          [] { return std::string("no overlap"); }));
      if (worse(worst, finding)) return worst;
    }
  }
  return worst;
}

Finding apart(const Scene& scene, Subject& subject) {
  return of_steps(scene, subject, [&](const Trajectory& said) {
    if (said.states.empty()) return judge::silent("any state");
    Finding worst = judge::outside("no two bodies of which one moves");
    for (std::size_t sample = 0; sample < said.states.size(); ++sample) {
      if (worse(worst, apart_at(scene, said.states[sample], sample, subject.card().precision))) break;
    }
    return worst;
  });
}

/// Kinetic plus potential energy, and the sum of the terms' sizes (J).
struct Energy {
  double sum = 0, terms = 0;
};

Energy energy(const Scene& scene, const std::vector<State>& states) {
  Energy all;
  const auto& masses = oracle::truth::mass(scene);
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (!masses[i]) continue;
    const auto& m = *masses[i];
    Mat3 I;
    const double xy = m.I_BBcm_B[3].middle(), xz = m.I_BBcm_B[4].middle(), yz = m.I_BBcm_B[5].middle();
    I << m.I_BBcm_B[0].middle(), xy, xz, xy, m.I_BBcm_B[1].middle(), yz, xz, yz, m.I_BBcm_B[2].middle();
    const Eigen::Quaterniond turn = oracle::rotation(states[i].X_WB.q_WB);
    const Vec3 w = turn.conjugate() * states[i].velocity.w_WB, v = states[i].velocity.v_WBcm;
    const Vec3 p = turn * Vec3(m.p_BBcm[0].middle(), m.p_BBcm[1].middle(), m.p_BBcm[2].middle()) + states[i].X_WB.p_WB;
    const double moves = (m.mass.middle() * v.squaredNorm() + w.dot(I * w)) / 2;
    all.sum += moves - m.mass.middle() * scene.gravity.dot(p);
    all.terms += moves + m.mass.middle() * scene.gravity.norm() * p.norm();
  }
  return all;
}

Finding energy_falls(const Scene& scene, Subject& subject) {
  return of_steps(scene, subject, [&](const Trajectory& said) {
    if (restitution_may_add_energy(scene)) return judge::outside("rebounds with friction of a body that is no ball");
    if (!fixed_bodies_rest(scene) || !scene.motion->forces.empty())
      return judge::outside("an applied force or a moving fixed body may do work");
    if (said.states.empty()) return judge::silent("any state");
    const std::vector<State> before = first_states(scene);
    const double allowed = tolerance::energy_of_steps(scene);
    const double roundings = tolerance::rounding_of_energies(subject.card().precision);
    Energy last = energy(scene, before);
    Finding worst;
    for (std::size_t i = 0; i < said.states.size(); ++i) {
      const Energy now = energy(scene, said.states[i]);
      const double gain = now.sum - last.sum, bound = allowed + roundings * std::max(now.terms, last.terms);
      const Finding finding = judge::at_most(
          std::max(0.0, gain), {bound, 1, "J", 0, std::abs(last.sum)}, Defect::wrong_energy,
          [&] { return "energy rises by " + text(gain) + " J" + at(scene, i); },
          [] { return std::string("energy never rises"); });
      if (finding.outcome == oracle::Outcome::fails) return finding;
      if (finding.error > worst.error) worst = finding;
      last = now;
    }
    return worst;
  });
}

/// Eight for each granted step: a choice.
constexpr double roundings = 8 * 1024;

/// The momentum of all bodies, of which none is fixed, changes by gravity and the applied forces alone.
Finding momentum(const Scene& scene, Subject& subject) {
  return of_steps(scene, subject, [&](const Trajectory& said) {
    if (std::ranges::any_of(scene.bodies, [](const Body& body) { return is_fixed(body); })) {
      return judge::outside("a fixed body may take momentum");
    }
    if (!scene.motion->start_times.empty()) return judge::outside("bodies that start at times of their own");
    if (said.states.empty()) return judge::silent("any state");
    const auto& masses = oracle::truth::mass(scene);
    double mass = 0, greatest = 0;
    Vec3 at_start = Vec3::Zero();
    std::vector<double> m;
    for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
      m.push_back(masses[k]->mass.lo);
      mass += m[k];
      at_start += m[k] * scene.bodies[k].velocity.v_WBcm;
      greatest += m[k] * scene.bodies[k].velocity.v_WBcm.norm();
    }
    Finding worst;
    for (std::size_t i = 0; i < said.states.size(); ++i) {
      const double time = scene.motion->sample_times[i];
      const AppliedImpulse pushed = applied_until(scene, time);
      const Vec3 gained = time * mass * scene.gravity + pushed.total;
      Vec3 now = Vec3::Zero();
      double sizes = greatest + gained.norm();
      for (std::size_t k = 0; k < m.size(); ++k) {
        now += m[k] * said.states[i][k].velocity.v_WBcm;
        sizes += m[k] * said.states[i][k].velocity.v_WBcm.norm();
      }
      const double late = tolerance::granted_step(scene) * (pushed.changes + mass * scene.gravity.norm());
      const double rounding = roundings * oracle::unit_roundoff(subject.card().precision) * sizes;
      const Finding finding =
          judge::at_most((now - at_start - gained).norm(), {late + rounding, 1, "N s", 0, sizes},
                         Defect::wrong_momentum, [&] { return "momentum " + text(now) + " N s" + at(scene, i); },
                         [&] { return text(Vec3(at_start + gained)) + " N s"; });
      if (finding.outcome == oracle::Outcome::fails) return finding;
      if (finding.error >= worst.error) worst = finding;
    }
    return worst;
  });
}

Finding cone(const Scene& scene, Subject& subject) {
  return of_steps(scene, subject, [&](const Trajectory& said) {
    if (!said.events) return judge::silent("its events");
    Finding worst = judge::outside("no event");
    for (const Event& event : *said.events) {
      if (event.kind == Event::Kind::force) continue;
      const auto body = [&](int i) -> const Body& { return scene.bodies[static_cast<std::size_t>(i)]; };
      const double mu = std::min(body(event.a).material.friction, body(event.b).material.friction);
      if (!tolerance::is_unit(event.nhat_BA_W, subject.card().precision))
        return judge::wrong(Defect::wrong_normal, "n = " + text(event.nhat_BA_W) + " at " + text(event.time) + " s",
                            "a unit normal");
      const Vec3 n = event.nhat_BA_W.normalized();
      const double P_n = n.dot(event.P_A_W), size = event.P_A_W.norm(), P_t = (event.P_A_W - P_n * n).norm();
      const double beyond = std::max({-P_n, P_t - mu * P_n, 0.0});
      const oracle::Real impulse = size, friction = mu;
      const Finding finding = judge::at_most(
          beyond, {4 * tolerance::cone(impulse, friction, subject.card().precision), 1, "N s", 0, size},
          P_n < 0 ? Defect::pulls : Defect::beyond_cone,
          [&] { return "P_n = " + text(P_n) + ", |P_t| = " + text(P_t) + " at " + text(event.time) + " s"; },
          [&] { return "P_n ≥ 0 and |P_t| ≤ " + text(mu) + " P_n"; });
      if (finding.outcome == oracle::Outcome::fails) return finding;
      if (worst.outcome == oracle::Outcome::outside || finding.error > worst.error) worst = finding;
    }
    return worst;
  });
}

Finding fixed(const Scene& scene, Subject& subject) {
  return of_steps(scene, subject, [&](const Trajectory& said) {
    if (said.states.empty()) return judge::silent("any state");
    Finding finding = judge::outside("no body is fixed and at rest");
    for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
      const Body& body = scene.bodies[k];
      if (!std::holds_alternative<Fixed>(body.mass) || body.velocity != Velocity{}) continue;
      finding = judge::holds();
      const double kept = tolerance::place_as_kept(body, subject.card().precision);
      for (const std::vector<State>& states : said.states) {
        const bool stays = (states[k].X_WB.p_WB - body.X_WB.p_WB).norm() <= kept && states[k].velocity == body.velocity;
        if (!stays) return judge::wrong(Defect::drifts, "a fixed body moves", "a fixed body does not move");
      }
    }
    return finding;
  });
}

/// Compares the answer for the transformed scene, transformed back by `back`, with the original answer. Each of the two
/// may be off by its bound. `ball(n)`: the number in the transformed scene of a ball that is the n-th body.
template <class Back, class Ball>
Finding covariant(const Scene& scene, const std::optional<Scene>& moved, Subject& subject, Defect defect, Back&& back,
                  Ball&& ball) {
  return of_rolling(scene, subject, [&](const RollingCase& asked) {
    return of_moved(moved, subject, [&](const Scene& other) {
      return judge::given(subject.constraint(other), [&](const Trajectory& said) {
        if (!fault_of_steps(other, said).empty()) return judge::outside("not a trajectory; see constraint.survives");
        return each_sample(asked, [&](std::size_t i) {
          if (i >= said.states.size()) return judge::outside("the second answer ends before this sample");
          const Vec3 p = asked.ball(i).X_WB.p_WB;
          const Vec3 q = back(said.states[i][ball(static_cast<std::size_t>(asked.truth.ball))].X_WB.p_WB);
          return judge::at_most((p - q).norm(), metres(2 * asked.bounds[i].place, asked.radius()), defect,
                                [&] { return text(q) + ", transformed back," + at(asked.scene, i); },
                                [&] { return text(p); });
        });
      });
    });
  });
}

std::size_t same_number(std::size_t body) { return body; }

Finding moved(const Scene& scene, Subject& subject) {
  const std::optional<Scene> other = translated(scene);
  const Vec3 by = other ? translation_between(scene, *other) : Vec3::Zero();
  return covariant(
      scene, other, subject, Defect::moved_with_frame, [&](const Vec3& p) { return Vec3(p - by); }, same_number);
}

Finding turned_world(const Scene& scene, Subject& subject) {
  return covariant(
      scene, turned(scene), subject, Defect::moved_with_frame, [](const Vec3& p) { return turned(turned(p)); },
      same_number);
}

Finding renumbered(const Scene& scene, Subject& subject) {
  const std::size_t last = scene.bodies.size() - 1;
  return covariant(
      scene, swapped(scene), subject, Defect::relabelled, [](const Vec3& p) { return p; },
      [last](std::size_t body) { return last - body; });
}

Finding mirrored_world(const Scene& scene, Subject& subject) {
  return covariant(
      scene, mirrored(scene), subject, Defect::moved_with_frame,
      [](const Vec3& p) { return Vec3(-p.x(), p.y(), p.z()); }, same_number);
}

Finding survives_any(const Scene& scene, Subject& subject) {
  if (!scene.motion) return judge::outside("no motion");
  return of_scene(scene, subject, [&] {
    return survives<Trajectory>(&Subject::constraint, scene, subject,
                                [&](const Trajectory& said) { return fault_of_steps(scene, said); });
  });
}

Finding repeats_itself(const Scene& scene, Subject& subject) {
  if (!scene.motion) return judge::outside("no motion");
  Scene another = scene;
  another.gravity *= 0.5;
  return of_scene(scene, subject, [&] { return repeats<Trajectory>(&Subject::constraint, scene, another, subject); });
}

}  // namespace

std::vector<Property> constraint_properties() {
  const std::string query = "constraint";
  return {
      {"constraint.agrees", query, {"TS-CONSTRAINT-1"}, "the ball's centre is where the exact solution has it", place},
      {"constraint.velocity",
       query,
       {"TS-CONSTRAINT-2"},
       "the ball's velocity and spin are those of the exact solution",
       velocity},
      {"constraint.contacts",
       query,
       {"TS-CONSTRAINT-3"},
       "the reported contacts of the ball are those of the exact solution",
       contacts},
      {"constraint.fixed", query, {"TS-CONSTRAINT-4"}, "fixed bodies do not move", fixed},
      {"constraint.moved", query, {"TS-CONSTRAINT-5"}, "translating the world translates the trajectory", moved},
      {"constraint.turned", query, {"TS-CONSTRAINT-5"}, "rotating the world rotates the trajectory", turned_world},
      {"constraint.apart", query, {"TS-CONSTRAINT-6"}, "bodies do not penetrate each other", apart},
      {"constraint.energy", query, {"TS-CONSTRAINT-7"}, "energy never rises", energy_falls},
      {"constraint.momentum",
       query,
       {"TS-CONSTRAINT-13"},
       "where no body is fixed, gravity and applied forces alone change the momentum",
       momentum},
      {"constraint.cone", query, {"TS-CONSTRAINT-8"}, "contact impulses push, and friction stays in its cone", cone},
      {"constraint.renumbered",
       query,
       {"TS-CONSTRAINT-11"},
       "listing the bodies in another order changes nothing",
       renumbered},
      {"constraint.mirrored",
       query,
       {"TS-CONSTRAINT-11"},
       "mirroring the world mirrors the trajectory",
       mirrored_world},
      {"constraint.survives",
       query,
       {"TS-CONSTRAINT-9"},
       "every valid scene has an answer that is finite and complete",
       survives_any},
      {"constraint.repeats",
       query,
       {"TS-CONSTRAINT-10"},
       "the same scene has the same answer, bit for bit",
       repeats_itself},
  };
}

}  // namespace touchstone::properties
