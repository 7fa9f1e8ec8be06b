// The clauses of docs/spec/simulation.md about bodies on faces of fixed boxes: how they slide and roll, and what they
// can rest on.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "model/limits.h"
#include "oracle/judge/words.h"
#include "oracle/tolerance/motion.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/impact.h"
#include "oracle/truth/turn.h"
#include "oracle/truth/world_points.h"
#include "properties/cases/box_face.h"
#include "properties/cases/time_of_impact_case.h"
#include "properties/cases/trajectory_case.h"
#include "properties/cases/whole_tables.h"
#include "properties/queries.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Matrix;
using oracle::Point;
using oracle::Real;
using oracle::Subject;
namespace judge = oracle::judge;
namespace tolerance = oracle::tolerance;
namespace words = oracle::words;

constexpr Real infinite = std::numeric_limits<Real>::infinity();

bool moves_by_gravity_alone(const Scene& scene) {
  return scene.motion->forces.empty() && scene.motion->start_times.empty() && !scene.gravity.isZero(0);
}

/// A ball or box on a face. Vectors are in the face's frame.
struct BodyOnFace {
  bool ball = false;
  Real height = 0;             ///< m: of the centre of mass above the lowest point
  Real lambda = 0;             ///< m r²/I; 0 for a body that does not turn
  Plane base = Plane::Zero();  ///< m: half extents of what touches the face
  Point p = Point::Zero();     ///< m: the centre of mass, from the middle of the face
  Point v = Point::Zero(), w = Point::Zero();

  Real speeds() const { return v.norm() + height * w.norm(); }  ///< m/s
};

// A box lies flat: its axes are along those of the face.
std::optional<BodyOnFace> body_on_face(const Scene& scene, std::size_t index, const Face& face) {
  const Body& body = scene.bodies[index];
  const oracle::ImpactBody facts = oracle::impact_body(scene, index, body.X_WB.p_WB);
  if (!facts.p_BcmC_W.isZero(0)) return std::nullopt;
  BodyOnFace on_face;
  on_face.p = face.in_face(body.X_WB.p_WB.cast<Real>() - face.middle);
  on_face.v = face.in_face(facts.v_WBcm);
  on_face.w = face.in_face(facts.w_WB);
  if (const auto* ball = std::get_if<Sphere>(&body.shape)) {
    if (facts.moments[2] - facts.moments[0] > negligible * facts.moments[2]) return std::nullopt;
    on_face.ball = true;
    on_face.height = ball->radius;
    on_face.lambda = facts.mass * on_face.height * on_face.height / facts.moments[0];
    return on_face;
  }
  const auto* box = std::get_if<Box>(&body.shape);
  if (box == nullptr || !on_face.w.isZero(0)) return std::nullopt;
  const Matrix R_FB = face.R_WF.transpose() * facts.R_WB;
  const Matrix flat = R_FB.array().round().matrix();
  if ((R_FB - flat).cwiseAbs().maxCoeff() > negligible) return std::nullopt;
  const Point half = flat.cwiseAbs() * box->half_extents.cast<Real>();
  on_face.height = half.z();
  on_face.base = half.head<2>();
  return on_face;
}

/// A part of the motion with constant acceleration.
struct Phase {
  Real until = infinite;  ///< s, from the start of the phase
  Point p, v, a;
  Real slip_rate = 0;  ///< m/s²: at which its slip ends, if it does

  Point place(Real t) const { return p + t * v + t * t / 2 * a; }
  Point velocity(Real t) const { return v + t * a; }

  /// Is the centre, at all times up to t, so far inside the face that the whole base of the body is?
  bool stays_inside(const Face& face, const Plane& base, Real t) const {
    for (Eigen::Index i = 0; i < 2; ++i) {
      const Real turns = a[i] != 0 ? -v[i] / a[i] : 0;
      for (const Real at : {Real(0), t, std::clamp<Real>(turns, 0, t)}) {
        if (std::abs(place(at)[i]) + base[i] > face.half[i] * (1 - 0x1p-10L)) return false;
      }
    }
    return true;
  }
};

/// Per mass: gravity along the face, what presses on the face, and friction.
struct Load {
  Point along = Point::Zero();
  Real press = 0, friction = 0;
};

// A body that rests on the face, or rolls on it, does so while friction can hold it: the force that it needs
// is g_t/(1 + λ). At the limit itself, rounding decides.
std::optional<Phase> without_slip(const BodyOnFace& on_face, const Load& load, const Point& p, const Point& v) {
  const Real needs = load.along.norm(), most = (1 + on_face.lambda) * load.friction * load.press;
  if (needs > 0 && std::abs(needs - most) < negligible * most) return std::nullopt;
  const Real share = on_face.ball ? on_face.lambda / (1 + on_face.lambda) : 0;
  if (needs <= most) return Phase{infinite, p, v, Point(share * load.along), 0};
  return Phase{infinite, p, v, Point((1 - load.friction * load.press / needs) * load.along), 0};
}

// Slip has the direction σ; it changes at the rate g_t σ − (1 + λ) μ g_n, and the velocity at g_t − μ g_n σ.
std::vector<Phase> phases_of(const BodyOnFace& on_face, const Load& load) {
  Point p = on_face.p, v = on_face.v, slip = on_face.v;
  p.z() = v.z() = 0;
  if (on_face.ball) slip = v - on_face.height * on_face.w.cross(Point::UnitZ());
  slip.z() = 0;
  const Real scale = v.norm() + on_face.height * on_face.w.norm(), speed = slip.norm();
  std::vector<Phase> phases;
  if (speed > negligible * scale) {
    const Point sigma = slip / speed;
    if (sigma.cross(load.along).norm() > negligible * load.along.norm()) return {};  // the slip would turn
    const Real rate = load.along.dot(sigma) - (1 + on_face.lambda) * load.friction * load.press;
    const Real until = rate < 0 ? speed / -rate : infinite;
    phases.push_back({until, p, v, Point(load.along - load.friction * load.press * sigma), std::max<Real>(-rate, 0)});
    if (until == infinite) return phases;
    p = phases.back().place(until);
    v = phases.back().velocity(until);
    if (!on_face.ball) v.setZero();
  }
  const std::optional<Phase> then = without_slip(on_face, load, p, v);
  if (!then) return {};
  phases.push_back(*then);
  return phases;
}

struct Place {
  Point p, v;
};

/// Where the body is at a time; none once it may have left the face.
std::optional<Place> place_at(const std::vector<Phase>& phases, const BodyOnFace& on_face, const Face& face,
                              Real time) {
  for (const Phase& phase : phases) {
    const Real t = std::min(time, phase.until);
    if (!phase.stays_inside(face, on_face.base, t)) return std::nullopt;
    if (time <= phase.until) return Place{phase.place(t), phase.velocity(t)};
    time -= phase.until;
  }
  return std::nullopt;
}

/// m/s: how much the velocity along the face may differ if the body bounces within the envelope.
///
/// Such a bounce has a speed of at most b = √(2 g_n ε). Whatever bounces there are, the normal impulses per mass up to
/// a time add up to g_n t within 2b, so friction to μ g_n t within 2bμ. On a level face, friction stops when slip does,
/// so this is the error of the velocity. On a slope, slip is reflected at 0, which doubles it, and again where the
/// direction reverses; and between two bounces gravity accelerates the body for 2b/g_n. The point of contact is within
/// ε of where it should be, which changes the lever of friction by ε/height.
Real freedom_of(const BodyOnFace& on_face, const Load& load, Real eps) {
  const Real bounce = std::sqrt(2 * load.press * eps), slope = load.along.norm() / load.press;
  const Real speeds = on_face.speeds();
  return (slope > 0 ? 8 * (load.friction + slope) : 2 * load.friction) * bounce + 2 * eps / on_face.height * speeds;
}

/// A body on a face, and its exact motion there.
struct FaceMotion {
  std::size_t body;
  Face face;
  BodyOnFace on_face;
  Load load;
  std::vector<Phase> phases;

  Real slip_ends() const { return phases.front().slip_rate > 0 ? phases.front().until : 0; }  ///< s; 0 if it rolls
};

// A box must not tip: friction acts at its base, so the force that supports it moves forward by μ times its height. It
// must not bounce either, since an impact at one corner can turn velocity along the face into rotation.
bool stays_flat(const BodyOnFace& on_face, const Load& load, Real restitution) {
  return on_face.ball || (restitution == 0 && load.friction * on_face.height < 0.875L * on_face.base.minCoeff());
}

std::optional<FaceMotion> motion_on_face(const Scene& scene, const Body& box, std::size_t index,
                                         oracle::Precision precision) {
  const Body& body = scene.bodies[index];
  const std::optional<Face> face = face_below(box, body.X_WB.p_WB.cast<Real>());
  const std::optional<BodyOnFace> on_face = face ? body_on_face(scene, index, *face) : std::nullopt;
  if (!on_face) return std::nullopt;
  Load load;
  load.along = face->in_face(scene.gravity.cast<Real>());
  load.press = -load.along.z();
  load.along.z() = 0;
  if (load.along.norm() <= negligible * load.press) load.along.setZero();
  load.friction = std::min(body.material.friction, box.material.friction);
  const double restitution = std::min(body.material.restitution, box.material.restitution);
  Scene pair;
  pair.bodies = {box, body};
  const Real slack = tolerance::distance(pair, precision), gap = on_face->p.z() - on_face->height;
  const bool in_contact = gap >= -slack && gap <= (on_face->ball ? envelope(scene) : slack) &&
                          std::abs(on_face->v.z()) <= negligible * on_face->v.norm();
  if (load.press <= 0 || !in_contact || !stays_flat(*on_face, load, restitution)) return std::nullopt;
  std::vector<Phase> phases = phases_of(*on_face, load);
  if (phases.empty()) return std::nullopt;
  return FaceMotion{index, *face, *on_face, load, std::move(phases)};
}

/// m: as far as any point of the body may be from its first centre until the end.
Real reach_of(const Scene& scene, const FaceMotion& motion) {
  const Real end = end_of(scene), fastest = motion.load.along.norm() + motion.load.friction * motion.load.press;
  return tolerance::radius(scene.bodies[motion.body]) + end * motion.on_face.v.norm() + end * end / 2 * fastest;
}

/// The motions of all bodies that move, on the only fixed body; empty unless all slide or roll there, apart from each
/// other.
std::vector<FaceMotion> motions_on_faces(const Scene& scene, oracle::Precision precision) {
  const auto box = std::ranges::find_if(scene.bodies, is_fixed);
  const bool one = box != scene.bodies.end() && std::ranges::count_if(scene.bodies, is_fixed) == 1 &&
                   std::holds_alternative<Box>(box->shape) && box->velocity == Velocity{};
  std::vector<FaceMotion> motions;
  for (std::size_t i = 0; one && i < scene.bodies.size(); ++i) {
    if (is_fixed(scene.bodies[i])) continue;
    std::optional<FaceMotion> motion = motion_on_face(scene, *box, i, precision);
    if (!motion) return {};
    for (const FaceMotion& other : motions) {
      const Real apart = (motion->on_face.p - other.on_face.p).norm();  // on two faces, p has two meanings
      if (motion->face.middle != other.face.middle ||
          apart <= 1.01L * (reach_of(scene, *motion) + reach_of(scene, other)))
        return {};
    }
    motions.push_back(std::move(*motion));
  }
  return motions;
}

/// m/s: rounding of a velocity that is computed from the accelerations of the motion.
Real rounding_of(const FaceMotion& motion, Real time, oracle::Precision precision) {
  const Real speeds = motion.on_face.speeds();
  const Real accelerations = motion.load.along.norm() + (1 + motion.load.friction) * motion.load.press;
  return 64 * oracle::unit_roundoff(precision) * (speeds + accelerations * time);
}

/// What steps explain of a motion on a face (docs/design/stepping.md).
struct SteppedOnFace {
  Real dv = 0;     ///< m/s
  Real place = 0;  ///< m, beside dv times the time
};

// A step finds the contact at its end, so friction may begin a step late; each step rounds velocities and places. A
// method of order 1 takes an acceleration a a h τ/2 too far.
SteppedOnFace stepped(const TrajectoryCase& asked, const FaceMotion& motion, Real time) {
  if (!asked.stepping) return {};
  const Real h = asked.stepping->step, friction = motion.load.friction * motion.load.press;
  const Real speeds = motion.on_face.speeds() + (motion.load.along.norm() + friction) * time;
  const Real rounding = tolerance::rounding_of_steps(static_cast<double>(time), *asked.stepping, asked.precision);
  const Real too_far = asked.stepping->order > 1 ? 0 : (motion.load.along.norm() + friction) * h * time / 2;
  const Real coordinates = asked.scene.bodies[motion.body].X_WB.p_WB.norm() + speeds * time;
  return {friction * h + rounding * speeds, too_far + rounding * coordinates};
}

/// Whether friction has one direction from one time to another, although velocities along the face may differ by dv:
/// then slip differs by (1 + λ) dv, so it may end that much earlier or later, and in a step.
bool keeps_phase(const FaceMotion& motion, Real from, Real until, Real dv, Real step) {
  const Real ends = motion.slip_ends();
  if (ends == 0) return true;
  const Real doubt = 2 * (1 + motion.on_face.lambda) * dv / motion.phases.front().slip_rate + step;
  return until < ends - doubt || from > ends + doubt;
}

/// rad/s: how far a ball's angular velocity may be from the line between those at two samples.
///
/// While it slips, friction's impulse differs from an even one by μ times the normal velocity, which bounces within the
/// envelope keep within b of 0: from the line between two times by at most 2bμ, which is part of dv, and so is the
/// effect of the lever. It changes r ω by λ times what it changes v by. When the ball rolls, its slip is at most
/// (1 + λ) dv and v is right within dv, so r ω is right within (2 + λ) dv, at both samples too. A step of length h has
/// the angular velocity of one of its ends, and turns by 2 atan(h |ω|/2) instead of h |ω| if it is added to the
/// quaternion, which is less by at most h³|ω|³/12.
Real spin_freedom(const FaceMotion& motion, bool slips, const Point& from, const Point& until, Real seconds, Real dv,
                  Real step) {
  const Real w = std::max(from.norm(), until.norm()), lambda = motion.on_face.lambda;
  return (slips ? lambda : 2 * (2 + lambda)) * dv / motion.on_face.height + step / 2 * (until - from).norm() / seconds +
         step * step * w * w * w / 12;
}

/// rad: of the rotation that takes a to b.
Real angle_between(const Matrix& a, const Matrix& b) {
  return 2 * std::asin(std::min<Real>(1, (b - a).norm() / std::sqrt(8.0L)));
}

Finding turns_between(const TrajectoryCase& asked, const FaceMotion& motion, const State& before, Real from,
                      const State& after, Real until) {
  const Point w0 = before.velocity.w_WB.cast<Real>(), w1 = after.velocity.w_WB.cast<Real>();
  const Real seconds = until - from, step = asked.said.events ? 0 : longest_step;
  const Real dv = freedom_of(motion.on_face, motion.load, envelope(asked.scene)) +
                  rounding_of(motion, until, asked.precision) + stepped(asked, motion, until).dv;
  if (seconds <= 0 || !oracle::is_short_turn(w0, w1, seconds)) return judge::outside("no time, or too many turns");
  if (!keeps_phase(motion, from, until, dv, step)) return judge::outside("slip ends between the samples");
  // 64 roundings of each quaternion, and of each radian since the start.
  const Real turned = 1 + std::max(w0.norm(), w1.norm()) * until;
  const double u = oracle::unit_roundoff(asked.precision), unit = u * static_cast<double>(turned);
  const Real allowed = seconds * spin_freedom(motion, until < motion.slip_ends(), w0, w1, seconds, dv, step) +
                       oracle::turn_error(w0, w1, seconds) + 64 * unit;
  const Real off = angle_between(oracle::turn(w0, w1, seconds) * oracle::rotation_matrix(before.X_WB.q_WB),
                                 oracle::rotation_matrix(after.X_WB.q_WB));
  return counted(allowed < 0x1p-4L,
                 judge::at_most(
                     static_cast<double>(off),
                     {static_cast<double>(allowed), unit, "ulps of what it has turned", 0, static_cast<double>(turned)},
                     Defect::wrong_motion,
                     [&] {
                       return "body " + std::to_string(motion.body) + " turns otherwise from " +
                              words::text(static_cast<double>(from)) + " s to " +
                              words::text(static_cast<double>(until)) + " s";
                     },
                     [] { return std::string("the rotation by its angular velocities"); }));
}

// The torque on a ball that slides or rolls on a face is constant, so its angular velocity changes evenly. Its
// orientation follows from that; it is not turned by the sum of angles, unless the axis stays.
Finding turns(const Scene& given, Subject& subject) {
  const Scene scene = with_whole_tables(given);
  return of_trajectory(given, subject, [&](const TrajectoryCase& asked) {
    if (!moves_by_gravity_alone(scene)) return judge::outside("applied forces, or no gravity");
    Finding worst = judge::outside("no ball that slides or rolls on a fixed face, apart from others");
    for (const FaceMotion& motion : motions_on_faces(scene, asked.precision)) {
      State before{scene.bodies[motion.body].X_WB, scene.bodies[motion.body].velocity};
      Real from = 0;
      for (std::size_t sample = 0; motion.on_face.ball && sample < asked.samples(); ++sample) {
        const Real until = asked.time(sample);
        if (!place_at(motion.phases, motion.on_face, motion.face, until)) break;
        const State& after = asked.said.states[sample][motion.body];
        if (worse(worst, turns_between(asked, motion, before, from, after, until))) return worst;
        before = after;
        from = until;
      }
    }
    return worst;
  });
}

// A body that slides on a face slows by friction until its slip ends. Then a ball rolls, and a box rests.
Finding slides(const Scene& given, Subject& subject) {
  const Scene scene = with_whole_tables(given);
  return of_trajectory(given, subject, [&](const TrajectoryCase& asked) {
    if (!moves_by_gravity_alone(scene)) return judge::outside("applied forces, or no gravity");
    Finding worst = judge::outside("not bodies that slide or roll on a fixed face, apart from each other");
    for (const FaceMotion& motion : motions_on_faces(scene, asked.precision)) {
      for (std::size_t sample = 0; sample < asked.samples(); ++sample) {
        const Real time = asked.time(sample);
        const std::optional<Place> expected = place_at(motion.phases, motion.on_face, motion.face, time);
        if (!expected) break;
        const State& said = asked.said.states[sample][motion.body];
        Point v = motion.face.in_face(said.velocity.v_WBcm.cast<Real>()),
              p = motion.face.in_face(said.X_WB.p_WB.cast<Real>() - motion.face.middle);
        v.z() = p.z() = 0;
        const SteppedOnFace steps = stepped(asked, motion, time);
        const Real dv = freedom_of(motion.on_face, motion.load, envelope(scene)) +
                        rounding_of(motion, time, asked.precision) + steps.dv;
        const double speed = static_cast<double>(motion.on_face.v.norm() + scene.gravity.norm() * time + 0x1p-900L);
        const double unit = oracle::unit_roundoff(asked.precision) * speed;
        const auto at = [&] { return " at " + words::text(asked.time(sample)) + " s"; };
        const auto in_words = [](const Point& x) { return words::text(Vec3(x.cast<double>())); };
        if (worse(worst, judge::at_most(
                             static_cast<double>((v - expected->v).norm()),
                             {static_cast<double>(dv), unit, "ulps of its speed", 0, speed}, Defect::wrong_velocity,
                             [&] { return "v = " + in_words(v) + " along the face" + at(); },
                             [&] { return in_words(expected->v); }))) {
          return worst;
        }
        const double allowed = static_cast<double>(time * dv + steps.place) + envelope(scene) +
                               tolerance::distance(scene, asked.precision);
        const Finding place = judge::at_most(
            static_cast<double>((p - expected->p).norm()), in_ulps_of_place(asked, allowed), Defect::wrong_motion,
            [&] { return "p = " + in_words(p) + " on the face" + at(); }, [&] { return in_words(expected->p); });
        if (worse(worst, counted(is_decisive(scene.bodies[motion.body], allowed), place))) {
          return worst;
        }
      }
    }
    return worst;
  });
}

/// An interval of coordinates; at first empty.
struct Range {
  Real lo = infinite, hi = -infinite;
  void add(Real x) {
    lo = std::min(lo, x);
    hi = std::max(hi, x);
  }
  void add(const Range& other) {
    if (other.lo > other.hi) return;
    add(other.lo);
    add(other.hi);
  }
  Range within(Real from, Real to) const { return {std::max(lo, from), std::min(hi, to)}; }
  Real off(Real x) const { return std::max<Real>({lo - x, x - hi, 0}); }
};
using Ranges = std::array<Range, 3>;  ///< of x, y, z

/// The part of a ball or convex polytope that is not higher than `height`.
Ranges part_below(const Body& body, Real height) {
  Ranges part;
  const std::vector<Point> points = oracle::world_points(body, 0);
  if (const auto* ball = std::get_if<Sphere>(&body.shape)) {
    const Real r = ball->radius, deep = std::clamp<Real>(height - (points[0].z() - r), 0, r);
    const Real wide = std::sqrt(deep * (2 * r - deep));
    for (Eigen::Index i = 0; i < 2; ++i) {
      part[i].add(points[0][i] - wide);
      part[i].add(points[0][i] + wide);
    }
    part[2].add(points[0].z() - r);
    return part;
  }
  for (const Point& low : points) {
    part[2].add(low.z());
    if (low.z() > height) continue;
    for (const Point& other : points) {
      const Real share = other.z() > height ? (height - low.z()) / (other.z() - low.z()) : 1;
      for (Eigen::Index i = 0; i < 2; ++i) part[i].add(low[i] + share * (other[i] - low[i]));
    }
  }
  return part;
}

Ranges extent(const Body& body) { return part_below(body, infinite); }

bool is_level_box(const Body& body) {
  const Quaternion& q = body.X_WB.q_WB;
  return std::holds_alternative<Box>(body.shape) && q.x == 0 && q.y == 0 && q.z == 0 && body.velocity == Velocity{};
}

/// The rectangle that encloses all points at which level boxes of one height may support the body from below. None if
/// there are none, or if a box may hold it in another way.
std::optional<Ranges> support_of(const Scene& scene, const Body& body, Real eps) {
  const Real lowest = extent(body)[2].lo;
  Ranges support;
  std::optional<Real> height;
  for (const Body& box : scene.bodies) {
    if (!is_fixed(box)) continue;
    const Point half = std::get<Box>(box.shape).half_extents.cast<Real>(), at = box.X_WB.p_WB.cast<Real>();
    const Real top = at.z() + half.z();
    if (lowest > top + eps) continue;
    const Ranges below = part_below(body, lowest < top - eps ? infinite : top + eps);
    const Range x = below[0].within(at.x() - half.x() - eps, at.x() + half.x() + eps),
                y = below[1].within(at.y() - half.y() - eps, at.y() + half.y() + eps);
    if (x.lo > x.hi || y.lo > y.hi) continue;
    if (lowest < top - eps || (height && *height != top)) return std::nullopt;
    height = top;
    support[0].add(x);
    support[1].add(y);
  }
  return height ? std::optional(support) : std::nullopt;
}

bool alone_at(const Scene& scene, std::size_t index, const std::vector<State>& states) {
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (i == index || is_fixed(scene.bodies[i])) continue;
    const double reach = tolerance::radius(scene.bodies[i]) + tolerance::radius(scene.bodies[index]);
    if ((states[i].X_WB.p_WB - states[index].X_WB.p_WB).norm() <= 1.01 * reach) return false;
  }
  return true;
}

/// m/s: the speed of a bounce within the envelope. At rest, no point of a body is faster.
Real bounce_speed(const Scene& scene) {
  return std::sqrt(2 * scene.gravity.cast<Real>().norm() * static_cast<Real>(envelope(scene)));
}

bool at_rest(const Scene& scene, std::size_t index, const State& from, const State& to) {
  const Body& body = scene.bodies[index];
  const double speed = static_cast<double>(bounce_speed(scene)), rho = tolerance::radius(body);
  const auto slow = [&](const Velocity& V) { return V.v_WBcm.norm() + rho * V.w_WB.norm() <= speed; };
  return slow(from.velocity) && slow(to.velocity) && displacement(body, from.X_WB, to.X_WB) <= 2 * envelope(scene);
}

// m: how far outside its support the centre of mass may be, from one state at rest to another, `seconds` later. If it
// is outside by d, then about the edge of the support gravity turns the body outwards with at least the torque m g d,
// and no force from inside the edge turns it back: the body gains the angular momentum m g d T. The two states differ
// by at most m ρ + I/ρ times the sum of their speeds. The place of the body is known to within two envelopes.
Real overhang(const Scene& scene, std::size_t index, const State& from, const State& to, Real seconds) {
  const oracle::ImpactBody body = oracle::impact_body(scene, index, scene.bodies[index].X_WB.p_WB);
  const Real rho = tolerance::radius(scene.bodies[index]) + body.p_BBcm.norm(), g = scene.gravity.cast<Real>().norm();
  const auto speed = [rho](const Velocity& V) { return V.v_WBcm.norm() + rho * V.w_WB.norm(); };
  const Real lever = rho + body.moments[2] / (body.mass * rho);
  return 4 * static_cast<Real>(envelope(scene)) + lever * (speed(from.velocity) + speed(to.velocity)) / (g * seconds);
}

// The centre of mass of a body that rests is over what it rests on.
Finding supported(const Scene& given, Subject& subject) {
  const Scene scene = with_whole_tables(given);
  return of_trajectory(given, subject, [&](const TrajectoryCase& asked) {
    const Vec3& g = scene.gravity;
    const bool level = g.x() == 0 && g.y() == 0 && g.z() < 0 && std::ranges::all_of(scene.bodies, [](const Body& body) {
                         return is_fixed(body) ? is_level_box(body) : !std::holds_alternative<Compound>(body.shape);
                       });
    if (!level || !moves_by_gravity_alone(scene)) return judge::outside("not level boxes under gravity alone");
    Finding worst = judge::outside("no body at rest on level boxes alone from one sample to the next");
    for (std::size_t sample = 1; sample < asked.samples(); ++sample) {
      const std::vector<State>&from = asked.said.states[sample - 1], &to = asked.said.states[sample];
      for (std::size_t i = 0; i < to.size(); ++i) {
        if (is_fixed(scene.bodies[i]) || !at_rest(scene, i, from[i], to[i]) || !alone_at(scene, i, to)) continue;
        Body body = scene.bodies[i];
        body.X_WB = to[i].X_WB;
        Scene there = scene;
        there.bodies[i] = body;
        const double slack = tolerance::distance(there, asked.precision);
        const std::optional<Ranges> support = support_of(scene, body, envelope(scene) + slack);
        if (!support) continue;
        const double allowed = slack + static_cast<double>(overhang(scene, i, from[i], to[i],
                                                                    asked.time(sample) - asked.time(sample - 1)));
        const oracle::ImpactBody facts = oracle::impact_body(there, i, Vec3::Zero());
        const Point centre = -facts.p_BcmC_W;
        const Real off = std::max((*support)[0].off(centre.x()), (*support)[1].off(centre.y()));
        if (worse(worst, counted(4 * allowed < size(body.shape),
                                 judge::at_most(
                                     static_cast<double>(off), in_ulps_of_place(asked, allowed), Defect::wrong_motion,
                                     [&] {
                                       return "body " + std::to_string(i) + " rests with its centre of mass at " +
                                              words::text(Vec3(centre.cast<double>()));
                                     },
                                     [] { return std::string("a centre of mass over the support"); })))) {
          return worst;
        }
      }
    }
    return worst;
  });
}

}  // namespace

std::vector<Property> simulation_face_properties() {
  const std::string query = "simulation", clause = "TS-SIMULATION-";
  return {
      {"simulation.slides",
       query,
       {clause + "28"},
       "a body on a fixed face slides, rolls or rests as friction has it",
       slides},
      {"simulation.turns",
       query,
       {clause + "32"},
       "a ball on a face turns as the reported angular velocities say",
       turns},
      {"simulation.supported", query, {clause + "29"}, "a body that rests is over its support", supported},
  };
}

}  // namespace touchstone::properties
