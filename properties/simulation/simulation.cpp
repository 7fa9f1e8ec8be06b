// The clauses of docs/spec/simulation.md about the segments and events of one trajectory as executable properties.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "model/limits.h"
#include "oracle/judge/words.h"
#include "oracle/tolerance/motion.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/motion_in_doubles.h"
#include "oracle/truth/truth.h"
#include "properties/cases/impact_case.h"
#include "properties/cases/overlap_along.h"
#include "properties/cases/simultaneous_impacts.h"
#include "properties/cases/time_of_impact_case.h"
#include "properties/cases/trajectory_case.h"
#include "properties/queries.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Outcome;
using oracle::Subject;
namespace judge = oracle::judge;
namespace tolerance = oracle::tolerance;
namespace truth = oracle::truth;
using Kind = Event::Kind;

bool is_struck(const Event& event) { return event.kind == Kind::impact || event.kind == Kind::micro_collision; }

Finding ordered(const Scene& scene, Subject& subject) {
  if (!scene.motion) return judge::outside("no motion");
  return judge::given(subject.simulation(scene), [&](const Trajectory& said) {
    const std::string fault = fault_in_form(scene, said);
    return fault.empty() ? judge::holds() : judge::wrong(Defect::inconsistent, fault, "a trajectory");
  });
}

// Judges each sample that falls into a ballistic segment. A sample at an event's own time is not judged: both the state
// before the event and the one after it are correct there.
Finding ballistic_segments(const Scene& scene, Subject& subject) {
  return of_timeline(scene, subject, [&](const TrajectoryCase& asked, const Timeline& timeline) {
    Finding worst = judge::outside("no sample in ballistic motion");
    for (const std::vector<Segment>& segments : timeline) {
      for (const Segment& segment : segments) {
        for (std::size_t sample = 0; sample < asked.samples(); ++sample) {
          const double time = asked.time(sample);
          const bool inside = time > segment.from && (time < segment.until || &segment == &segments.back());
          if (!segment.ballistic || !inside) continue;
          const Scene alone = segment_scene(scene, {segment}, time);
          if (worse(worst, check_state(asked, alone, 0, time, asked.said.states[sample][segment.body]))) return worst;
        }
      }
    }
    return worst;
  });
}

// An impact changes no pose. A change of an applied force changes neither pose nor velocity. A fixed body keeps its own
// motion.
Finding event_states(const Scene& scene, Subject& subject) {
  return of_timeline(scene, subject, [&](const TrajectoryCase& asked, const Timeline& timeline) {
    Finding worst = judge::outside("no event in ballistic motion");
    for (std::size_t e = 0; e < asked.events(); ++e) {
      const Event& event = (*asked.said.events)[e];
      if (!is_struck(event) && event.kind != Kind::force) continue;
      const std::vector<Segment> segments = segments_into(timeline, asked.said, e);
      const Scene few = segment_scene(scene, segments, event.time);
      for (std::size_t k = 0; k < segments.size(); ++k) {
        if (!segments[k].ballistic) continue;
        const State& said = k == 0 ? event.after_a : event.after_b;
        const bool moves_on = event.kind == Kind::force || asked.is_fixed(segments[k].body);
        const Finding finding =
            moves_on ? check_state(asked, few, k, event.time, said) : check_pose(asked, few, k, event.time, said.X_WB);
        if (worse(worst, finding)) return worst;
      }
    }
    return worst;
  });
}

/// Calls judge_it(pair's scene, segment of a, segment of b) for each pair of ballistic segments of two bodies that have
/// time in common. Keeps the worst finding. Returns true on a failure, which ends the search.
template <class JudgeIt>
bool of_segments_together(const Scene& scene, const std::vector<Segment>& of_a, const std::vector<Segment>& of_b,
                          Finding& worst, JudgeIt&& judge_it) {
  for (std::size_t i = 0, j = 0; i < of_a.size() && j < of_b.size();) {
    const Segment &a = of_a[i], &b = of_b[j];
    const double from = std::max(a.from, b.from), until = std::min(a.until, b.until);
    if (a.ballistic && b.ballistic && from < until && worse(worst, judge_it(segment_scene(scene, {a, b}, until), a, b)))
      return true;
    ++(a.until < b.until ? i : j);
  }
  return false;
}

/// The same for all pairs of which at least one body is not fixed.
template <class JudgeIt>
Finding of_pairs_in_motion(const TrajectoryCase& asked, const Timeline& timeline, JudgeIt&& judge_it) {
  Finding worst = judge::outside("no two bodies in ballistic motion at one time");
  for (std::size_t i = 0; i < timeline.size(); ++i) {
    for (std::size_t j = i + 1; j < timeline.size(); ++j) {
      if (asked.is_fixed(i) && asked.is_fixed(j)) continue;
      if (of_segments_together(asked.scene, timeline[i], timeline[j], worst, judge_it)) return worst;
    }
  }
  return worst;
}

bool stay_apart(const Scene& pair, double until) {
  double reach = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const tolerance::BallisticBound bound = tolerance::ballistic(pair, k, until, oracle::Precision::binary64);
    reach += tolerance::radius(pair.bodies[k]) + bound.fastest * (until - pair.motion->start_times[k]);
  }
  return (pair.bodies[0].X_WB.p_WB - pair.bodies[1].X_WB.p_WB).norm() > 1.01 * reach;
}

/// m: by how much a pair that was in contact up to a time may still overlap there, as contacts may that last; 0 for
/// others.
double left_by_contact(const TrajectoryCase& asked, std::size_t a, std::size_t b, double time) {
  const auto is_of_pair = [&](const Event& event) {
    return event.kind == Kind::release && event.time == time && event.a == static_cast<int>(a) &&
           event.b == static_cast<int>(b);
  };
  return std::ranges::any_of(*asked.said.events, is_of_pair) ? 2 * envelope(asked.scene) : 0;
}

/// m: the deepest overlap at the end of a time, at its half, its quarter and so on.
double deepest_of_halves(const Scene& pair, double from, double until) {
  double deepest = 0;
  for (int halvings = 0; halvings < 16; ++halvings)
    deepest = std::max(deepest, judge::overlap(oracle::pair_at(pair, from + std::ldexp(until - from, -halvings))));
  return deepest;
}

// Two bodies in ballistic motion do not overlap deeper than rounding explains, up to the next event of either; after a
// contact, no deeper than it left them.
Finding none_missed(const Scene& scene, Subject& subject) {
  return of_timeline(scene, subject, [&](const TrajectoryCase& asked, const Timeline& timeline) {
    return of_pairs_in_motion(asked, timeline, [&](const Scene& pair, const Segment& a, const Segment& b) {
      const double from = std::max(a.from, b.from), until = std::min(a.until, b.until);
      if (stay_apart(pair, until)) return judge::holds();
      const double slack = tolerance::moving_distance(pair, until, asked.precision);
      const auto overlap = [&](double depth, double allowed) {
        return counted(is_decisive(pair, allowed),
                       judge::at_most(
                           depth, in_ulps_of_place(asked, allowed), Defect::missed,
                           [&] { return "no impact of the pair until " + oracle::words::text(until) + " s"; },
                           [&] { return std::string("an impact before the bodies overlap"); }));
      };
      const Scene at_first = oracle::pair_at(pair, from);
      if (truth::distance(at_first).verdict == Verdict::overlapping) {
        const double depth = judge::overlap(at_first), left = left_by_contact(asked, a.body, b.body, from);
        if (left == 0 || depth > left + slack) return overlap(depth, slack);
        return overlap(deepest_of_halves(pair, from, until), slack + depth);
      }
      const std::optional<MotionCase> pair_case = motion_case(pair, asked.precision);
      return overlap(pair_case ? -pair_case->deepest(until) : 0, slack);
    });
  });
}

/// For poses accurate to `slack` (m): the two bodies are within the envelope, C is within the envelope of both, the
/// normal is a unit vector and, if both bodies are convex, a plane with this normal separates them.
Finding in_contact(const TrajectoryCase& asked, const Event& event, const Scene& there, double slack) {
  const double near = envelope(asked.scene) + slack, apart = truth::distance(there).distance.hi;
  const auto within = [&](double off, double allowed, Defect defect, const char* law) {
    return judge::at_most(
        off, in_ulps_of_place(asked, allowed), defect, [&] { return text(event); }, [law] { return std::string(law); });
  };
  Finding worst;
  if (worse(worst, within(apart, near, Defect::phantom, "bodies within the contact tolerance at the impact")))
    return worst;
  for (const Body& body : there.bodies) {
    if (worse(worst, within(judge::off_body(body, event.p_WC), near, Defect::wrong_witness,
                            "contact point C within the contact tolerance of both bodies"))) {
      return worst;
    }
  }
  const Point n = event.nhat_BA_W.cast<Real>();
  if (!tolerance::is_unit(event.nhat_BA_W, asked.precision)) {
    return judge::wrong(Defect::wrong_normal, text(event), "a unit normal");
  }
  const auto convex = [](const Body& body) { return !std::holds_alternative<Compound>(body.shape); };
  if (!std::ranges::all_of(there.bodies, convex)) return worst;
  const double size = tolerance::size(there.bodies[0]) + tolerance::size(there.bodies[1]);
  const double allowed = near + 2 * size * tolerance::normal(there, apart, asked.precision);
  const Real overlap = overlap_along(n, there.bodies[0], there.bodies[1]);
  worse(worst, within(static_cast<double>(std::max<Real>(0, overlap)), allowed, Defect::wrong_normal,
                      "a normal whose plane separates the two bodies"));
  return worst;
}

Scene at_reported_poses(Scene there, const Event& event) {
  there.bodies[0].X_WB = event.after_a.X_WB;
  there.bodies[1].X_WB = event.after_b.X_WB;
  return there;
}

/// m: the error of positions and of the time over a long trajectory, by rounding. It leaves out the error of
/// orientations, since the event reports the poses at which the impact was found.
double rounded_way(Scene pair, double time, oracle::Precision precision) {
  for (Body& body : pair.bodies) body.velocity.w_WB.setZero();
  return tolerance::moving_distance(pair, time, precision);
}

// Checks the contact at the reported poses, and at the poses that ballistic motion predicts where rounding permits it.
Finding contact_of_impact(const TrajectoryCase& asked, const Event& event, const Scene& pair) {
  const Scene there = oracle::pair_at(pair, event.time), reported = at_reported_poses(there, event);
  const double way = rounded_way(pair, event.time, asked.precision);
  Finding worst = counted(is_decisive(pair, way),
                          in_contact(asked, event, reported, tolerance::distance(reported, asked.precision) + way));
  const double slack = tolerance::moving_distance(pair, event.time, asked.precision);
  if (worst.outcome == Outcome::holds) {
    worse(worst, counted(is_decisive(pair, slack), in_contact(asked, event, there, slack)));
  }
  return worst;
}

// A contact that lasts is followed by steps, or in closed form after bounces: its gap may be a second envelope.
Finding contact_that_lasts(const TrajectoryCase& asked, const Event& event, const Scene& pair) {
  const Scene reported = at_reported_poses(pair, event);
  return in_contact(asked, event, reported, envelope(asked.scene) + tolerance::distance(reported, asked.precision));
}

Finding contacts(const Scene& scene, Subject& subject) {
  return of_timeline(scene, subject, [&](const TrajectoryCase& asked, const Timeline& timeline) {
    Finding worst = judge::outside("no impact of bodies in ballistic motion, and no contact that lasts");
    for (std::size_t e = 0; e < asked.events(); ++e) {
      const Event& event = (*asked.said.events)[e];
      const bool lasts = event.kind == Kind::contact || event.kind == Kind::completed;
      if (!lasts && event.kind != Kind::impact) continue;
      const std::vector<Segment> segments = segments_into(timeline, asked.said, e);
      if (!lasts && !std::ranges::all_of(segments, &Segment::ballistic)) continue;
      const Scene pair = segment_scene(scene, segments, event.time);
      if (worse(worst, lasts ? contact_that_lasts(asked, event, pair) : contact_of_impact(asked, event, pair))) break;
    }
    return worst;
  });
}

/// The impact that an event reports, with the velocities at the end of both segments. e and mu are the lesser ones of
/// the two bodies.
Scene impact_of(const Scene& there, const Event& event, Law law) {
  Scene scene = there;
  scene.motion.reset();
  const Material &a = there.bodies[0].material, &b = there.bodies[1].material;
  scene.contact = Contact{event.p_WC, event.nhat_BA_W, law, std::min(a.restitution, b.restitution),
                          std::min(a.friction, b.friction)};
  return scene;
}

Point exact(const reference::ExactVec3& v) {
  return {static_cast<Real>(v[0].nearest()), static_cast<Real>(v[1].nearest()), static_cast<Real>(v[2].nearest())};
}

/// An impulse, with the bodies where the event reports them, and with their velocities before it.
struct ReportedImpulse {
  const TrajectoryCase& asked;
  const Event& event;
  Scene scene;
  oracle::Impact impact;
  double slack;  ///< m: how far C may be from where the two touch, by rounding

  ReportedImpulse(const TrajectoryCase& of, const Event& reported, const Scene& pair)
      : asked(of),
        event(reported),
        scene(impact_of(at_reported_poses(oracle::pair_at(pair, event.time), event), event, pair.motion->law)),
        impact(oracle::impact(scene)),
        slack(tolerance::distance(scene, asked.precision) + rounded_way(pair, event.time, asked.precision)) {}

  // m: how far C is from the surface of each body, at most `slack`. Where the two overlap, C may be as deep as they
  // are.
  std::array<double, 2> gaps() const {
    const double deep = truth::distance(scene).verdict == Verdict::overlapping ? judge::margin(scene).hi : 0;
    std::array<double, 2> both{};
    for (std::size_t k = 0; k < 2; ++k) {
      both[k] = std::min(slack, std::max(judge::off_body(scene.bodies[k], event.p_WC), deep));
    }
    return both;
  }

  Finding compare(const Point& said, const Point& expected, Real allowed, Real unit, const char* name) const {
    const Real u = oracle::unit_roundoff(asked.precision);
    return judge::at_most(
        static_cast<double>((said - expected).norm()),
        {static_cast<double>(allowed), static_cast<double>(u * std::max<Real>(unit, 0x1p-900L)), "ulps of the impulse",
         0, static_cast<double>(unit)},
        Defect::wrong_momentum, [&] { return text(event) + ": " + name + " = " + text(said); },
        [&] { return text(expected); });
  }

  /// Judges m (v' − v) = P and I (w' − w) = r × P for body `side` (0: A, 1: B). `flown` bounds the errors of the
  /// velocities before; P is rounded once more, since the event reports it.
  Finding judged(std::size_t side, const tolerance::BallisticBound& flown) const {
    const std::array<Velocity, 2> after = {event.after_a.velocity, event.after_b.velocity};
    const oracle::ImpactBody& body = impact.bodies[side];
    const Point P = (side == 0 ? 1 : -1) * event.P_A_W.cast<Real>(), torque = body.p_BcmC_W.cross(P);
    const Point gained = body.mass * (after[side].v_WBcm.cast<Real>() - body.v_WBcm);
    const Point turned = body.angular_momentum(after[side].w_WB.cast<Real>() - body.w_WB);
    const Real u = oracle::unit_roundoff(asked.precision), force = P.norm(), arm = body.p_BcmC_W.norm();
    Finding worst = compare(gained, P,
                            tolerance::momentum(scene, impact, after, force, asked.precision) + 2 * u * force +
                                body.mass * static_cast<Real>(flown.velocity),
                            force, "m Δv");
    if (worst.outcome == Outcome::fails) return worst;
    worse(worst, compare(turned, torque,
                         tolerance::angular_momentum(scene, impact, side, after[side], force, asked.precision) +
                             (2 * u * arm + static_cast<Real>(slack)) * force +
                             body.moments[2] * static_cast<Real>(flown.spin),
                         arm * force, "I Δω"));
    return worst;
  }
};

/// What the law says of a reported impulse; none where the law is in doubt.
struct LawfulImpact {
  After after;
  Point P_A_W = Point::Zero();
};

std::optional<LawfulImpact> lawful(const Scene& question) {
  const reference::ImpulseTruth& law = truth::impulse(question);
  if (law.ambiguous) return std::nullopt;
  LawfulImpact it;
  for (std::size_t k = 0; k < 2; ++k) it.after[k] = {exact(law.after[k].v_WBcm), exact(law.after[k].w_WB)};
  it.P_A_W = exact(law.P_A_W);
  return it;
}

// √J: the difference of P as the change of u that it causes.
Real difference(const ImpactCase& impact, const Point& P, const Point& Q) {
  const Point dP = P - Q;
  return std::sqrt(std::max<Real>(0, dP.dot(impact.impact.K * dP)));
}

// √J: how much the law's answer changes if each lever arm ends on its body's surface instead of at C, along the normal.
// A body that is moved by a thousandth of its size has such an arm, and shows the slope: a shift of the gap itself
// could be lost in the rounding of positions. The factor 2 covers what is not linear in it. None where the law of the
// moved bodies is in doubt.
std::optional<double> effect_of_gaps(const ImpactCase& impact, const LawfulImpact& law,
                                     const std::array<double, 2>& gaps) {
  Real sum = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    Scene moved = impact.scene;
    const double shift = tolerance::size(moved.bodies[k]) / 1024;
    moved.bodies[k].X_WB.p_WB += (k == 0 ? -shift : shift) * impact.contact.nhat_BA_W;
    const std::optional<LawfulImpact> there = lawful(moved);
    if (!there) return std::nullopt;
    const Real change =
        std::max(difference(impact, there->after, law.after), difference(impact, there->P_A_W, law.P_A_W));
    sum += 2 * change * gaps[k] / shift;
  }
  return static_cast<double>(sum);
}

Finding impulses(const Scene& scene, Subject& subject) {
  return of_impacts(
      scene, subject,
      [&](const TrajectoryCase& asked, const Event& event, const std::vector<Segment>& segments, bool together) {
        if (together) return judge::outside(together_with_others);
        const Scene pair = segment_scene(scene, segments, event.time);
        if (!is_decisive(pair, tolerance::moving_distance(pair, event.time, asked.precision))) {
          return judge::outside(too_far_to_decide);
        }
        const ReportedImpulse reported(asked, event, pair);
        const ImpactCase impact(reported.scene, asked.precision);
        const bool in_domain = tolerance::impact_in_range(impact.impact, asked.precision) &&
                               tolerance::impact_is_sure(impact.impact, asked.precision);
        if (!in_domain) return judge::outside("rounding may change the kind of impact");
        const Impulse answer{{event.after_a.velocity, event.after_b.velocity}, event.P_A_W, {}, {}};
        const SaidImpact said(impact, answer);
        const std::array<tolerance::BallisticBound, 2> before = {
            tolerance::ballistic(pair, 0, event.time, asked.precision),
            tolerance::ballistic(pair, 1, event.time, asked.precision)};
        const double u = oracle::unit_roundoff(asked.precision), stored = u * event.p_WC.norm();
        const std::array<double, 2> gaps = reported.gaps();
        // The error of the subject's states; as much for the judge's states, and again for the rounding of v + w × r.
        const double speed = 4 * tolerance::at_contact(impact.impact, before, {gaps[0] + stored, gaps[1] + stored});
        Finding worst = judge::at_most(
            std::max(0.0, static_cast<double>(impact.impact.u_n())), {speed, speed, "errors of the trajectory"},
            Defect::phantom, [&] { return text(event); },
            [] { return std::string("an impact of bodies that approach"); });
        if (worst.outcome == Outcome::fails) return worst;
        const std::optional<LawfulImpact> law = lawful(reported.scene);
        if (!law || impact.law_jumps()) return worst;
        const std::optional<double> of_gaps = effect_of_gaps(impact, *law, gaps);
        if (!of_gaps) return worst;
        const double flown = tolerance::through_impact(reported.scene, impact.impact, before, {stored, stored});
        const double allowed = said.allowed + flown + *of_gaps;
        worse(worst, judge::at_most(
                         static_cast<double>(difference(impact, said.after, law->after)), of_energy(impact, allowed),
                         Defect::wrong_velocity, [&] { return text(event) + ": " + text(said.after); },
                         [&] { return text(law->after); }));
        const double rounded = u * event.P_A_W.norm() * static_cast<double>(std::sqrt(impact.impact.K.trace()));
        worse(worst, judge::at_most(
                         static_cast<double>(difference(impact, event.P_A_W.cast<Real>(), law->P_A_W)),
                         of_energy(impact, allowed + rounded), Defect::inconsistent,
                         [&] { return text(event) + ": P = " + text(Point(event.P_A_W.cast<Real>())); },
                         [&] { return text(law->P_A_W); }));
        return counted(2 * allowed < static_cast<double>(impact.impact.energy_norm(impact.impact.u)), worst);
      });
}

// Also where the law of impact itself is in doubt, and for a body that strikes one that is not in ballistic motion.
Finding impulses_apply(const Scene& scene, Subject& subject) {
  return of_timeline(scene, subject, [&](const TrajectoryCase& asked, const Timeline& timeline) {
    Finding worst = judge::outside("no impulse on a body in ballistic motion");
    for (std::size_t e = 0; e < asked.events(); ++e) {
      const Event& event = (*asked.said.events)[e];
      if (!is_struck(event)) continue;
      const std::vector<Segment> segments = segments_into(timeline, asked.said, e);
      const ReportedImpulse impulse(asked, event, segment_scene(scene, segments, event.time));
      if (!tolerance::impact_in_range(impulse.impact, asked.precision)) continue;
      for (std::size_t side = 0; side < 2; ++side) {
        if (!segments[side].ballistic || asked.is_fixed(segments[side].body)) continue;
        const Scene alone = segment_scene(scene, {segments[side]}, event.time);
        const tolerance::BallisticBound flown = allowance(alone, 0, event.time, asked.precision);
        const bool decisive = is_decisive(alone.bodies[0], flown.place + impulse.slack);
        if (worse(worst, counted(decisive, impulse.judged(side, flown)))) return worst;
      }
    }
    return worst;
  });
}

bool spheres_apart(const Body& a, const State& at, const Body& b, const State& bt) {
  const double reach = tolerance::radius(a) + tolerance::radius(b);
  return (at.X_WB.p_WB - bt.X_WB.p_WB).norm() > 1.01 * reach;
}

// No sample shows two bodies that overlap deeper than the envelope.
Finding solid(const Scene& scene, Subject& subject) {
  return of_trajectory(scene, subject, [&](const TrajectoryCase& asked) {
    Finding worst = asked.samples() > 0 ? judge::holds() : judge::outside("no sample");
    for (std::size_t sample = 0; sample < asked.samples(); ++sample) {
      const std::vector<State>& states = asked.said.states[sample];
      for (std::size_t i = 0; i < states.size(); ++i) {
        for (std::size_t j = i + 1; j < states.size(); ++j) {
          const double time = asked.time(sample);
          const bool fixed = asked.is_fixed(i) && asked.is_fixed(j);
          if (fixed || !asked.has_started(i, time) || !asked.has_started(j, time)) continue;
          if (spheres_apart(scene.bodies[i], states[i], scene.bodies[j], states[j])) continue;
          const Scene pair = posed_pair(scene, i, states[i].X_WB, j, states[j].X_WB);
          const double deep = judge::overlap(pair);
          const double way = asked.stepping ? tolerance::way_of_step(scene, asked.stepping->step) : 0;
          const double allowed =
              envelope(scene) + tolerance::distance(pair, asked.precision) + way + asked.distances.of(deep);
          const auto seen = [&] {
            return "bodies " + std::to_string(i) + " and " + std::to_string(j) + " overlap at " +
                   oracle::words::text(asked.time(sample)) + " s";
          };
          if (worse(worst, judge::at_most(deep, in_ulps_of_place(asked, allowed), Defect::overdeep, seen, [] {
                      return std::string("no overlap deeper than the contact tolerance");
                    }))) {
            return worst;
          }
        }
      }
    }
    return worst;
  });
}

}  // namespace

std::vector<Property> simulation_properties() {
  const std::string query = "simulation", clause = "TS-SIMULATION-";
  return {
      {"simulation.ordered",
       query,
       {clause + "1"},
       "each sample has a state for each body, and the events are in order",
       ordered},
      {"simulation.flights",
       query,
       {clause + "2"},
       "between events each body follows its ballistic trajectory",
       ballistic_segments},
      {"simulation.event_states", query, {clause + "3"}, "an event changes no pose", event_states},
      {"simulation.none_missed", query, {clause + "4"}, "an impact is reported before two bodies overlap", none_missed},
      {"simulation.contacts",
       query,
       {clause + "5"},
       "at an impact, and where a contact begins, the bodies touch, and point and normal are right",
       contacts},
      {"simulation.impulses",
       query,
       {clause + "6"},
       "an impact changes the velocities as the impact law says",
       impulses},
      {"simulation.impulses_apply",
       query,
       {clause + "25"},
       "each impulse changes a body's velocities as Newton and Euler say",
       impulses_apply},
      {"simulation.solid",
       query,
       {clause + "7"},
       "in no sample do bodies overlap deeper than the contact tolerance",
       solid},
  };
}

}  // namespace touchstone::properties
