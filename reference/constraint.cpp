#include "reference/constraint.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "model/input_error.h"
#include "reference/constraint/face_contact.h"
#include "reference/exact/rational.h"

namespace touchstone::reference {
namespace {

using Mode = ConstraintTruth::Mode;
using Change = ConstraintTruth::Change;

constexpr std::size_t most_changes = 40;

Enclosed length(const EnclosedVec& a) { return root(inner(a, a)); }
EnclosedVec enclosed(const Triple& a) { return {Enclosed(a[0]), Enclosed(a[1]), Enclosed(a[2])}; }
std::string place(std::size_t body) { return "bodies[" + std::to_string(body) + "]"; }
Vec3 nearest_doubles(const EnclosedVec& a) {
  Vec3 v;
  for (std::size_t i = 0; i < 3; ++i) v[static_cast<Eigen::Index>(i)] = a[i].middle().convert_to<double>();
  return v;
}

std::array<Interval, 3> in_doubles(const EnclosedVec& a) {
  return {a[0].in_doubles(), a[1].in_doubles(), a[2].in_doubles()};
}

BallTruth ball_truth(const Parabola& path) { return {in_doubles(path.p), in_doubles(path.v), in_doubles(path.w)}; }

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

RollingBall ball_of(const Body& body, std::size_t index) {
  const mpq_class r = std::get<Sphere>(body.shape).radius;
  const auto* given = std::get_if<MassProperties>(&body.mass);
  if (given == nullptr) {
    // The impulse is reported only to the nearest double: π to 53 bits is enough for the mass, which enters nothing
    // else.
    const double mass = std::get<Density>(body.mass).value * 4 * 3.14159265358979323846 / 3;
    return {Enclosed(r), Enclosed(mass) * Enclosed(mpq_class(r * r * r)), Enclosed(mpq_class(2, 5))};
  }
  const double I = given->I_BBcm_B(0, 0);
  if (given->p_BBcm != Vec3::Zero() || given->I_BBcm_B != Mat3(I * Mat3::Identity())) {
    throw InputError(place(index) + ".mass", "a ball that is not the same all round");
  }
  return {Enclosed(r), Enclosed(given->mass), Enclosed(mpq_class(mpq_class(I) / (mpq_class(given->mass) * r * r)))};
}

/// The ball's position relative to a box at the start, decided in rationals.
struct Start {
  int apart = 0;  ///< sign of the distance
  std::optional<Face> face;
  int approach = 0;  ///< for a face in contact: sign of v·n
  SlipKnowledge slip = SlipKnowledge::any;
};

class Simulation {
 public:
  explicit Simulation(const Scene& scene);
  ConstraintTruth run();

 private:
  FixedBox fixed_box(std::size_t index) const;
  Start start_of(const FixedBox& box) const;
  void begin();
  void set_resting(const Face& face, SlipKnowledge slip);
  void set_ballistic();

  struct Next {
    enum class What { nothing, slip_stops, crosses_edge, touches };
    What what = What::nothing;
    Enclosed tau;
    EdgeCrossing crossing;
    const FixedBox* touched_box = nullptr;
  };
  Next next() const;
  void sample_until(const Enclosed& until);
  void cross_edge(const EdgeCrossing& crossing);
  Parabola after(const Next& change) const;
  void handle_contact(const FixedBox& box);
  SlipKnowledge apply_impulse(const FixedBox& box, const EnclosedVec& n_B);
  void land(const FixedBox& box, const EnclosedVec& over, SlipKnowledge slip);
  void record(Event::Kind kind, const FixedBox& box, const EnclosedVec& n, const EnclosedVec& P, const Enclosed& rate,
              const Enclosed& velocity_jump);
  void note_clearance(const Next& change, const Enclosed& span);
  void note_speed();
  Enclosed acceleration() const;

  const Scene& scene_;
  const std::vector<double>& times_;
  ConstraintTruth truth_;
  std::size_t index_;
  RollingBall ball_;
  std::vector<FixedBox> boxes_;
  EnclosedVec gravity_;

  Parabola path_;
  Mode mode_ = Mode::ballistic;
  std::optional<Face> face_;
  ContactLaw law_;
  std::vector<LeavingContact> leaving_contacts_;
};

Simulation::Simulation(const Scene& scene)
    : scene_(scene), times_(scene.motion->sample_times), index_(only_ball(scene)) {
  const touchstone::Motion& motion = *scene.motion;
  if (!motion.forces.empty()) throw InputError("motion.forces", "a ball that is pushed");
  for (const double start : motion.start_times) {
    if (start != 0) throw InputError("motion.start_times", "a body that starts later than another");
  }
  const Body& body = scene.bodies[index_];
  truth_.ball = static_cast<int>(index_);
  ball_ = ball_of(body, index_);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (i != index_) boxes_.push_back(fixed_box(i));
  }
  gravity_ = enclosed(triple(scene.gravity));
  path_ = {0,        enclosed(triple(body.X_WB.p_WB)),     enclosed(triple(body.velocity.v_WBcm)),
           gravity_, enclosed(triple(body.velocity.w_WB)), {}};
}

FixedBox Simulation::fixed_box(std::size_t index) const {
  const Body& body = scene_.bodies[index];
  const Motion X_WB = motion(body.X_WB);
  FixedBox box;
  box.body = static_cast<int>(index);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) box.axes[i][j] = Enclosed(X_WB.rows[j][i]);
  }
  box.origin = enclosed(X_WB.translation);
  box.half = enclosed(triple(std::get<Box>(body.shape).half_extents));
  box.gravity = enclosed(turned_in(X_WB, triple(scene_.gravity)));
  const Material& ball = scene_.bodies[index_].material;
  box.friction = std::min(ball.friction, body.material.friction);
  box.restitution = std::min(ball.restitution, body.material.restitution);
  return box;
}

Start Simulation::start_of(const FixedBox& box) const {
  const Body &body = scene_.bodies[static_cast<std::size_t>(box.body)], &ball = scene_.bodies[index_];
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
  start.face = Face{&box, axis, sgn(c[axis])};
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
  start.slip = zero(u) ? SlipKnowledge::none : zero(across) ? SlipKnowledge::straight : SlipKnowledge::any;
  return start;
}

Enclosed Simulation::acceleration() const {
  const Enclosed spin = ball_.radius * length(path_.alpha), centre = length(path_.a);
  return hull(spin, centre);
}

void Simulation::note_speed() {
  const Enclosed centre = length(path_.v), spin = ball_.radius * length(path_.w);
  truth_.speed = std::max({truth_.speed, centre.in_doubles().hi, spin.in_doubles().hi});
}

void Simulation::record(Event::Kind kind, const FixedBox& box, const EnclosedVec& n, const EnclosedVec& P,
                        const Enclosed& rate, const Enclosed& velocity_jump) {
  if (truth_.changes.size() == most_changes) throw InputError("motion", "more changes than are followed");
  note_speed();
  Change change;
  change.kind = kind;
  change.time = path_.start.in_doubles();
  change.other = box.body;
  change.p_WC = nearest_doubles(minus(path_.p, scaled(ball_.radius, n)));
  change.nhat_W = nearest_doubles(n);
  change.P_W = nearest_doubles(P);
  change.segment.mode = mode_;
  change.rate = rate.in_doubles().lo;
  change.velocity_jump = velocity_jump.in_doubles().hi;
  change.segment.acceleration = acceleration().in_doubles().hi;
  change.after = ball_truth(path_);
  truth_.changes.push_back(std::move(change));
}

/// Sets the lower bound of the distance to any other change. Leaves out boxes that the ball has just left or touches
/// next: the changes themselves are about these.
void Simulation::note_clearance(const Next& change, const Enclosed& span) {
  Float clearance = ldexp(Float(1), 1000);  // if there is nothing else
  if (face_) {
    const bool crosses_edge = change.what == Next::What::crosses_edge;
    clearance = std::min(clearance, least_inside(*face_, path_, span,
                                                 crosses_edge ? std::optional(change.crossing.over) : std::nullopt));
  }
  for (const FixedBox& box : boxes_) {
    const bool parts =
        std::ranges::any_of(leaving_contacts_, [&](const LeavingContact& p) { return p.body == box.body; });
    if (parts || &box == change.touched_box || (face_ && face_->box == &box)) continue;
    clearance = std::min(clearance, least_distance(path_, box, ball_.radius, span));
  }
  const double bound = Enclosed(clearance, clearance).in_doubles().lo;
  (truth_.changes.empty() ? truth_.first : truth_.changes.back().segment).clearance = bound;
}

void Simulation::set_ballistic() {
  mode_ = Mode::ballistic;
  face_.reset();
  law_ = {};
  path_.a = gravity_;
  path_.alpha = {};
}

void Simulation::set_resting(const Face& face, SlipKnowledge slip) {
  face_ = face;
  law_ = contact_law(ball_, face, path_, slip);
  mode_ = law_.mode;
  path_ = law_.path;
}

void Simulation::begin() {
  note_speed();
  std::optional<Start> touched;
  for (const FixedBox& box : boxes_) {
    const Start start = start_of(box);
    if (start.apart < 0) throw InputError(place(static_cast<std::size_t>(box.body)), "overlaps the ball at the start");
    if (start.apart > 0) continue;
    if (touched) throw InputError("bodies", "the ball starts between two boxes");
    touched = start;
  }
  truth_.first.acceleration = acceleration().in_doubles().hi;
  if (!touched) return;
  const Face& face = *touched->face;
  const EnclosedVec n = face.normal_W();
  if (touched->approach > 0) {
    leaving_contacts_ = {{face.box->body}};
  } else if (touched->approach == 0) {
    set_resting(face, touched->slip);
    record(Event::Kind::contact, *face.box, n, {}, 0, 0);
  } else {
    handle_contact(*face.box);
  }
  truth_.first.mode = mode_;
  truth_.first.acceleration = acceleration().in_doubles().hi;
}

Simulation::Next Simulation::next() const {
  Enclosed horizon = Enclosed(times_.back()) - path_.start;
  horizon = horizon * Enclosed(1.0009765625);  // past the end, so that a change at the end does not count
  std::vector<Next> all;
  if (law_.slip_stops) all.push_back({Next::What::slip_stops, *law_.slip_stops, {}, nullptr});
  if (face_) {
    if (const auto crossing = first_edge_crossing(*face_, path_, horizon)) {
      all.push_back({Next::What::crosses_edge, crossing->tau, *crossing, nullptr});
    }
  }
  for (const FixedBox& box : boxes_) {
    if (face_ && face_->box == &box) continue;
    std::optional<LeavingContact> leaving;
    for (const LeavingContact& p : leaving_contacts_) {
      if (p.body == box.body) leaving = p;
    }
    // Searches only up to the first change found so far: after it the ball leaves this path.
    Enclosed until = horizon;
    for (const Next& n : all) {
      if ((until - n.tau).is_positive()) until = n.tau * Enclosed(1.0009765625);
    }
    if (const auto tau = first_contact(path_, box, ball_.radius, until, leaving)) {
      all.push_back({Next::What::touches, *tau, {}, &box});
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

void Simulation::sample_until(const Enclosed& until) {
  while (truth_.states.size() < times_.size()) {
    const Enclosed time(times_[truth_.states.size()]);
    if (!(until - time).is_positive()) return;
    const Parabola then = path_.later(time - path_.start);
    truth_.states.push_back(ball_truth(then));
    const Enclosed centre = length(then.v), spin = ball_.radius * length(then.w);
    truth_.speed = std::max({truth_.speed, centre.in_doubles().hi, spin.in_doubles().hi});
  }
}

/// The ball crosses the edge. It becomes ballistic if it falls more slowly than it would round the edge, v² > r N;
/// otherwise it would pivot.
void Simulation::cross_edge(const EdgeCrossing& crossing) {
  const Face face = *face_;
  const EnclosedVec n = face.normal_W();
  if (sign_of(square(crossing.speed) - ball_.radius * face.weight(), "whether the ball flies off the edge") < 0) {
    throw InputError("bodies", "the ball is so slow that it pivots about the edge");
  }
  set_ballistic();
  leaving_contacts_ = {{face.box->body, true, face.axis, crossing.over}};
  record(Event::Kind::release, *face.box, n, {}, crossing.speed, 0);
}

/// The part of u perpendicular to the unit vector n; exact if n is an axis.
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

/// The axis whose coordinate is certainly not 0 while the other two certainly are: the centre is over a face.
std::optional<std::size_t> only_axis(const EnclosedVec& over) {
  for (std::size_t i = 0; i < 3; ++i) {
    const bool others = over[(i + 1) % 3].is_zero() && over[(i + 2) % 3].is_zero();
    if (others && !over[i].holds_zero()) return i;
  }
  return std::nullopt;
}

/// The unit vector from the nearest point of a box to the ball's centre.
EnclosedVec normal(const EnclosedVec& over, const Enclosed& radius) {
  EnclosedVec n = scaled(1 / radius, over);
  if (const auto axis = only_axis(over)) n[*axis] = over[*axis].is_positive() ? 1 : -1;
  return n;
}

/// Applies the impulse at a point with normal n: P_n = (1 + e) m |u_n|; friction stops the slip if κ/(1 + κ) |u_t| ≤ μ
/// P_n/m. Returns what is known of the slip afterwards.
SlipKnowledge Simulation::apply_impulse(const FixedBox& box, const EnclosedVec& n_B) {
  const EnclosedVec n = box.turned_out(n_B);
  const Enclosed approach = -inner(path_.v, n);
  const Enclosed push = (1 + box.restitution) * approach;
  const EnclosedVec u = box.turned_in(minus(path_.v, scaled(ball_.radius, cross(path_.w, n))));
  const EnclosedVec slip = box.turned_out(across(u, n_B));
  const Enclosed sticking = ball_.kappa / (1 + ball_.kappa);
  const EnclosedVec needed = scaled(-sticking, slip);
  const Enclosed most = box.friction * push;
  EnclosedVec drag = needed;
  SlipKnowledge after = SlipKnowledge::none;
  if (!is_zero(slip) && sign_of(square(most) - inner(needed, needed), "whether an impact stops slip") < 0) {
    drag = most.is_zero() ? EnclosedVec{} : scaled(-(most / length(slip)), slip);
    after = SlipKnowledge::any;
  }
  const EnclosedVec jump = plus(scaled(push, n), drag);
  const EnclosedVec spin = scaled(-(1 / (ball_.kappa * ball_.radius)), cross(n, drag));
  // v + jump; its part along n is e times the approach, which has fewer roundings.
  const EnclosedVec kept = plus(box.turned_out(across(box.turned_in(path_.v), n_B)), drag);
  const EnclosedVec rebound = plus(kept, scaled(box.restitution * approach, n));
  path_.v = shared(plus(path_.v, jump), rebound);
  path_.w = plus(path_.w, spin);
  record(Event::Kind::impact, box, n, scaled(ball_.mass, jump), approach,
         hull(length(jump), ball_.radius * length(spin)));
  if (!only_axis(n_B)) truth_.changes.back().curvature = (1 / ball_.radius).in_doubles().hi;
  return after;
}

/// The ball stays on the face after an impact without restitution.
void Simulation::land(const FixedBox& box, const EnclosedVec& over, SlipKnowledge slip) {
  const auto axis = only_axis(over);
  if (!axis) throw InputError("bodies", "the ball comes to rest on an edge");
  set_resting({&box, *axis, over[*axis].is_positive() ? 1 : -1}, slip);
  leaving_contacts_.clear();
  record(Event::Kind::contact, box, face_->normal_W(), {}, 0, 0);
}

Parabola Simulation::after(const Next& change) const {
  const Parabola path = path_.later(change.tau);
  if (change.what != Next::What::touches) return path;
  const auto axis = only_axis(excess(*change.touched_box, path.p));
  return axis ? at_face(path_, change.tau, *change.touched_box, *axis, ball_.radius) : path;
}

void Simulation::handle_contact(const FixedBox& box) {
  const EnclosedVec over = excess(box, path_.p);
  const EnclosedVec n_B = normal(over, ball_.radius), n = box.turned_out(n_B);
  if (!face_) set_ballistic();
  const EnclosedVec before = path_.v;
  const SlipKnowledge slip = apply_impulse(box, n_B);
  if (!face_) {
    if (box.restitution.is_zero()) return land(box, over, slip);
    leaving_contacts_ = {{box.body}};
    return;
  }
  if (box.restitution.is_zero()) throw InputError("bodies", "the ball stays between two boxes");
  const Face face = *face_;
  const EnclosedVec up = face.normal_W();
  const int lifts = sign_of(inner(minus(path_.v, before), up), "whether an impact lifts the ball");
  leaving_contacts_ = {{box.body}};
  if (lifts > 0) {
    set_ballistic();
    leaving_contacts_.push_back({face.box->body});
    return record(Event::Kind::release, *face.box, up, {}, 0, 0);
  }
  SlipKnowledge under = SlipKnowledge::any;
  if (lifts < 0) {
    under = apply_impulse(*face.box, face.normal_B());
    if (sign_of(inner(path_.v, n), "whether the ball leaves a box") <= 0) {
      throw InputError("bodies", "the ball goes to and fro between two boxes");
    }
    if (!face.box->restitution.is_zero()) {
      set_ballistic();
      leaving_contacts_.push_back({face.box->body});
      return record(Event::Kind::release, *face.box, up, {}, 0, 0);
    }
  }
  set_resting(face, under);
  record(Event::Kind::contact, *face.box, up, {}, 0, 0);
}

ConstraintTruth Simulation::run() {
  begin();
  for (;;) {
    const Next change = next();
    const Enclosed end(times_.back());
    const bool over = change.what == Next::What::nothing || !(end - (path_.start + change.tau)).is_positive();
    note_clearance(over ? Next{} : change, over ? end - path_.start : change.tau);
    sample_until(over ? end + end : path_.start + change.tau);
    if (over) return truth_;
    path_ = after(change);
    if (change.what == Next::What::slip_stops) {
      const Enclosed rate = law_.slip_rate;
      set_resting(*face_, SlipKnowledge::none);
      record(Event::Kind::contact, *face_->box, face_->normal_W(), {}, rate, 0);
    } else if (change.what == Next::What::crosses_edge) {
      cross_edge(change.crossing);
    } else {
      handle_contact(*change.touched_box);
    }
  }
}

}  // namespace

ConstraintTruth constraint(const Scene& scene) {
  if (!scene.motion) throw InputError("motion", "missing");
  try {
    return Simulation(scene).run();
  } catch (const Undecided& question) {
    throw InputError("motion", std::string("it cannot be decided ") + question.what());
  }
}

}  // namespace touchstone::reference
