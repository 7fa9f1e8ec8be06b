#include "reference/constraint.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "model/input_error.h"
#include "reference/face_contact_impl.h"
#include "reference/rational_impl.h"

namespace touchstone::reference {
namespace {

using Mode = ConstraintTruth::Mode;
using Change = ConstraintTruth::Change;

constexpr std::size_t most_changes = 40;

Enclosed length(const EnclosedVec& a) { return root(inner(a, a)); }
EnclosedVec enclosed(const Triple& a) { return {Enclosed(a[0]), Enclosed(a[1]), Enclosed(a[2])}; }
std::string place(std::size_t body) { return "bodies[" + std::to_string(body) + "]"; }
Vec3 nearest(const EnclosedVec& a) {
  Vec3 v;
  for (std::size_t i = 0; i < 3; ++i) v[static_cast<Eigen::Index>(i)] = a[i].middle().convert_to<double>();
  return v;
}

std::array<Interval, 3> in_doubles(const EnclosedVec& a) {
  return {a[0].in_doubles(), a[1].in_doubles(), a[2].in_doubles()};
}

BallTruth told(const Parabola& way) { return {in_doubles(way.p), in_doubles(way.v), in_doubles(way.w)}; }

/// Rᵀ v.
Triple turned_in(const Motion& X_WB, const Triple& v) {
  Triple in;
  for (std::size_t i = 0; i < 3; ++i) {
    in[i] = X_WB.rows[0][i] * v[0] + X_WB.rows[1][i] * v[1] + X_WB.rows[2][i] * v[2];
  }
  return in;
}

std::size_t only_ball(const Scene& scene) {
  std::optional<std::size_t> ball;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    if (std::holds_alternative<Fixed>(body.mass)) {
      if (!std::holds_alternative<Box>(body.shape))
        throw InputError(place(i) + ".shape", "a fixed body that is no box");
      if (body.velocity != Velocity{}) throw InputError(place(i) + ".velocity", "a fixed body that moves");
      continue;
    }
    if (!std::holds_alternative<Sphere>(body.shape))
      throw InputError(place(i) + ".shape", "a moving body that is no ball");
    if (ball) throw InputError(place(i), "a second moving body");
    ball = i;
  }
  if (!ball) throw InputError("bodies", "nothing moves");
  return *ball;
}

Ball ball_of(const Body& body, std::size_t index) {
  const mpq_class r = std::get<Sphere>(body.shape).radius;
  const auto* given = std::get_if<MassProperties>(&body.mass);
  if (given == nullptr) {
    // An impulse is told to the nearest double only: π to 53 bits is enough for the mass, which moves nothing else.
    const double mass = std::get<Density>(body.mass).value * 4 * 3.14159265358979323846 / 3;
    return {Enclosed(r), Enclosed(mass) * Enclosed(mpq_class(r * r * r)), Enclosed(mpq_class(2, 5))};
  }
  const double I = given->I_BBcm_B(0, 0);
  if (given->p_BBcm != Vec3::Zero() || given->I_BBcm_B != Mat3(I * Mat3::Identity())) {
    throw InputError(place(index) + ".mass", "a ball that is not the same all round");
  }
  return {Enclosed(r), Enclosed(given->mass), Enclosed(mpq_class(mpq_class(I) / (mpq_class(given->mass) * r * r)))};
}

/// Where the ball is to a box at the start, decided in rationals.
struct Start {
  int apart = 0;  ///< sign of the distance
  std::optional<Face> face;
  int approach = 0;  ///< of a face that is touched: sign of v·n
  Slip slip = Slip::any;
};

class Course {
 public:
  explicit Course(const Scene& scene);
  ConstraintTruth run();

 private:
  Slab slab_of(std::size_t index) const;
  Start start_of(const Slab& slab) const;
  void begin();
  void rests_on(const Face& face, Slip slip);
  void flies();

  struct Next {
    enum class What { nothing, slip_stops, passes, meets };
    What what = What::nothing;
    Enclosed tau;
    Passing passing;
    const Slab* met = nullptr;
  };
  Next next() const;
  void look(const Enclosed& until);
  void pass(const Passing& passing);
  void meet(const Slab& slab);
  Slip strike(const Slab& slab, const EnclosedVec& n_B);
  void land(const Slab& slab, const EnclosedVec& over, Slip slip);
  void record(Event::Kind kind, const Slab& slab, const EnclosedVec& n, const EnclosedVec& P, const Enclosed& rate,
              const Enclosed& kick);
  void note_clear(const Next& change, const Enclosed& span);
  void note_speed();
  Enclosed pull() const;

  const Scene& scene_;
  const std::vector<double>& times_;
  ConstraintTruth truth_;
  std::size_t index_;
  Ball ball_;
  std::vector<Slab> slabs_;
  EnclosedVec gravity_;

  Parabola way_;
  Mode mode_ = Mode::flies;
  std::optional<Face> face_;
  ContactLaw law_;
  std::vector<Parting> partings_;
};

Course::Course(const Scene& scene) : scene_(scene), times_(scene.flight->times), index_(only_ball(scene)) {
  const Flight& flight = *scene.flight;
  if (!flight.pushes.empty()) throw InputError("flight.pushes", "a ball that is pushed");
  for (const double since : flight.since) {
    if (since != 0) throw InputError("flight.since", "a body that starts later than another");
  }
  const Body& body = scene.bodies[index_];
  truth_.ball = static_cast<int>(index_);
  ball_ = ball_of(body, index_);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (i != index_) slabs_.push_back(slab_of(i));
  }
  gravity_ = enclosed(triple(scene.gravity));
  way_ = {0,        enclosed(triple(body.X_WB.p_WB)),     enclosed(triple(body.velocity.v_WBcm)),
          gravity_, enclosed(triple(body.velocity.w_WB)), {}};
}

Slab Course::slab_of(std::size_t index) const {
  const Body& body = scene_.bodies[index];
  const Motion X_WB = motion(body.X_WB);
  Slab slab;
  slab.body = static_cast<int>(index);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) slab.axes[i][j] = Enclosed(X_WB.rows[j][i]);
  }
  slab.origin = enclosed(X_WB.translation);
  slab.half = enclosed(triple(std::get<Box>(body.shape).half_extents));
  slab.gravity = enclosed(turned_in(X_WB, triple(scene_.gravity)));
  const Material& ball = scene_.bodies[index_].material;
  slab.friction = std::min(ball.friction, body.material.friction);
  slab.restitution = std::min(ball.restitution, body.material.restitution);
  return slab;
}

Start Course::start_of(const Slab& slab) const {
  const Body &body = scene_.bodies[static_cast<std::size_t>(slab.body)], &ball = scene_.bodies[index_];
  const Motion X_WB = motion(body.X_WB);
  const Triple half = triple(std::get<Box>(body.shape).half_extents);
  const mpq_class r(std::get<Sphere>(ball.shape).radius);
  const Triple p = triple(ball.X_WB.p_WB);
  const Triple c =
      turned_in(X_WB, {p[0] - X_WB.translation[0], p[1] - X_WB.translation[1], p[2] - X_WB.translation[2]});
  Start start;
  mpq_class squared = -r * r;
  std::vector<std::size_t> beyond;
  for (std::size_t i = 0; i < 3; ++i) {
    const mpq_class e = abs(c[i]) - half[i];
    if (e > 0) squared += e * e;
    if (e >= 0) beyond.push_back(i);
  }
  start.apart = sgn(squared);
  if (start.apart != 0) return start;
  if (beyond.size() != 1) throw InputError("bodies", "the ball starts at an edge of a box");
  const std::size_t axis = beyond[0];
  start.face = Face{&slab, axis, sgn(c[axis])};
  const Triple v = turned_in(X_WB, triple(ball.velocity.v_WBcm)), w = turned_in(X_WB, triple(ball.velocity.w_WB));
  start.approach = start.face->side * sgn(v[axis]);
  Triple n;
  n[axis] = start.face->side;
  const Triple turn = cross(w, n);
  Triple u, g = turned_in(X_WB, triple(scene_.gravity));
  for (std::size_t i = 0; i < 3; ++i) u[i] = v[i] - r * turn[i];
  u[axis] = g[axis] = 0;
  const Triple across = cross(u, g);
  const auto zero = [](const Triple& a) { return sgn(a[0]) == 0 && sgn(a[1]) == 0 && sgn(a[2]) == 0; };
  start.slip = zero(u) ? Slip::none : zero(across) ? Slip::straight : Slip::any;
  return start;
}

Enclosed Course::pull() const {
  const Enclosed spin = ball_.radius * length(way_.alpha), centre = length(way_.a);
  return hull(spin, centre);
}

void Course::note_speed() {
  const Enclosed centre = length(way_.v), spin = ball_.radius * length(way_.w);
  truth_.speed = std::max({truth_.speed, centre.in_doubles().hi, spin.in_doubles().hi});
}

void Course::record(Event::Kind kind, const Slab& slab, const EnclosedVec& n, const EnclosedVec& P,
                    const Enclosed& rate, const Enclosed& kick) {
  if (truth_.changes.size() == most_changes) throw InputError("flight", "more changes than are followed");
  note_speed();
  Change change;
  change.kind = kind;
  change.time = way_.start.in_doubles();
  change.other = slab.body;
  change.p_WC = nearest(minus(way_.p, scaled(ball_.radius, n)));
  change.nhat_W = nearest(n);
  change.P_W = nearest(P);
  change.mode = mode_;
  change.rate = rate.in_doubles().lo;
  change.kick = kick.in_doubles().hi;
  change.pull = pull().in_doubles().hi;
  change.after = told(way_);
  truth_.changes.push_back(std::move(change));
}

/// Boxes that the ball has just left or is about to meet are what the changes themselves are about.
void Course::note_clear(const Next& change, const Enclosed& span) {
  Float clear = ldexp(Float(1), 1000);  // where there is nothing else
  if (face_) {
    const bool passes = change.what == Next::What::passes;
    clear =
        std::min(clear, least_inside(*face_, way_, span, passes ? std::optional(change.passing.over) : std::nullopt));
  }
  for (const Slab& slab : slabs_) {
    const bool parts = std::ranges::any_of(partings_, [&](const Parting& p) { return p.body == slab.body; });
    if (parts || &slab == change.met || (face_ && face_->slab == &slab)) continue;
    clear = std::min(clear, least_distance(way_, slab, ball_.radius, span));
  }
  const double told = Enclosed(clear, clear).in_doubles().lo;
  (truth_.changes.empty() ? truth_.clear : truth_.changes.back().clear) = told;
}

void Course::flies() {
  mode_ = Mode::flies;
  face_.reset();
  law_ = {};
  way_.a = gravity_;
  way_.alpha = {};
}

void Course::rests_on(const Face& face, Slip slip) {
  face_ = face;
  law_ = contact_law(ball_, face, way_, slip);
  mode_ = law_.mode;
  way_ = law_.way;
}

void Course::begin() {
  note_speed();
  std::optional<Start> touched;
  for (const Slab& slab : slabs_) {
    const Start start = start_of(slab);
    if (start.apart < 0) throw InputError(place(static_cast<std::size_t>(slab.body)), "overlaps the ball at the start");
    if (start.apart > 0) continue;
    if (touched) throw InputError("bodies", "the ball starts between two boxes");
    touched = start;
  }
  truth_.pull = pull().in_doubles().hi;
  if (!touched) return;
  const Face& face = *touched->face;
  const EnclosedVec n = face.normal_W();
  if (touched->approach > 0) {
    partings_ = {{face.slab->body}};
  } else if (touched->approach == 0) {
    rests_on(face, touched->slip);
    record(Event::Kind::contact, *face.slab, n, {}, 0, 0);
  } else {
    meet(*face.slab);
  }
  truth_.mode = mode_;
  truth_.pull = pull().in_doubles().hi;
}

Course::Next Course::next() const {
  Enclosed horizon = Enclosed(times_.back()) - way_.start;
  horizon = horizon * Enclosed(1.0009765625);  // past the end, so that a change at the end is none of the question's
  std::vector<Next> all;
  if (law_.slip_stops) all.push_back({Next::What::slip_stops, *law_.slip_stops, {}, nullptr});
  if (face_) {
    if (const auto passing = first_passing(*face_, way_, horizon)) {
      all.push_back({Next::What::passes, passing->tau, *passing, nullptr});
    }
  }
  for (const Slab& slab : slabs_) {
    if (face_ && face_->slab == &slab) continue;
    std::optional<Parting> parting;
    for (const Parting& p : partings_) {
      if (p.body == slab.body) parting = p;
    }
    // No farther than the first change so far: beyond, this way is not the ball's.
    Enclosed until = horizon;
    for (const Next& n : all) {
      if ((until - n.tau).is_positive()) until = n.tau * Enclosed(1.0009765625);
    }
    if (const auto tau = first_meeting(way_, slab, ball_.radius, until, parting)) {
      all.push_back({Next::What::meets, *tau, {}, &slab});
    }
  }
  const auto first =
      std::min_element(all.begin(), all.end(), [](const Next& a, const Next& b) { return a.tau.hi() < b.tau.hi(); });
  if (first == all.end()) return {};
  for (const Next& n : all) {
    if (&n != &*first && !(n.tau - first->tau).is_positive()) throw Undecided("which of two changes comes first");
  }
  return *first;
}

void Course::look(const Enclosed& until) {
  while (truth_.states.size() < times_.size()) {
    const Enclosed time(times_[truth_.states.size()]);
    if (!(until - time).is_positive()) return;
    const Parabola then = way_.later(time - way_.start);
    truth_.states.push_back(told(then));
    const Enclosed centre = length(then.v), spin = ball_.radius * length(then.w);
    truth_.speed = std::max({truth_.speed, centre.in_doubles().hi, spin.in_doubles().hi});
  }
}

/// Over the edge: flight, if the ball falls more slowly than it would round the edge, v² > r N; else it would pivot.
void Course::pass(const Passing& passing) {
  const Face face = *face_;
  const EnclosedVec n = face.normal_W();
  if (sign_of(square(passing.speed) - ball_.radius * face.weight(), "whether the ball flies off the edge") < 0) {
    throw InputError("bodies", "the ball is so slow that it pivots about the edge");
  }
  flies();
  partings_ = {{face.slab->body, true, face.axis, passing.over}};
  record(Event::Kind::release, *face.slab, n, {}, passing.speed, 0);
}

/// The part of u at right angles to the unit vector n: of an axis, exactly.
EnclosedVec across(const EnclosedVec& u, const EnclosedVec& n) {
  EnclosedVec rest = minus(u, scaled(inner(u, n), n));
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_zero(EnclosedVec{n[(i + 1) % 3], n[(i + 2) % 3], 0})) {
      rest = u;
      rest[i] = 0;
    }
  }
  return rest;
}

/// The axis of the one coordinate that is certainly not 0 while the others certainly are: over a face.
std::optional<std::size_t> only_axis(const EnclosedVec& over) {
  for (std::size_t i = 0; i < 3; ++i) {
    const bool others = over[(i + 1) % 3].is_zero() && over[(i + 2) % 3].is_zero();
    if (others && !over[i].holds_zero()) return i;
  }
  return std::nullopt;
}

/// The unit vector from the nearest point of a box to the centre.
EnclosedVec normal(const EnclosedVec& over, const Enclosed& radius) {
  EnclosedVec n = scaled(1 / radius, over);
  if (const auto axis = only_axis(over)) n[*axis] = over[*axis].is_positive() ? 1 : -1;
  return n;
}

/// The impulse at a point with normal n: P_n = (1 + e) m |u_n|; friction stops the slip if κ/(1 + κ) |u_t| ≤ μ P_n/m.
/// What is known of the slip after.
Slip Course::strike(const Slab& slab, const EnclosedVec& n_B) {
  const EnclosedVec n = slab.turned_out(n_B);
  const Enclosed approach = -inner(way_.v, n);
  const Enclosed push = (1 + slab.restitution) * approach;
  const EnclosedVec u = slab.turned_in(minus(way_.v, scaled(ball_.radius, cross(way_.w, n))));
  const EnclosedVec slip = slab.turned_out(across(u, n_B));
  const Enclosed sticking = ball_.kappa / (1 + ball_.kappa);
  const EnclosedVec needed = scaled(-sticking, slip);
  const Enclosed most = slab.friction * push;
  EnclosedVec drag = needed;
  Slip after = Slip::none;
  if (!is_zero(slip) && sign_of(square(most) - inner(needed, needed), "whether an impact stops slip") < 0) {
    drag = most.is_zero() ? EnclosedVec{} : scaled(-(most / length(slip)), slip);
    after = Slip::any;
  }
  const EnclosedVec jump = plus(scaled(push, n), drag);
  const EnclosedVec spin = scaled(-(1 / (ball_.kappa * ball_.radius)), cross(n, drag));
  way_.v = plus(way_.v, jump);
  way_.w = plus(way_.w, spin);
  record(Event::Kind::impact, slab, n, scaled(ball_.mass, jump), approach,
         hull(length(jump), ball_.radius * length(spin)));
  if (!only_axis(n_B)) truth_.changes.back().curvature = (1 / ball_.radius).in_doubles().hi;
  return after;
}

/// After an impact without restitution.
void Course::land(const Slab& slab, const EnclosedVec& over, Slip slip) {
  const auto axis = only_axis(over);
  if (!axis) throw InputError("bodies", "the ball comes to rest on an edge");
  rests_on({&slab, *axis, over[*axis].is_positive() ? 1 : -1}, slip);
  partings_.clear();
  record(Event::Kind::contact, slab, face_->normal_W(), {}, 0, 0);
}

void Course::meet(const Slab& slab) {
  const EnclosedVec over = excess(slab, way_.p);
  const EnclosedVec n_B = normal(over, ball_.radius), n = slab.turned_out(n_B);
  if (!face_) flies();
  const EnclosedVec before = way_.v;
  const Slip slip = strike(slab, n_B);
  if (!face_) {
    if (slab.restitution.is_zero()) return land(slab, over, slip);
    partings_ = {{slab.body}};
    return;
  }
  if (slab.restitution.is_zero()) throw InputError("bodies", "the ball stays between two boxes");
  const Face face = *face_;
  const EnclosedVec up = face.normal_W();
  const int lifts = sign_of(inner(minus(way_.v, before), up), "whether an impact lifts the ball");
  partings_ = {{slab.body}};
  if (lifts > 0) {
    flies();
    partings_.push_back({face.slab->body});
    return record(Event::Kind::release, *face.slab, up, {}, 0, 0);
  }
  Slip under = Slip::any;
  if (lifts < 0) {
    under = strike(*face.slab, face.normal_B());
    if (sign_of(inner(way_.v, n), "whether the ball leaves a box") <= 0) {
      throw InputError("bodies", "the ball goes to and fro between two boxes");
    }
    if (!face.slab->restitution.is_zero()) {
      flies();
      partings_.push_back({face.slab->body});
      return record(Event::Kind::release, *face.slab, up, {}, 0, 0);
    }
  }
  rests_on(face, under);
  record(Event::Kind::contact, *face.slab, up, {}, 0, 0);
}

ConstraintTruth Course::run() {
  begin();
  for (;;) {
    const Next change = next();
    const Enclosed end(times_.back());
    const bool over = change.what == Next::What::nothing || !(end - (way_.start + change.tau)).is_positive();
    note_clear(over ? Next{} : change, over ? end - way_.start : change.tau);
    look(over ? end + end : way_.start + change.tau);
    if (over) return truth_;
    way_ = way_.later(change.tau);
    if (change.what == Next::What::slip_stops) {
      const Enclosed rate = law_.slip_rate;
      rests_on(*face_, Slip::none);
      record(Event::Kind::contact, *face_->slab, face_->normal_W(), {}, rate, 0);
    } else if (change.what == Next::What::passes) {
      pass(change.passing);
    } else {
      meet(*change.met);
    }
  }
}

}  // namespace

ConstraintTruth constraint(const Scene& scene) {
  if (!scene.flight) throw InputError("flight", "missing");
  try {
    return Course(scene).run();
  } catch (const Undecided& question) {
    throw InputError("flight", std::string("it cannot be decided ") + question.what());
  }
}

}  // namespace touchstone::reference
