// The clauses of docs/spec/simulation.md about pairs of trajectories, and about scenes with a known trajectory, as
// executable properties.
#include <algorithm>
#include <cmath>

#include "model/infinity.h"
#include "model/limits.h"
#include "oracle/judge/words.h"
#include "oracle/tolerance/motion.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/motion_in_doubles.h"
#include "properties/cases/time_of_impact_case.h"
#include "properties/cases/trajectory_case.h"
#include "properties/cases/whole_tables.h"
#include "properties/judging/pair_laws.h"
#include "properties/queries.h"
#include "properties/transforms/exact_sum.h"
#include "properties/transforms/motion.h"
#include "properties/transforms/scene.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Real;
using oracle::Subject;
using Status = TimeOfImpact::Status;
namespace judge = oracle::judge;
namespace tolerance = oracle::tolerance;
namespace words = oracle::words;

std::vector<Segment> from_the_start(const Scene& scene, std::size_t i, std::size_t j) {
  const auto segment = [&](std::size_t k) {
    const Body& body = scene.bodies[k];
    const double since = scene.motion->start_times.empty() ? 0 : scene.motion->start_times[k];
    return Segment{k, since, end_of(scene), {body.X_WB, body.velocity}, true};
  };
  return {segment(i), segment(j)};
}

/// Calls go_on(const MotionCase&) for every pair of which at least one body is not fixed, in its ballistic motion until
/// the end. Returns false at the first pair for which go_on does, or that overlaps at the start.
template <class GoOn>
bool all_pairs(const Scene& scene, oracle::Precision precision, GoOn&& go_on) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < scene.bodies.size(); ++j) {
      if (is_fixed(scene.bodies[i]) && is_fixed(scene.bodies[j])) continue;
      const Scene pair = segment_scene(scene, from_the_start(scene, i, j), end_of(scene));
      const std::optional<MotionCase> pair_case = motion_case(pair, precision);
      if (!pair_case || !go_on(*pair_case)) return false;
    }
  }
  return true;
}

/// Are the two never as near as the errors that are granted to a stepper?
bool stay_apart(const MotionCase& pair, const TrajectoryCase& asked) {
  if (!asked.stepping) return true;
  double granted = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    granted += tolerance::stepped(pair.scene, k, pair.end, *asked.stepping, asked.precision).place;
  }
  if (!std::isfinite(granted)) return false;
  return oracle::truth::time_of_distance(pair.scene, granted).status == Status::miss;
}

// Bodies that never touch are in ballistic motion throughout, so all their states are known, even without events.
Finding alone(const Scene& scene, Subject& subject) {
  return of_trajectory(scene, subject, [&](const TrajectoryCase& asked) {
    if (!scene.motion->forces.empty()) return judge::outside("applied forces");
    const bool apart = all_pairs(scene, asked.precision, [&](const MotionCase& pair) {
      return pair.truth.status == Status::miss && !pair.earliest() && stay_apart(pair, asked);
    });
    if (!apart) return judge::outside("bodies that may touch");
    if (asked.events() > 0) return judge::wrong(Defect::phantom, text(asked.said.events->front()), "no event");
    Finding worst = judge::outside("no sample");
    for (std::size_t sample = 0; sample < asked.samples(); ++sample) {
      for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const State& said = asked.said.states[sample][i];
        const double time = asked.time(sample);
        if (worse(worst, check_state(asked, scene, i, time, said))) return worst;
      }
    }
    return worst;
  });
}

/// The first impact: its reported time, and the length of the window from the earliest to the latest time that rounding
/// and the envelope permit.
struct FirstImpact {
  double time = 0;    ///< s: as reported
  double window = 0;  ///< s
};

const Event* first_event(const Trajectory& said) {
  return said.events && !said.events->empty() ? &said.events->front() : nullptr;
}

std::optional<FirstImpact> first_impact(const Scene& scene, const Trajectory& said, oracle::Precision precision) {
  const Event* event = first_event(said);
  if (event == nullptr || event->kind != Event::Kind::impact) return std::nullopt;
  const auto segments = from_the_start(scene, static_cast<std::size_t>(event->a), static_cast<std::size_t>(event->b));
  const Scene ballistic_scene = segment_scene(scene, segments, end_of(scene));
  const std::optional<MotionCase> pair = motion_case(ballistic_scene, precision);
  if (!pair || !pair->sure()) return std::nullopt;
  const auto near = oracle::truth::time_of_distance(ballistic_scene, envelope(scene) + pair->slack);
  const std::optional<double> latest = pair->latest();
  if (near.status != Status::hit || !latest) return std::nullopt;
  return FirstImpact{event->time, *latest - near.time.lo};
}

// The first impact keeps its time to within its window. Later impacts may differ, since the envelope leaves a choice.
// `pace`: how many times as fast time runs in the other scene, a power of two.
Finding first_impact_unchanged(const Scene& scene, const std::optional<Scene>& other, Subject& subject,
                               double pace = 1) {
  return of_timeline(scene, subject, [&](const TrajectoryCase& asked, const Timeline&) {
    const std::optional<FirstImpact> first = first_impact(scene, asked.said, asked.precision);
    if (!first) return judge::outside("the first impact is not clear: rounding decides");
    return of_moved(other, subject, [&](const Scene& moved) {
      return judge::given(subject.simulation(moved), [&](const Trajectory& said) {
        const Event* event = first_event(said);
        if (event == nullptr && pace * complete_until(moved, said) < first->time + 2 * first->window) {
          return judge::silent("its events until the first impact");
        }
        if (event == nullptr)
          return judge::wrong(Defect::moved_with_frame, "no impact", text(*first_event(asked.said)));
        return judge::at_most(
            std::abs(pace * event->time - first->time),
            {2 * first->window, first->window, "windows of the first impact"}, Defect::moved_with_frame,
            [&] { return text(*event); },
            [&] {
              return text(*first_event(asked.said)) +
                     (pace == 1 ? ", as before" : ", where time runs " + words::text(pace) + " times slower");
            });
      });
    });
  });
}

Finding rotated(const Scene& scene, Subject& subject) {
  return first_impact_unchanged(scene, some_turn(scene), subject);
}

Finding shifted(const Scene& scene, Subject& subject) {
  return first_impact_unchanged(scene, translated(scene), subject);
}

Finding galilean(const Scene& scene, Subject& subject) {
  return first_impact_unchanged(scene, scene.motion ? carried(scene) : std::nullopt, subject);
}

Finding hastened_run(const Scene& scene, Subject& subject) {
  if (subject.card().stepping) return judge::outside("time steps, which have a unit");
  constexpr int doublings = 5;
  return first_impact_unchanged(scene, scene.motion ? hastened(scene, doublings) : std::nullopt, subject,
                                std::ldexp(1.0, doublings));
}

Finding renumbered(const Scene& scene, Subject& subject) {
  return first_impact_unchanged(scene, swapped(scene), subject);
}

Finding reflected(const Scene& scene, Subject& subject) {
  return first_impact_unchanged(scene, scene.motion ? mirrored(scene) : std::nullopt, subject);
}

// A ball as large as the largest body, so that the envelope stays the same, and too far away for any contact.
Body bystander(const Scene& scene) {
  double largest = 0, far = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const tolerance::BallisticBound bound = tolerance::ballistic(scene, i, end_of(scene), oracle::Precision::binary64);
    largest = std::max(largest, size(scene.bodies[i].shape));
    far = std::max(far, bound.farthest + bound.fastest * end_of(scene));
  }
  Body ball;
  ball.shape = Sphere{largest};
  ball.X_WB.p_WB = std::exp2(std::ceil(std::log2(far)) + 6) * Vec3(1, 0, 0);
  return ball;
}

// m: the largest distance of a body from itself in the other trajectory, at any time of which both tell.
double farthest_apart(const Trajectory& one, const Trajectory& other) {
  double farthest = 0;
  for (std::size_t t = 0; t < std::min(one.states.size(), other.states.size()); ++t) {
    for (std::size_t k = 0; k < std::min(one.states[t].size(), other.states[t].size()); ++k) {
      farthest = std::max(farthest, (one.states[t][k].X_WB.p_WB - other.states[t][k].X_WB.p_WB).stableNorm());
    }
  }
  return farthest;
}

/// Whether the two are the same up to where the first of them gives up: when a subject does may depend on all bodies.
bool agree_where_reported(const Scene& scene, const Trajectory& one, const Trajectory& other) {
  if (!one.complete_until && !other.complete_until) return one == other;
  const double until = std::min(one.complete_until.value_or(infinity), other.complete_until.value_or(infinity));
  return reported_before(scene, one, until) == reported_before(scene, other, until);
}

Finding bystanders(const Scene& scene, Subject& subject) {
  return of_trajectory(scene, subject, [&](const TrajectoryCase& asked) {
    Scene more = scene;
    const auto others = static_cast<std::ptrdiff_t>(scene.bodies.size());
    if (others == 0) return judge::outside("no body");
    more.bodies.push_back(bystander(scene));
    if (!scene.motion->start_times.empty()) more.motion->start_times.push_back(scene.motion->start_times.front());
    return of_scene(more, subject, [&] {
      return judge::given(subject.simulation(more), [&](Trajectory said) {
        for (std::vector<State>& states : said.states) {
          if (states.size() == more.bodies.size()) states.resize(static_cast<std::size_t>(others));
        }
        if (agree_where_reported(scene, said, asked.said)) return judge::holds();
        const double off = farthest_apart(said, asked.said);
        return judge::wrong_by(off, judge::in_ulps(scene, subject.card(), 0), Defect::inconsistent,
                               "another trajectory of the other bodies, up to " + words::text(off) + " m away",
                               "the same bits with a ball far away");
      });
    });
  });
}

/// Two balls, or a ball and a fixed body, elastic and without friction.
bool may_go_back(const Scene& scene) {
  const auto ball = [](const Body& b) { return std::holds_alternative<Sphere>(b.shape) && !is_fixed(b); };
  const auto elastic = [](const Body& b) { return b.material.restitution == 1; };
  return scene.bodies.size() == 2 && ball(scene.bodies[0]) && (ball(scene.bodies[1]) || is_fixed(scene.bodies[1])) &&
         std::ranges::all_of(scene.bodies, elastic) &&
         std::min(scene.bodies[0].material.friction, scene.bodies[1].material.friction) == 0 &&
         scene.motion->forces.empty() && scene.motion->start_times.empty();
}

// m: both impacts may occur anywhere in the envelope, so each up to ε/|u_n| early. Along the normal that shifts the
// trajectory by 2ε. Across it, the normal differs by |u_t|/|u_n|·ε/R, where R is the distance of the centres, and the
// trajectory after it by 2|u_t|ε/R per second. Against a body that does not fall the speeds differ by g·ε/|u_n|. The
// sum counts twice, once for each direction of time.
double back_home(const Scene& scene, const Event& event, double end, double slack) {
  const Vec3 u_after = event.after_a.velocity.v_WBcm - event.after_b.velocity.v_WBcm;
  const Vec3 n = event.nhat_BA_W;
  const double u_n = std::abs(u_after.dot(n)), u_t = (u_after - u_after.dot(n) * n).norm();
  const double R = size(scene.bodies[0].shape);
  const double eps = envelope(scene) + slack;
  if (u_n * u_n < 16 * eps * u_t * u_t / R) return INFINITY;
  return 4 * (eps * (1 + u_t / R * end) + scene.gravity.norm() * eps / u_n * end) + 4 * slack;
}

Finding reversible(const Scene& scene, Subject& subject) {
  return of_timeline(scene, subject, [&](const TrajectoryCase& asked, const Timeline&) {
    const bool once = asked.events() == 1 && asked.said.events->front().kind == Event::Kind::impact;
    if (!may_go_back(scene) || !once || asked.said.states.empty())
      return judge::outside("not exactly one elastic impact of balls");
    Scene back = scene;
    const std::vector<State>& there = asked.said.states.back();
    for (std::size_t i = 0; i < 2; ++i) {
      const bool fixed = is_fixed(scene.bodies[i]);
      if (fixed && !(scene.bodies[i].velocity == Velocity{})) return judge::outside("a fixed body that moves");
      back.bodies[i].X_WB = there[i].X_WB;
      back.bodies[i].velocity = {-there[i].velocity.v_WBcm, -there[i].velocity.w_WB};
    }
    const double end = asked.end;
    back.motion->sample_times = {end};
    const Scene pair = segment_scene(scene, from_the_start(scene, 0, 1), end);
    const double slack = tolerance::moving_distance(pair, end, asked.precision);
    const double allowed = back_home(scene, asked.said.events->front(), end, slack);
    if (std::isinf(allowed)) return judge::outside("a grazing impact");
    return judge::given(subject.simulation(back), [&](const Trajectory& said) {
      if (!fault_in_form(back, said).empty() || said.states.empty()) return judge::silent("the reversed trajectory");
      Finding worst;
      for (std::size_t i = 0; i < 2; ++i) {
        const Vec3 p = said.states.back()[i].X_WB.p_WB, home = scene.bodies[i].X_WB.p_WB;
        if (worse(worst,
                  counted(is_decisive(pair, slack),
                          judge::at_most((p - home).norm(), in_ulps_of_place(asked, allowed), Defect::inconsistent,
                                         [&] { return words::text(p); }, [&] { return words::text(home); })))) {
          return worst;
        }
      }
      return worst;
    });
  });
}

/// A level belt: the only fixed body is an axis-aligned box that moves along its top or not at all, and gravity points
/// straight down or is zero. Else null.
const Body* belt_of(const Scene& scene) {
  const Body* belt = nullptr;
  for (const Body& body : scene.bodies) {
    if (!is_fixed(body)) continue;
    const Quaternion& q = body.X_WB.q_WB;
    const bool level = std::holds_alternative<Box>(body.shape) && q.x == 0 && q.y == 0 && q.z == 0 &&
                       body.velocity.w_WB.isZero(0) && body.velocity.v_WBcm.z() == 0 && belt == nullptr;
    if (!level) return nullptr;
    belt = &body;
  }
  const Vec3& g = scene.gravity;
  return g.x() == 0 && g.y() == 0 && g.z() <= 0 ? belt : nullptr;
}

/// A level table: a belt at rest.
const Body* table_of(const Scene& scene) {
  const Body* belt = belt_of(scene);
  return belt != nullptr && belt->velocity == Velocity{} ? belt : nullptr;
}

/// m: from the centre to the lowest point. None if the body is neither a ball nor a level box.
std::optional<double> half_height(const Body& body) {
  const auto* given = std::get_if<MassProperties>(&body.mass);
  if (given != nullptr && !given->p_BBcm.isZero(0)) return std::nullopt;
  if (const auto* ball = std::get_if<Sphere>(&body.shape)) return ball->radius;
  const Quaternion& q = body.X_WB.q_WB;
  const auto* box = std::get_if<Box>(&body.shape);
  if (box == nullptr || q.x != 0 || q.y != 0 || q.z != 0) return std::nullopt;
  return box->half_extents.z();
}

bool is_over(const Body& table, const Body& body) {
  const Vec3 half = std::get<Box>(table.shape).half_extents, off = body.X_WB.p_WB - table.X_WB.p_WB;
  return std::abs(off.x()) < half.x() && std::abs(off.y()) < half.y();
}

/// m: the height of the lowest point over the table's top. None if it is not known exactly.
std::optional<double> height(const Body& table, const Body& body) {
  const std::optional<double> half = half_height(body);
  if (!half) return std::nullopt;
  return exact_sum({body.X_WB.p_WB.z(), -*half, -table.X_WB.p_WB.z(), -std::get<Box>(table.shape).half_extents.z()});
}

/// A ball, or a level box whose whole bottom is over the table: by symmetry the impulse acts through the centre of
/// mass.
bool lands_centrally(const Body& table, const Body& body) {
  if (!half_height(body)) return false;
  const auto* box = std::get_if<Box>(&body.shape);
  if (box == nullptr) return is_over(table, body);
  const Vec3 half = std::get<Box>(table.shape).half_extents, off = body.X_WB.p_WB - table.X_WB.p_WB;
  return std::abs(off.x()) + box->half_extents.x() < half.x() && std::abs(off.y()) + box->half_extents.y() < half.y();
}

bool clear_of_each_other(const Scene& scene) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < scene.bodies.size(); ++j) {
      const Body &a = scene.bodies[i], &b = scene.bodies[j];
      if (is_fixed(a) || is_fixed(b)) continue;
      if (!((a.X_WB.p_WB - b.X_WB.p_WB).norm() > 1.01 * (tolerance::radius(a) + tolerance::radius(b)))) return false;
    }
  }
  return true;
}

/// All bodies have the belt's velocity and are on it, or over it within the envelope.
bool all_rest(const Scene& scene, const Body& belt) {
  return std::ranges::all_of(scene.bodies, [&](const Body& body) {
    if (is_fixed(body)) return true;
    const double over = height(belt, body).value_or(-1);
    return body.velocity == belt.velocity && is_over(belt, body) && over >= 0 && over <= envelope(scene);
  });
}

/// Level boxes that have the belt's velocity and stand on it and on each other, with their middles above each other:
/// each is held by the next one below.
bool is_stack(const Scene& scene, const Body& belt) {
  std::vector<const Body*> boxes;
  for (const Body& body : scene.bodies) {
    if (!is_fixed(body)) boxes.push_back(&body);
  }
  std::ranges::sort(boxes, {}, [](const Body* body) { return body->X_WB.p_WB.z(); });
  double top = 0;
  for (const Body* body : boxes) {
    const std::optional<double> over = height(belt, *body);
    const bool is_next = over && *over == top && std::holds_alternative<Box>(body->shape) &&
                         body->velocity == belt.velocity && is_over(belt, *body) &&
                         body->X_WB.p_WB.head<2>() == boxes[0]->X_WB.p_WB.head<2>();
    if (!is_next) return false;
    top += 2 * std::get<Box>(body->shape).half_extents.z();
  }
  return true;
}

// m: how far a body falls in the step after which a stepper notices that it touches: at rest, so by g h in that step,
// at most.
double way_from_rest(const Scene& scene, const std::optional<oracle::Stepping>& stepping) {
  return stepping ? scene.gravity.norm() * stepping->step * stepping->step : 0;
}

// A body at rest stays at its place on the table to within the envelope: it neither sinks nor creeps. So does one at
// rest on a belt. Of steppers only what rests on a table at rest, and on nothing else, is judged.
Finding rests(const Scene& given, Subject& subject) {
  const Scene scene = with_whole_tables(given);
  return of_trajectory(given, subject, [&](const TrajectoryCase& asked) {
    const Body* belt = asked.stepping ? table_of(scene) : belt_of(scene);
    const bool still = belt != nullptr && ((all_rest(scene, *belt) && clear_of_each_other(scene)) ||
                                           (!asked.stepping && is_stack(scene, *belt)));
    if (!still || !scene.motion->forces.empty() || !scene.motion->start_times.empty())
      return judge::outside("not bodies at rest on a level table or belt");
    const double allowed = envelope(scene) + tolerance::distance(scene, asked.precision) +
                           way_from_rest(scene, asked.stepping) + asked.distances.of(0);
    Finding worst;
    for (std::size_t sample = 0; sample < asked.samples(); ++sample) {
      for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const Vec3 p = asked.said.states[sample][i].X_WB.p_WB;
        const Vec3 home = scene.bodies[i].X_WB.p_WB + asked.time(sample) * belt->velocity.v_WBcm;
        if (worse(worst,
                  judge::at_most((p - home).norm(), in_ulps_of_place(asked, allowed), Defect::drifts,
                                 [&] { return words::text(p) + " at " + words::text(asked.time(sample)) + " s"; },
                                 [&] { return words::text(home); }))) {
          return worst;
        }
      }
    }
    return asked.samples() > 0 ? worst : judge::silent("any state");
  });
}

/// A body that is thrown straight up or down over a table and bounces to decreasing heights.
struct Bounces {
  static constexpr Real most_impacts = 0x1p20;
  Real height = 0, v = 0, g = 0, e = 0;

  struct Now {
    Real height = 0;
    Real impacts = 0;  ///< so far; infinity: at rest
  };

  /// None after more than `most_impacts`, which are followed one by one.
  // Impact n is at t₁ + 2v₁/g·(e + … + eⁿ⁻¹), with speed eⁿ⁻¹v₁ before it. All impacts are over at t₁ + 2v₁/g·e/(1 −
  // e).
  std::optional<Now> at(Real t) const {
    const Real v1 = std::sqrt(v * v + 2 * g * height), t1 = (v + v1) / g;
    if (t <= t1) return Now{height + v * t - g * t * t / 2, 0};
    Real up = e * v1, since = t - t1;
    Now now{0, 1};
    if (e < 1 && since * g * (1 - e) >= 2 * up) return Now{0, INFINITY};
    while (up > 0 && since * g > 2 * up) {
      since -= 2 * up / g;
      up *= e;
      if (++now.impacts > most_impacts) return {};
    }
    now.height = up * since - g * since * since / 2;
    return now;
  }
};

// An impact at the height h ≤ ε comes h/v early and changes the energy by (1 − e²) mgh. The sum of the time shifts,
// each times the speed after it, is at most 2ε Σ eᵏ. The changed energy adds as much again to the bounces. The rounding
// of the motion counts as a part of the envelope ε.
double freedom_of(const Bounces& ball, Real impacts, double eps) {
  const Real sum = std::min(impacts + 1, ball.e < 1 ? 1 / (1 - ball.e) : INFINITY);
  return static_cast<double>((4 * sum + 2) * eps);
}

/// m: what steps of length h explain (docs/design/stepping.md). Each impact may come a step late: (1 + e) v h lower,
/// and faster by g h until the sample; that changes the time between later impacts by at most 2h. One impact more or
/// less may be over. A method of order 1 takes the body g h t/2 too far.
double stepped(const Bounces& ball, Real impacts, Real time, const std::optional<oracle::Stepping>& stepping) {
  if (!stepping) return 0;
  const Real h = stepping->step, v = std::sqrt(ball.v * ball.v + 2 * ball.g * ball.height);
  const Real n = std::min(impacts + 1, ball.e < 1 ? 1 / (1 - ball.e) + 1 : INFINITY);
  const Real too_far = stepping->order > 1 ? 0 : ball.g * time / 2;
  return static_cast<double>(h * (too_far + n * ((1 + ball.e) * v + ball.g * time) + n * (n - 1) * v));
}

Finding bounces(const Scene& given, Subject& subject) {
  const Scene scene = with_whole_tables(given);
  return of_trajectory(given, subject, [&](const TrajectoryCase& asked) {
    const Body* table = table_of(scene);
    const auto moving = std::ranges::find_if(scene.bodies, [](const Body& b) { return !is_fixed(b); });
    const bool one = table != nullptr && scene.bodies.size() == 2 && moving != scene.bodies.end() &&
                     scene.motion->start_times.empty();
    if (!one || !scene.motion->forces.empty()) return judge::outside("not one body over a level table");
    const Velocity& V = moving->velocity;
    const bool upright = V.v_WBcm.x() == 0 && V.v_WBcm.y() == 0 && V.w_WB.isZero(0) &&
                         lands_centrally(*table, *moving) && scene.gravity.z() < 0;
    const std::optional<double> start = upright ? height(*table, *moving) : std::nullopt;
    if (!start || *start < 0 || (*start == 0 && V.v_WBcm.z() <= 0)) return judge::outside("not thrown over the table");
    const Bounces ball{*start, V.v_WBcm.z(), -scene.gravity.z(),
                       std::min(moving->material.restitution, table->material.restitution)};
    const Scene pair = segment_scene(scene, from_the_start(scene, 0, 1), end_of(scene));
    const double slack = tolerance::moving_distance(pair, end_of(scene), asked.precision),
                 eps = envelope(scene) + slack;
    const auto which = static_cast<std::size_t>(moving - scene.bodies.begin());
    Finding worst;
    for (std::size_t sample = 0; sample < asked.samples(); ++sample) {
      const std::optional<Bounces::Now> followed = ball.at(asked.time(sample));
      if (!followed) return sample > 0 ? worst : judge::outside("bounces too often");
      const Bounces::Now now = *followed;
      const double raised = asked.said.states[sample][which].X_WB.p_WB.z() - moving->X_WB.p_WB.z() + *start;
      const auto said = [&] { return words::text(raised) + " m high at " + words::text(asked.time(sample)) + " s"; };
      const double steps = stepped(ball, now.impacts, asked.time(sample), asked.stepping);
      if (worse(worst, counted(is_decisive(pair, slack) && steps <= tolerance::radius(*moving),
                               judge::at_most(static_cast<double>(std::abs(raised - now.height)),
                                              in_ulps_of_place(asked, freedom_of(ball, now.impacts, eps) + steps),
                                              Defect::wrong_motion, said,
                                              [&] { return words::text(static_cast<double>(now.height)) + " m"; })))) {
        return worst;
      }
    }
    return asked.samples() > 0 ? worst : judge::silent("any state");
  });
}

}  // namespace

std::vector<Property> simulation_scene_properties() {
  const std::string query = "simulation", clause = "TS-SIMULATION-";
  return {
      {"simulation.alone",
       query,
       {clause + "13"},
       "bodies that never touch follow their ballistic trajectories",
       alone},
      {"simulation.rotated", query, {clause + "14"}, "rotating the world changes no first impact", rotated},
      {"simulation.translated", query, {clause + "14"}, "translating the world changes no first impact", shifted},
      {"simulation.galilean",
       query,
       {clause + "15"},
       "a velocity added to all bodies changes no first impact",
       galilean},
      {"simulation.hastened",
       query,
       {clause + "44"},
       "in a motion that is 2^5 times as fast, the first impact comes 2^5 times as soon",
       hastened_run},
      {"simulation.renumbered", query, {clause + "26"}, "renumbering the bodies changes no first impact", renumbered},
      {"simulation.mirrored", query, {clause + "26"}, "mirroring the world changes no first impact", reflected},
      {"simulation.bystanders",
       query,
       {clause + "16"},
       "a body that touches no other changes no bit of the others",
       bystanders},
      {"simulation.reversible", query, {clause + "17"}, "an elastic impact of balls is reversible in time", reversible},
      {"simulation.rests", query, {clause + "18"}, "bodies at rest on a table neither sink nor drift", rests},
      {"simulation.bounces",
       query,
       {clause + "19"},
       "each bounce of a ball, or of a box that falls flat, has the height that its restitution allows, until it rests",
       bounces},
  };
}

}  // namespace touchstone::properties
