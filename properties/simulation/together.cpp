// The clauses of docs/spec/simulation.md about impacts that act together: what holds whatever law an engine chooses.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "model/infinity.h"
#include "oracle/judge/words.h"
#include "oracle/tolerance/impulse.h"
#include "oracle/tolerance/tolerance.h"
#include "properties/cases/simultaneous_impacts.h"
#include "properties/cases/time_of_impact_case.h"
#include "properties/cases/trajectory_case.h"
#include "properties/queries.h"
#include "properties/transforms/scene.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Subject;
using Status = TimeOfImpact::Status;
namespace judge = oracle::judge;
namespace tolerance = oracle::tolerance;
namespace words = oracle::words;

/// The first impacts of a scene, if they are all at one time within rounding.
struct FirstInstant {
  double latest = infinity;  ///< s: all of them are made by then
  double next = infinity;    ///< s: no other pair in ballistic motion collides before
  double speed = 0;          ///< m/s: the greatest at which centres of mass approach each other
};

/// Nothing but impacts changes a velocity, and fixed bodies do not clamp others between them.
bool only_impacts_act(const Scene& scene) {
  const Body* fixed = nullptr;
  for (const Body& body : scene.bodies) {
    if (!is_fixed(body)) continue;
    if (fixed != nullptr && body.velocity != fixed->velocity) return false;
    fixed = &body;
  }
  return scene.gravity.isZero(0) && scene.motion->forces.empty() && scene.motion->start_times.empty();
}

/// None if a body rotates, if the bodies never collide, or if rounding decides which pairs do.
std::optional<FirstInstant> first_instant(const Scene& scene, oracle::Precision precision) {
  struct Collision {
    double earliest, latest;
    std::size_t a, b;
  };
  std::vector<Collision> collisions;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (!scene.bodies[b].velocity.w_WB.isZero(0)) return std::nullopt;
    for (std::size_t a = 0; a < b; ++a) {
      if (scene.bodies[a].velocity == scene.bodies[b].velocity) continue;
      Scene pair = scene;
      pair.bodies = {scene.bodies[a], scene.bodies[b]};
      const std::optional<MotionCase> moving = motion_case(pair, precision);
      if (!moving || !moving->sure()) return std::nullopt;
      const std::optional<double> earliest = moving->earliest(), latest = moving->latest();
      if (!earliest) continue;
      if (!latest) return std::nullopt;
      collisions.push_back({*earliest, *latest, a, b});
    }
  }
  if (collisions.empty()) return std::nullopt;
  const double surely = std::ranges::min_element(collisions, {}, &Collision::latest)->latest;
  FirstInstant first{0, infinity, 0};
  for (const Collision& each : collisions) {
    if (each.earliest > surely) {
      first.next = std::min(first.next, each.earliest);
      continue;
    }
    first.latest = std::max(first.latest, each.latest);
    const Vec3 u = scene.bodies[each.a].velocity.v_WBcm - scene.bodies[each.b].velocity.v_WBcm;
    first.speed = std::max(first.speed, u.norm());
  }
  return first;
}

/// How much of the speed of approach the velocities after it may change with an order: a choice. The impulses of one
/// impact after the other, in another order, differ by about the speed itself; rounding, and positions that differ
/// within the envelope, change them by less than 1e-5 of it even in 32 bits, and a few such impacts follow each other.
constexpr double part_by_rounding = 0x1p-10;

std::string words_of(const Velocity& velocity) {
  return "v = " + words::text(velocity.v_WBcm) + ", w = " + words::text(velocity.w_WB);
}

using Back = std::function<State(const std::vector<State>&, std::size_t body)>;

/// The velocities after the first impacts, at the next sample, are those of the changed scene, brought back by `back`.
Finding unchanged(const Scene& scene, const std::optional<Scene>& other, const Back& back, Defect defect,
                  Subject& subject) {
  return of_trajectory(scene, subject, [&](const TrajectoryCase& asked) {
    if (!other) return judge::outside("nothing to exchange");
    if (!only_impacts_act(scene)) return judge::outside("not only impacts act, or a body may be clamped");
    if (scene.bodies.size() > 8) return judge::outside("more than eight bodies");
    const std::optional<FirstInstant> first = first_instant(scene, asked.precision);
    if (!first) return judge::outside("a body rotates before, or rounding decides about the first impacts");
    const std::vector<double>& times = scene.motion->sample_times;
    const auto sample = static_cast<std::size_t>(std::ranges::upper_bound(times, first->latest) - times.begin());
    if (sample == times.size() || times[sample] >= first->next) {
      return judge::outside("no sample between the first impacts and others");
    }
    if (sample >= asked.samples()) return judge::silent("the state after the first impacts");
    return of_moved(other, subject, [&](const Scene& changed) {
      return judge::given(subject.simulation(changed), [&](const Trajectory& said) {
        if (!fault_in_form(changed, said).empty() || said.states.size() <= sample) {
          return judge::silent("the state after the first impacts");
        }
        Finding worst = judge::holds();
        for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
          const Velocity here = asked.said.states[sample][i].velocity, there = back(said.states[sample], i).velocity;
          const double differs =
              (here.v_WBcm - there.v_WBcm).norm() + tolerance::size(scene.bodies[i]) * (here.w_WB - there.w_WB).norm();
          if (worse(worst,
                    judge::at_most(
                        differs, {part_by_rounding * first->speed, first->speed, "speeds of approach", 0, first->speed},
                        defect, [&] { return "body " + std::to_string(i) + ": " + words_of(here); },
                        [&] { return words_of(there) + ", as in the changed scene"; }))) {
            return worst;
          }
        }
        return worst;
      });
    });
  });
}

Finding renumbered(const Scene& scene, Subject& subject) {
  const auto back = [](const std::vector<State>& states, std::size_t i) { return states[states.size() - 1 - i]; };
  return unchanged(scene, swapped(scene), back, Defect::relabelled, subject);
}

Finding vertices_and_parts_renumbered(const Scene& scene, Subject& subject) {
  const auto back = [](const std::vector<State>& states, std::size_t i) { return states[i]; };
  return unchanged(scene, relabelled_with_parts(scene), back, Defect::relabelled, subject);
}

Finding reflected(const Scene& scene, Subject& subject) {
  const auto back = [](const std::vector<State>& states, std::size_t i) {
    State state = states[i];
    state.velocity.v_WBcm.x() *= -1;
    state.velocity.w_WB.y() *= -1;
    state.velocity.w_WB.z() *= -1;
    return state;
  };
  return unchanged(scene, mirrored(scene), back, Defect::asymmetric, subject);
}

Finding pushes(const Scene& scene, Subject& subject) {
  return of_impacts(
      scene, subject,
      [](const TrajectoryCase& asked, const Event& event, const std::vector<Segment>& segments, bool together) {
        if (!together) return judge::outside("no other impact acts together with it");
        const double mu = std::min(asked.scene.bodies[segments[0].body].material.friction,
                                   asked.scene.bodies[segments[1].body].material.friction);
        const double P = event.P_A_W.norm(), P_n = event.P_A_W.dot(event.nhat_BA_W);
        const double across = (event.P_A_W - P_n * event.nhat_BA_W).norm();
        const double unit = oracle::unit_roundoff(asked.precision) * P;
        if (P == 0 || !std::isfinite(mu)) return judge::outside("no impulse, or unlimited friction");
        const auto at_most = [&](double beyond, double factor, Defect defect, const std::string& law) {
          return judge::at_most(
              std::max(0.0, beyond), {tolerance::cone(P, factor, asked.precision), unit, "ulps of the impulse", 0, P},
              defect, [&] { return text(event) + ": P = " + words::text(event.P_A_W); }, [&] { return law; });
        };
        const Finding pulls = at_most(-P_n, 0, Defect::pulls, "P·n ≥ 0");
        if (pulls.outcome == oracle::Outcome::fails) return pulls;
        return at_most(across - mu * P_n, mu, Defect::beyond_cone, "|P_t| ≤ mu P·n");
      });
}

}  // namespace

std::vector<Property> simulation_together_properties() {
  const std::string query = "simulation", clause = "TS-SIMULATION-";
  return {
      {"simulation.together_renumbered",
       query,
       {clause + "30"},
       "the order of the bodies does not change the velocities after impacts at one time",
       renumbered},
      {"simulation.together_relabelled",
       query,
       {clause + "30"},
       "the order of vertices and parts does not change the velocities after impacts at one time",
       vertices_and_parts_renumbered},
      {"simulation.together_mirrored",
       query,
       {clause + "30"},
       "mirroring the world mirrors the velocities after impacts at one time",
       reflected},
      {"simulation.together_pushes",
       query,
       {clause + "31"},
       "each of the impulses that act together pushes, and lies in the friction cone",
       pushes},
  };
}

}  // namespace touchstone::properties
