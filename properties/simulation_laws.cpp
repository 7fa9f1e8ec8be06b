// docs/spec/simulation.md, as sentences that run: what holds of a whole run, whatever happens on its way.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "model/limits.h"
#include "oracle/impact.h"
#include "oracle/tolerance.h"
#include "oracle/tolerance_motion.h"
#include "oracle/words.h"
#include "properties/flight_case.h"
#include "properties/stems.h"
#include "properties/trajectory_case.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Matrix;
using oracle::Point;
using oracle::Real;
using oracle::Struck;
using oracle::Subject;
namespace judge = oracle::judge;
namespace tolerance = oracle::tolerance;

/// A sum over bodies, and the sizes that its rounding is measured by.
template <class Value>
struct Sum {
  Value value;
  Real size = 0;
};

/// The bodies of a scene as they move at one look.
std::vector<Struck> bodies_at(const Scene& scene, const std::vector<State>& states) {
  Scene there = scene;
  std::vector<Struck> bodies;
  for (std::size_t i = 0; i < states.size(); ++i) {
    there.bodies[i].X_WB = states[i].X_WB;
    there.bodies[i].velocity = states[i].velocity;
  }
  for (std::size_t i = 0; i < states.size(); ++i) bodies.push_back(oracle::struck(there, i, Vec3::Zero()));
  return bodies;
}

std::vector<State> first_states(const Scene& scene) {
  std::vector<State> states;
  for (const Body& body : scene.bodies) states.push_back({body.X_WB, body.velocity});
  return states;
}

bool start_at_once(const Scene& scene) {
  const std::vector<double>& since = scene.flight->since;
  return std::ranges::all_of(since, [&](double t) { return t == since.front(); });
}

double start_of_all(const Scene& scene) { return scene.flight->since.empty() ? 0 : scene.flight->since.front(); }

bool any_fixed(const Scene& scene) {
  return std::ranges::any_of(scene.bodies, [](const Body& b) { return std::holds_alternative<Fixed>(b.mass); });
}

bool fixed_rest(const Scene& scene) {
  return std::ranges::all_of(
      scene.bodies, [](const Body& b) { return !std::holds_alternative<Fixed>(b.mass) || b.velocity == Velocity{}; });
}

std::size_t changes(const TrajectoryCase& asked) {
  return asked.said.events ? asked.said.events->size() : tolerance::steps;
}

/// What a sum of such a size may be off by.
judge::Allowance of_sum(const TrajectoryCase& asked, Real size, const char* name) {
  const double u = oracle::unit_roundoff(asked.precision), unit = u * std::max(static_cast<double>(size), 0x1p-900);
  return {tolerance::gathered(changes(asked), asked.scene.bodies.size()) * unit, unit, name};
}

/// 1: of a body's mass, as the subject computes it.
Real mass_error(const TrajectoryCase& asked, std::size_t i, const Struck& body) {
  return tolerance::mass(asked.scene.bodies[i], asked.precision).mass / body.mass;
}

Sum<Point> momentum_of(const std::vector<Struck>& bodies) {
  Sum<Point> sum{Point::Zero()};
  for (const Struck& body : bodies) {
    sum.value += body.mass * body.v_WBcm;
    sum.size += body.mass * body.v_WBcm.norm();
  }
  return sum;
}

// What bodies alone have, they keep; gravity gives to each what it gives to all.
Finding momentum(const Scene& scene, Subject& subject) {
  return of_trajectory(scene, subject, [&](const TrajectoryCase& asked) {
    if (any_fixed(scene) || !scene.flight->pushes.empty() || !start_at_once(scene)) {
      return judge::outside("a fixed body or a push takes and gives momentum");
    }
    const std::vector<Struck> first = bodies_at(scene, first_states(scene));
    const Sum<Point> before = momentum_of(first);
    Real mass = 0, off = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
      mass += first[i].mass;
      off = std::max(off, mass_error(asked, i, first[i]));
    }
    Finding worst = judge::outside("no look");
    for (std::size_t look = 0; look < asked.looks(); ++look) {
      const Real seconds = asked.time(look) - start_of_all(scene);
      const Sum<Point> now = momentum_of(bodies_at(scene, asked.said.states[look]));
      const Point given = mass * seconds * scene.gravity.cast<Real>();
      const Point expected = before.value + given;
      const Real size = before.size + now.size + given.norm();
      judge::Allowance allowed = of_sum(asked, size, "ulps of the momenta");
      allowed.bound += 2 * static_cast<double>(off * size);
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

bool round(const Struck& body) { return body.moments[2] - body.moments[0] <= 0x1p-40L * body.moments[2]; }

// About the world's origin.
Sum<Point> angular_momentum_of(const std::vector<Struck>& bodies) {
  Sum<Point> sum{Point::Zero()};
  for (const Struck& body : bodies) {
    const Point c = -body.p_BcmC_W;  // from W's origin
    sum.value += c.cross(Point(body.mass * body.v_WBcm)) + body.angular_momentum(body.w_WB);
    sum.size += c.norm() * body.mass * body.v_WBcm.norm() + body.moments[2] * body.w_WB.norm();
  }
  return sum;
}

// Of bodies whose moments are equal: then the pose, which flights turn, has no part in it.
Finding angular_momentum(const Scene& scene, Subject& subject) {
  return of_trajectory(scene, subject, [&](const TrajectoryCase& asked) {
    const std::vector<Struck> first = bodies_at(scene, first_states(scene));
    if (any_fixed(scene) || !scene.flight->pushes.empty() || !scene.gravity.isZero(0) || !start_at_once(scene)) {
      return judge::outside("forces or fixed bodies");
    }
    if (!std::ranges::all_of(first, round)) return judge::outside("moments that differ");
    const Sum<Point> before = angular_momentum_of(first);
    Real off = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
      const Real I = tolerance::mass(scene.bodies[i], asked.precision).inertia / first[i].moments[0];
      off = std::max({off, mass_error(asked, i, first[i]), I});
    }
    Finding worst = judge::outside("no look");
    for (std::size_t look = 0; look < asked.looks(); ++look) {
      const Sum<Point> now = angular_momentum_of(bodies_at(scene, asked.said.states[look]));
      judge::Allowance allowed = of_sum(asked, before.size + now.size, "ulps of the angular momenta");
      allowed.bound += 2 * static_cast<double>(off * (before.size + now.size));
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

// Kinetic, and of place in gravity.
Sum<Real> energy_of(const TrajectoryCase& asked, const std::vector<Struck>& bodies) {
  Sum<Real> sum{0};
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Struck& body = bodies[i];
    if (body.fixed) continue;
    const Point c = -body.p_BcmC_W, g = asked.scene.gravity.cast<Real>();
    const Real swing = body.spin_energy_twice(body.w_WB) / 2, push = body.mass * body.v_WBcm.squaredNorm() / 2;
    sum.value += push + swing - body.mass * g.dot(c);
    sum.size += push + swing + body.mass * g.norm() * c.norm();
  }
  return sum;
}

// J, relative: what the masses' errors and the poses' make of an energy. A pose that is off by an angle changes wᵀ I w
// by twice that of I w².
Real pose_error(const TrajectoryCase& asked, const std::vector<Struck>& bodies) {
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

// J: what rests may stand anywhere within the envelope.
Real lift(const TrajectoryCase& asked, const std::vector<Struck>& bodies) {
  Real sum = 0;
  for (const Struck& body : bodies) sum += body.mass;
  return sum * asked.scene.gravity.cast<Real>().norm() * envelope(asked.scene);
}

// From look to look: the gain, and where energy is kept its loss too.
Finding energy_from_look_to_look(const TrajectoryCase& asked, bool kept) {
  std::vector<Struck> bodies = bodies_at(asked.scene, first_states(asked.scene));
  Sum<Real> before = energy_of(asked, bodies);
  Real off = pose_error(asked, bodies);
  const Real lifted = lift(asked, bodies);
  Finding worst = judge::outside("no look");
  for (std::size_t look = 0; look < asked.looks(); ++look) {
    bodies = bodies_at(asked.scene, asked.said.states[look]);
    const Sum<Real> now = energy_of(asked, bodies);
    off = std::max(off, pose_error(asked, bodies));
    const Real gain = now.value - before.value, size = before.size + now.size;
    judge::Allowance allowed = of_sum(asked, size, "ulps of the energies");
    allowed.bound += 2 * static_cast<double>(off * size + lifted);
    const Real error = kept ? std::abs(gain) : std::max<Real>(0, gain);
    const auto told = [](const Sum<Real>& sum) { return oracle::words::text(static_cast<double>(sum.value)) + " J"; };
    if (worse(worst,
              counted(off * 1024 < 1, judge::at_most(
                                          static_cast<double>(error), allowed, Defect::wrong_energy,
                                          [&] { return told(now); }, [&] { return told(before) + ", as before"; })))) {
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

// By Poisson's law, and by all without friction, no impact makes energy (docs/spec/impulse.md).
Finding energy(const Scene& scene, Subject& subject) {
  return of_trajectory(scene, subject, [&](const TrajectoryCase& asked) {
    const bool law_loses = scene.flight->law == Law::poisson || frictionless(scene);
    if (!law_loses || !scene.flight->pushes.empty() || !fixed_rest(scene) || !start_at_once(scene)) {
      return judge::outside("a law, a force or a fixed body that may make energy");
    }
    return energy_from_look_to_look(asked, false);
  });
}

Finding elastic_energy(const Scene& scene, Subject& subject) {
  return of_trajectory(scene, subject, [&](const TrajectoryCase& asked) {
    if (!elastic(scene) || !frictionless(scene)) return judge::outside("impacts that lose energy");
    if (!scene.flight->pushes.empty() || !fixed_rest(scene) || !start_at_once(scene)) {
      return judge::outside("a force or a fixed body that may make energy");
    }
    return energy_from_look_to_look(asked, true);
  });
}

/// Where rounding may move a pair by as much as a thousandth of a body, doubles do not tell whether it meets.
bool places_tell(const TrajectoryCase& asked) {
  const std::vector<Body>& bodies = asked.scene.bodies;
  const double end = asked.scene.flight->times.back();
  const auto leg = [&](std::size_t k) {
    const std::vector<double>& since = asked.scene.flight->since;
    return Leg{k, since.empty() ? 0 : since[k], end, {bodies[k].X_WB, bodies[k].velocity}, true};
  };
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies.size(); ++j) {
      const Scene pair = in_flight(asked.scene, {leg(i), leg(j)}, end);
      if (!tells(pair, tolerance::meeting(pair, end, asked.precision))) return false;
    }
  }
  return true;
}

// Elastic bodies without gravity have so many impacts and no more.
Finding whole(const Scene& scene, Subject& subject) {
  return of_trajectory(scene, subject, [&](const TrajectoryCase& asked) {
    if (!elastic(scene) || !scene.gravity.isZero(0) || !scene.flight->pushes.empty()) {
      return judge::outside("impacts may pile up");
    }
    if (!asked.said.complete_until) return judge::holds();
    if (!places_tell(asked)) return judge::outside(too_far_to_tell);
    return judge::wrong(Defect::inconsistent, "whole until " + oracle::words::text(asked.end) + " s",
                        "whole until " + oracle::words::text(scene.flight->times.back()) + " s");
  });
}

Finding survives_any(const Scene& scene, Subject& subject) {
  if (!scene.flight) return judge::outside("no flight");
  return survives<Trajectory>(&Subject::simulation, scene, subject,
                              [&](const Trajectory& said) { return fault_in_form(scene, said); });
}

Finding repeats_itself(const Scene& scene, Subject& subject) {
  if (!scene.flight) return judge::outside("no flight");
  Scene another = scene;
  std::erase_if(another.flight->times, [&](double t) { return t > scene.flight->times.front(); });
  for (Body& body : another.bodies) body.velocity.v_WBcm *= 0.5;
  return repeats<Trajectory>(&Subject::simulation, scene, another, subject);
}

}  // namespace

std::vector<Property> simulation_law_properties() {
  const std::string stem = "simulation", clause = "TS-SIMULATION-";
  return {
      {"simulation.momentum", stem, {clause + "8"}, "bodies alone keep their momentum", momentum},
      {"simulation.angular_momentum", stem, {clause + "9"}, "and their angular momentum", angular_momentum},
      {"simulation.energy", stem, {clause + "10"}, "energy never rises", energy},
      {"simulation.elastic_energy", stem, {clause + "11"}, "elastic bodies keep it", elastic_energy},
      {"simulation.whole", stem, {clause + "12"}, "elastic bodies without gravity are followed to the end", whole},
      {"simulation.survives", stem, {clause + "20"}, "any valid question ends with sense", survives_any},
      {"simulation.repeats", stem, {clause + "21"}, "the same question, the same answer", repeats_itself},
  };
}

}  // namespace touchstone::properties
