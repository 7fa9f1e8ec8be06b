// The clauses of docs/spec/simulation.md about conserved quantities of a whole trajectory as executable properties.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "model/limits.h"
#include "oracle/judge/words.h"
#include "oracle/tolerance/motion.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/impact.h"
#include "properties/cases/applied_impulse.h"
#include "properties/cases/time_of_impact_case.h"
#include "properties/cases/trajectory_case.h"
#include "properties/cases/whole_tables.h"
#include "properties/queries.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::ImpactBody;
using oracle::Matrix;
using oracle::Point;
using oracle::Real;
using oracle::Subject;
namespace judge = oracle::judge;
namespace tolerance = oracle::tolerance;

/// A sum over bodies, and the sum of the sizes that scale its rounding.
template <class Value>
struct Sum {
  Value value;
  Real size = 0;
};

/// The bodies of a scene in the states of one sample.
std::vector<ImpactBody> bodies_at(const Scene& scene, const std::vector<State>& states) {
  Scene there = scene;
  std::vector<ImpactBody> bodies;
  for (std::size_t i = 0; i < states.size(); ++i) {
    there.bodies[i].X_WB = states[i].X_WB;
    there.bodies[i].velocity = states[i].velocity;
  }
  for (std::size_t i = 0; i < states.size(); ++i) bodies.push_back(oracle::impact_body(there, i, Vec3::Zero()));
  return bodies;
}

bool start_at_once(const Scene& scene) {
  const std::vector<double>& starts = scene.motion->start_times;
  return std::ranges::all_of(starts, [&](double t) { return t == starts.front(); });
}

double start_of_all(const Scene& scene) {
  return scene.motion->start_times.empty() ? 0 : scene.motion->start_times.front();
}

bool any_fixed(const Scene& scene) {
  return std::ranges::any_of(scene.bodies, [](const Body& b) { return std::holds_alternative<Fixed>(b.mass); });
}

/// How often velocities were rounded: at each event, and in each step of contact that the subject tells.
std::size_t changes(const TrajectoryCase& asked) {
  const Trajectory& said = asked.said;
  if (!said.events) return tolerance::steps;
  const int steps = said.contact_solver ? said.contact_solver->steps : 0;
  return said.events->size() + std::min(static_cast<std::size_t>(std::max(steps, 0)), tolerance::steps);
}

/// The rounding allowance of a sum whose terms have total size `size`.
judge::Allowance of_sum(const TrajectoryCase& asked, Real size, const char* name) {
  const double u = oracle::unit_roundoff(asked.precision), unit = u * std::max(static_cast<double>(size), 0x1p-900);
  return {tolerance::accumulated(changes(asked), asked.scene.bodies.size()) * unit, unit, name, 0,
          static_cast<double>(size)};
}

/// 1: the relative error of a body's mass as the subject computes it.
Real mass_error(const TrajectoryCase& asked, std::size_t i, const ImpactBody& body) {
  return tolerance::mass(asked.scene.bodies[i], asked.precision).mass / body.mass;
}

Sum<Point> momentum_of(const std::vector<ImpactBody>& bodies) {
  Sum<Point> sum{Point::Zero()};
  for (const ImpactBody& body : bodies) {
    sum.value += body.mass * body.v_WBcm;
    sum.size += body.mass * body.v_WBcm.norm();
  }
  return sum;
}

/// N s: a stepper may let a force begin, change or end a step late.
double late(const TrajectoryCase& asked, const AppliedImpulse& applied) {
  return asked.stepping ? asked.stepping->step * applied.changes : 0;
}

// Impacts conserve the total momentum of free bodies. Gravity adds the total mass times g times the time, and an
// applied force its impulse.
Finding momentum(const Scene& scene, Subject& subject) {
  return of_trajectory(scene, subject, [&](const TrajectoryCase& asked) {
    const bool pushed = !scene.motion->forces.empty();
    if (any_fixed(scene) || !start_at_once(scene) || (pushed && !scene.motion->start_times.empty())) {
      return judge::outside("a fixed body changes momentum, or bodies start one after the other");
    }
    const std::vector<ImpactBody> first = bodies_at(scene, first_states(scene));
    const Sum<Point> before = momentum_of(first);
    Real mass = 0, off = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
      mass += first[i].mass;
      off = std::max(off, mass_error(asked, i, first[i]));
    }
    Finding worst = judge::outside("no sample");
    for (std::size_t sample = 0; sample < asked.samples(); ++sample) {
      const Real seconds = asked.time(sample) - start_of_all(scene);
      const Sum<Point> now = momentum_of(bodies_at(scene, asked.said.states[sample]));
      const AppliedImpulse applied = applied_until(scene, asked.time(sample));
      const Point given = mass * seconds * scene.gravity.cast<Real>();
      const Point expected = before.value + given + applied.total.cast<Real>();
      const Real pushes = std::accumulate(applied.of_bodies.begin(), applied.of_bodies.end(), Real{0});
      const Real size = before.size + now.size + given.norm() + pushes;
      judge::Allowance allowed = of_sum(asked, size, "ulps of the momenta");
      allowed.bound += 2 * static_cast<double>(off * size) + late(asked, applied);
      if (worse(worst, judge::at_most(
                           static_cast<double>((now.value - expected).norm()), allowed, Defect::wrong_momentum,
                           [&] { return oracle::words::text(Vec3(now.value.cast<double>())); },
                           [&] { return oracle::words::text(Vec3(expected.cast<double>())); }))) {
        return worst;
      }
    }
    return worst;
  });
}

bool round(const ImpactBody& body) { return body.moments[2] - body.moments[0] <= 0x1p-40L * body.moments[2]; }

// The angular momentum about the world's origin.
Sum<Point> angular_momentum_of(const std::vector<ImpactBody>& bodies) {
  Sum<Point> sum{Point::Zero()};
  for (const ImpactBody& body : bodies) {
    const Point c = -body.p_BcmC_W;  // from W's origin
    sum.value += c.cross(Point(body.mass * body.v_WBcm)) + body.angular_momentum(body.w_WB);
    sum.size += c.norm() * body.mass * body.v_WBcm.norm() + body.moments[2] * body.w_WB.norm();
  }
  return sum;
}

/// kg m²/s: what lifting overlaps out of each other may change. A step leaves two bodies overlapping by the way of a
/// step, w, at most. They are moved apart with their common centre kept, each by w at most, so the sum of c × m v
/// changes by m w |v − v'|, with m the lesser mass: once for each pair.
double lifted(const TrajectoryCase& asked, const std::vector<ImpactBody>& bodies) {
  if (!asked.stepping) return 0;
  const double way = tolerance::way_of_step(asked.scene, asked.stepping->step);
  const double relative = way / asked.stepping->step;  // m/s: it is the way of two bodies at the greatest speed
  Real sum = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies.size(); ++j) sum += std::min(bodies[i].mass, bodies[j].mass);
  }
  return static_cast<double>(sum) * way * relative;
}

// Only for bodies whose three principal moments are equal: their angular momentum does not depend on their orientation.
Finding angular_momentum(const Scene& scene, Subject& subject) {
  return of_trajectory(scene, subject, [&](const TrajectoryCase& asked) {
    const std::vector<ImpactBody> first = bodies_at(scene, first_states(scene));
    if (any_fixed(scene) || !scene.motion->forces.empty() || !scene.gravity.isZero(0) || !start_at_once(scene)) {
      return judge::outside("forces or fixed bodies");
    }
    if (!std::ranges::all_of(first, round)) return judge::outside("principal moments that differ");
    const Sum<Point> before = angular_momentum_of(first);
    Real off = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
      const Real I = tolerance::mass(scene.bodies[i], asked.precision).inertia / first[i].moments[0];
      off = std::max({off, mass_error(asked, i, first[i]), I});
    }
    Finding worst = judge::outside("no sample");
    for (std::size_t sample = 0; sample < asked.samples(); ++sample) {
      const Sum<Point> now = angular_momentum_of(bodies_at(scene, asked.said.states[sample]));
      judge::Allowance allowed = of_sum(asked, before.size + now.size, "ulps of the angular momenta");
      allowed.bound += 2 * static_cast<double>(off * (before.size + now.size)) + lifted(asked, first);
      if (worse(worst, judge::at_most(
                           static_cast<double>((now.value - before.value).norm()), allowed, Defect::wrong_momentum,
                           [&] { return oracle::words::text(Vec3(now.value.cast<double>())); },
                           [&] { return oracle::words::text(Vec3(before.value.cast<double>())); }))) {
        return worst;
      }
    }
    return worst;
  });
}

// Kinetic plus potential energy.
Sum<Real> energy_of(const TrajectoryCase& asked, const std::vector<ImpactBody>& bodies) {
  Sum<Real> sum{0};
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const ImpactBody& body = bodies[i];
    if (body.fixed) continue;
    const Point c = -body.p_BcmC_W, g = asked.scene.gravity.cast<Real>();
    const Real swing = body.spin_energy_twice(body.w_WB) / 2, push = body.mass * body.v_WBcm.squaredNorm() / 2;
    sum.value += push + swing - body.mass * g.dot(c);
    sum.size += push + swing + body.mass * g.norm() * c.norm();
  }
  return sum;
}

// 1: the relative error of an energy that follows from the errors of masses and orientations. An orientation that is
// off by an angle changes wᵀ I w by at most twice that angle times I w².
Real pose_error(const TrajectoryCase& asked, const std::vector<ImpactBody>& bodies) {
  Real worst = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].fixed) continue;
    const Real I = tolerance::mass(asked.scene.bodies[i], asked.precision).inertia / bodies[i].moments[0];
    const Real spread = bodies[i].moments[2] / bodies[i].moments[0];
    const double rate = static_cast<double>(bodies[i].w_WB.norm() * std::sqrt(spread));
    const Real turn = round(bodies[i]) ? 0 : tolerance::turn(asked.scene, i, rate, asked.end, asked.precision);
    worst = std::max(worst, mass_error(asked, i, bodies[i]) + I + 2 * turn * spread);
  }
  return worst;
}

// J: the potential energy of a rise by the envelope. A resting body may be anywhere within it.
Real lift(const TrajectoryCase& asked, const std::vector<ImpactBody>& bodies) {
  Real sum = 0;
  for (const ImpactBody& body : bodies) sum += body.mass;
  return sum * asked.scene.gravity.cast<Real>().norm() * envelope(asked.scene);
}

// J: what the stepping that the subject declares explains, in so many seconds: the centres are off by g h/2 a second,
// a body that touches is as deep in the other as it moves in a step, and lifted out of it; and the angular velocity of
// a body whose moments differ is off by dω, so that ωᵀIω/2 is by I (ω + dω/2) dω. `states`: at one end of that time.
Real stepped(const TrajectoryCase& asked, const std::vector<State>& states, double seconds) {
  if (!asked.stepping) return 0;
  const double g = asked.scene.gravity.norm(), h = asked.stepping->step;
  const std::vector<ImpactBody> bodies = bodies_at(asked.scene, states);
  Scene now = asked.scene;
  now.motion->start_times.clear();
  Real mass = 0, swing = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].fixed) continue;
    mass += bodies[i].mass;
    now.bodies[i].X_WB = states[i].X_WB;
    now.bodies[i].velocity = states[i].velocity;
    const Real dw = tolerance::stepped(now, i, seconds, *asked.stepping, asked.precision).spin;
    swing += bodies[i].moments[2] * (bodies[i].w_WB.norm() + dw / 2) * dw;
  }
  const double fall = asked.stepping->order > 1 ? 0 : g * h * seconds / 2;
  return mass * g * (fall + tolerance::way_of_step(asked.scene, h)) + swing;
}

// Judges the energy gain between consecutive samples, and if `kept` its loss too. A subject whose slower approaches do
// not bounce may lose the energy of any of these, so its loss is not judged.
Finding energy_between_samples(const TrajectoryCase& asked, bool kept) {
  const std::vector<State> first = first_states(asked.scene);
  const std::vector<State>* last = &first;
  std::vector<ImpactBody> bodies = bodies_at(asked.scene, first);
  Sum<Real> before = energy_of(asked, bodies);
  Real off = pose_error(asked, bodies);
  const Real lifted = lift(asked, bodies);
  Finding worst = judge::outside("no sample");
  for (std::size_t sample = 0; sample < asked.samples(); ++sample) {
    const std::vector<State>& after = asked.said.states[sample];
    bodies = bodies_at(asked.scene, after);
    const Sum<Real> now = energy_of(asked, bodies);
    off = std::max(off, pose_error(asked, bodies));
    const Real gain = now.value - before.value, size = before.size + now.size;
    judge::Allowance allowed = of_sum(asked, size, "ulps of the energies");
    const double since = sample == 0 ? start_of_all(asked.scene) : asked.time(sample - 1);
    const double seconds = asked.time(sample) - since;
    const Real explained = std::max(stepped(asked, *last, seconds), stepped(asked, after, seconds));
    last = &after;
    allowed.bound += static_cast<double>(2 * (off * size + lifted) + explained);
    if (kept && asked.dynamics.restitution_threshold > 0 && -gain > allowed.bound) {
      return judge::outside("a loss that approaches slower than the " +
                            oracle::words::text(asked.dynamics.restitution_threshold) + " m/s that bounce explain");
    }
    const Real error = kept ? std::abs(gain) : std::max<Real>(0, gain);
    const auto text_of_sum = [](const Sum<Real>& sum) {
      return oracle::words::text(static_cast<double>(sum.value)) + " J";
    };
    if (worse(worst, counted(off * 1024 < 1, judge::at_most(
                                                 static_cast<double>(error), allowed, Defect::wrong_energy,
                                                 [&] { return text_of_sum(now); },
                                                 [&] { return text_of_sum(before) + ", as before"; })))) {
      return worst;
    }
    before = now;
  }
  return worst;
}

bool frictionless(const Scene& scene) {
  return std::ranges::count_if(scene.bodies, [](const Body& b) { return b.material.friction > 0; }) <= 1;
}

bool elastic(const Scene& scene) {
  return std::ranges::all_of(scene.bodies, [](const Body& b) { return b.material.restitution == 1; });
}

// Under Poisson's law, and under every law without friction, no impact increases the energy (docs/spec/impulse.md).
Finding energy(const Scene& scene, Subject& subject) {
  return of_trajectory(scene, subject, [&](const TrajectoryCase& asked) {
    const bool law_loses = scene.motion->law == Law::poisson || frictionless(scene);
    if (!law_loses || !scene.motion->forces.empty() || !fixed_bodies_rest(scene) || !start_at_once(scene)) {
      return judge::outside("a law, a force or a fixed body that may add energy");
    }
    return energy_between_samples(asked, false);
  });
}

Finding elastic_energy(const Scene& scene, Subject& subject) {
  return of_trajectory(scene, subject, [&](const TrajectoryCase& asked) {
    if (!elastic(scene) || !frictionless(scene)) return judge::outside("impacts that lose energy");
    if (!scene.motion->forces.empty() || !fixed_bodies_rest(scene) || !start_at_once(scene)) {
      return judge::outside("a force or a fixed body that may add energy");
    }
    return energy_between_samples(asked, true);
  });
}

/// A level table that pushes straight up, and what bounds the bodies on it.
struct Ice {
  Real energy = 0;            ///< J: the most that all free bodies ever have, above the table's top
  Real until = 0;             ///< s, from the start: before that no body comes half-way to the edge
  Real to_edge = 0;           ///< m: so far are all from the edge until then
  std::vector<Real> momenta;  ///< kg m/s: no body ever has more
};

bool is_level(const Body& body) {
  const Quaternion& q = body.X_WB.q_WB;
  return std::holds_alternative<Box>(body.shape) && q.x == 0 && q.y == 0 && q.z == 0;
}

// While all bodies are over the top of the table, nothing pushes them but its top, up, and gravity, down. A body over
// the top has no less potential energy than at the top, so by its kinetic energy it is never faster than √(2E/m). A
// force gives it F v, so √E grows no faster than F/√(2m).
std::optional<Ice> ice_of(const Scene& scene, const std::vector<ImpactBody>& first) {
  const auto table = std::ranges::find_if(scene.bodies, is_fixed);
  const bool one = table != scene.bodies.end() && std::ranges::count_if(scene.bodies, is_fixed) == 1;
  const bool pulls_down = scene.gravity.x() == 0 && scene.gravity.y() == 0 && scene.gravity.z() <= 0;
  if (!one || !is_level(*table) || table->velocity != Velocity{} || !pulls_down) return std::nullopt;
  const Vec3& half = std::get<Box>(table->shape).half_extents;
  const Real top = table->X_WB.p_WB.z() + half.z(), g = -scene.gravity.z();
  Ice ice;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i].fixed) continue;
    if (std::min(scene.bodies[i].material.friction, table->material.friction) > 0) return std::nullopt;
    const Real height = -first[i].p_BcmC_W.z() - top + envelope(scene);
    if (height <= 0) return std::nullopt;
    ice.energy += first[i].mass * (first[i].v_WBcm.squaredNorm() / 2 + g * height) +
                  first[i].spin_energy_twice(first[i].w_WB) / 2;
  }
  const AppliedImpulse applied = applied_until(scene, end_of(scene));
  Real root = std::sqrt(ice.energy);
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (!first[i].fixed) root += applied.of_bodies[i] / std::sqrt(2 * first[i].mass);
  }
  ice.energy = root * root;
  ice.until = ice.to_edge = std::numeric_limits<Real>::infinity();
  ice.momenta.resize(first.size(), 0);
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i].fixed) continue;
    const Real reach = tolerance::radius(scene.bodies[i]) + first[i].p_BBcm.norm();
    const Point off = -first[i].p_BcmC_W - table->X_WB.p_WB.cast<Real>();
    const Real way = std::min(half.x() - std::abs(off.x()), half.y() - std::abs(off.y())) - reach;
    if (way <= 0) return std::nullopt;
    ice.momenta[i] = std::sqrt(2 * ice.energy * first[i].mass);
    ice.to_edge = std::min(ice.to_edge, way / 2);
    if (ice.energy > 0) ice.until = std::min(ice.until, way / 2 * first[i].mass / ice.momenta[i]);
  }
  return ice;
}

// 1: by how much of its impulses the table may push sideways. A plane that separates a body on its top from it within ε
// is tilted by no more than ε over the way to the edge. A time-stepper lets bodies overlap, and a computed normal may
// be off by tolerance::normal, which is never more than 2⁻¹⁰. A subject that reports events finds them within ε; what
// it leaves of the conditions of a contact that it solves in steps is not known, so 2⁻³⁰ are granted, a choice.
Real sideways(const TrajectoryCase& asked, const Ice& ice) {
  if (asked.stepping || !asked.said.events) return 0x1p-10L;
  const Real rounding =
      tolerance::accumulated(changes(asked), asked.scene.bodies.size()) * oracle::unit_roundoff(asked.precision);
  return std::min(0x1p-10L, envelope(asked.scene) / ice.to_edge + 0x1p-30L + rounding);
}

// The same of moments. Bodies that turn about all axes in steps lose more of them than of their momentum: a choice.
Real share_of_moments(const TrajectoryCase& asked, Real of_impulses) {
  return asked.stepping || !asked.said.events ? of_impulses : std::max(of_impulses, 0x1p-16L);
}

// What a table without friction does to the bodies on it, up to a time: its impulses add up to those of gravity and of
// the applied forces and to the momenta that they stop and give.
Sum<Real> pressed(const Scene& scene, const std::vector<ImpactBody>& first, const Ice& ice,
                  const AppliedImpulse& applied, Real seconds) {
  Sum<Real> sum{0};  // N s and, about the vertical through the origin, N m s
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i].fixed) continue;
    const Real impulse = 2 * ice.momenta[i] - scene.gravity.z() * first[i].mass * seconds + applied.of_bodies[i];
    const Real arm = first[i].p_BcmC_W.norm() + seconds * ice.momenta[i] / first[i].mass +
                     tolerance::radius(scene.bodies[i]) + first[i].p_BBcm.norm();
    sum.value += impulse;
    sum.size += impulse * arm;
  }
  return sum;
}

// A level table without friction pushes straight up, and gravity pulls straight down: what bodies do to each other
// there changes neither their horizontal momentum nor their angular momentum about the vertical. Applied forces change
// the one by their impulses; the other depends on where the bodies were.
Finding level_momentum(const Scene& given, Subject& subject) {
  const Scene scene = with_whole_tables(given);
  return of_trajectory(given, subject, [&](const TrajectoryCase& asked) {
    const bool law_loses = scene.motion->law == Law::poisson || frictionless(scene);
    const bool pushed = !scene.motion->forces.empty();
    if (!law_loses || !start_at_once(scene) || (pushed && !scene.motion->start_times.empty())) {
      return judge::outside("a law that may add energy, or bodies that start one after the other");
    }
    const std::vector<ImpactBody> first = bodies_at(scene, first_states(scene));
    const std::optional<Ice> ice = ice_of(scene, first);
    if (!ice) return judge::outside("not a level table without friction under all bodies");
    const auto level = [](const std::vector<ImpactBody>& bodies) {
      std::vector<ImpactBody> free = bodies;
      std::erase_if(free, [](const ImpactBody& body) { return body.fixed; });
      Point sum = momentum_of(free).value;
      sum.z() = angular_momentum_of(free).value.z();
      return sum;
    };
    const Point before = level(first);
    Finding worst = judge::outside("no sample before a body may reach the edge");
    for (std::size_t sample = 0; sample < asked.samples(); ++sample) {
      const Real seconds = asked.time(sample) - start_of_all(scene);
      if (seconds >= ice->until) break;
      const std::vector<ImpactBody> bodies = bodies_at(scene, asked.said.states[sample]);
      const Point now = level(bodies);
      const AppliedImpulse applied = applied_until(scene, asked.time(sample));
      const Sum<Real> most = pressed(scene, first, *ice, applied, seconds);
      const Point expected = before + Point(applied.total.x(), applied.total.y(), 0);
      const Real turned = 2 * pose_error(asked, bodies);
      const auto judged = [&](Real error, Real size, Real off, Real more, const char* name) {
        const double unit = std::max(static_cast<double>(size), 0x1p-900);
        return counted(off * 256 < 1,
                       judge::at_most(
                           static_cast<double>(error), {static_cast<double>(off * size + more), unit, name, 0, 0},
                           Defect::wrong_momentum, [&] { return oracle::words::text(Vec3(now.cast<double>())); },
                           [&] {
                             return oracle::words::text(Vec3(expected.cast<double>())) +
                                    (pushed ? ", by the applied forces" : ", as at the start");
                           }));
      };
      const Real share = sideways(asked, *ice) + turned;
      if (worse(worst, judged((now - expected).head<2>().norm(), most.value, share, late(asked, applied),
                              "impulses of the table")))
        return worst;
      if (!pushed && worse(worst, judged(std::abs(now.z() - before.z()), most.size, share_of_moments(asked, share), 0,
                                         "moments of the table's impulses"))) {
        return worst;
      }
    }
    return worst;
  });
}

/// Does rounding leave every pair's contact decided until the end? Where it may move a pair by a thousandth of a body,
/// doubles cannot decide whether the pair touches.
bool contacts_decided(const TrajectoryCase& asked) {
  const std::vector<Body>& bodies = asked.scene.bodies;
  const double end = asked.scene.motion->sample_times.back();
  const auto segment = [&](std::size_t k) {
    const std::vector<double>& starts = asked.scene.motion->start_times;
    return Segment{k, starts.empty() ? 0 : starts[k], end, {bodies[k].X_WB, bodies[k].velocity}, true};
  };
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies.size(); ++j) {
      const Scene pair = segment_scene(asked.scene, {segment(i), segment(j)}, end);
      if (!is_decisive(pair, tolerance::moving_distance(pair, end, asked.precision))) return false;
    }
  }
  return true;
}

// Elastic bodies without gravity have finitely many impacts.
Finding whole(const Scene& scene, Subject& subject) {
  return of_trajectory(scene, subject, [&](const TrajectoryCase& asked) {
    if (!elastic(scene) || !scene.gravity.isZero(0) || !scene.motion->forces.empty()) {
      return judge::outside("impacts may accumulate");
    }
    if (!asked.said.complete_until) return judge::holds();
    if (!contacts_decided(asked)) return judge::outside(too_far_to_decide);
    return judge::wrong(
        Defect::inconsistent, "the trajectory is complete until " + oracle::words::text(asked.end) + " s",
        "the trajectory is complete until " + oracle::words::text(scene.motion->sample_times.back()) + " s");
  });
}

Finding survives_any(const Scene& scene, Subject& subject) {
  if (!scene.motion) return judge::outside("no motion");
  return survives<Trajectory>(&Subject::simulation, scene, subject,
                              [&](const Trajectory& said) { return fault_in_form(scene, said); });
}

Finding repeats_itself(const Scene& scene, Subject& subject) {
  if (!scene.motion) return judge::outside("no motion");
  Scene another = scene;
  std::erase_if(another.motion->sample_times, [&](double t) { return t > scene.motion->sample_times.front(); });
  for (Body& body : another.bodies) body.velocity.v_WBcm *= 0.5;
  return repeats<Trajectory>(&Subject::simulation, scene, another, subject);
}

}  // namespace

std::vector<Property> simulation_law_properties() {
  const std::string query = "simulation", clause = "TS-SIMULATION-";
  return {
      {"simulation.momentum",
       query,
       {clause + "8"},
       "without applied forces and fixed bodies, only gravity changes the momentum",
       momentum},
      {"simulation.angular_momentum",
       query,
       {clause + "9"},
       "without gravity, applied forces and fixed bodies, angular momentum is conserved",
       angular_momentum},
      {"simulation.energy", query, {clause + "10"}, "energy never rises", energy},
      {"simulation.elastic_energy",
       query,
       {clause + "11"},
       "elastic impacts without friction conserve energy",
       elastic_energy},
      {"simulation.whole",
       query,
       {clause + "12"},
       "a simulation of elastic bodies without gravity reaches its end",
       whole},
      {"simulation.level_momentum",
       query,
       {clause + "33"},
       "on a level table without friction, horizontal momentum is conserved, and angular momentum about the vertical",
       level_momentum},
      {"simulation.survives",
       query,
       {clause + "20"},
       "every valid scene has an answer that is finite and consistent",
       survives_any},
      {"simulation.repeats", query, {clause + "21"}, "the same query has the same answer, bit for bit", repeats_itself},
  };
}

}  // namespace touchstone::properties
