#include "model/input_error.h"
#include "reference/face_contact_impl.h"

namespace touchstone::reference {
namespace {

using Mode = ConstraintTruth::Mode;

Enclosed length(const EnclosedVec& a) { return root(inner(a, a)); }

/// Would friction hold a ball without slip? κ/(1 + κ) |g_t| ≤ μ N.
bool holds(const Ball& ball, const Enclosed& friction, const EnclosedVec& pull) {
  if (is_zero(pull)) return true;
  const Enclosed needed = square(ball.kappa / (1 + ball.kappa)) * inner(pull, pull);
  return sign_of(square(friction) - needed, "whether a ball rolls on a slope") >= 0;
}

/// û, if u keeps its line.
EnclosedVec direction(const EnclosedVec& u, const EnclosedVec& pull, Slip slip) {
  const bool keeps = is_zero(pull) || slip == Slip::straight || is_zero(cross(u, pull));
  if (!keeps) throw InputError("bodies", "the ball slips across a slope: its slip turns");
  const Enclosed size = length(u);
  if (!size.is_positive()) throw Undecided("whether the ball slips");
  return scaled(1 / size, u);
}

}  // namespace

EnclosedVec Face::normal_B() const {
  EnclosedVec n;
  n[axis] = side;
  return n;
}

Enclosed Face::weight() const { return -(Enclosed(side) * slab->gravity[axis]); }

EnclosedVec Face::pull_B() const {
  EnclosedVec pull = slab->gravity;
  pull[axis] = 0;
  return pull;
}

ContactLaw contact_law(const Ball& ball, const Face& face, const Parabola& start, Slip slip) {
  const EnclosedVec n = face.normal_B(), pull = face.pull_B();
  if (sign_of(face.weight(), "whether gravity holds the ball") <= 0) {
    throw InputError("gravity", "nothing holds the ball to the face that it touches");
  }
  const Enclosed friction = face.slab->friction * face.weight();
  EnclosedVec v = face.slab->turned_in(start.v), w = face.slab->turned_in(start.w);
  v[face.axis] = 0;
  EnclosedVec a = pull, alpha;
  ContactLaw law;
  law.mode = Mode::slides;
  const auto slides_along = [&](const EnclosedVec& u) {
    a = minus(pull, scaled(friction, u));
    alpha = scaled(friction / (ball.kappa * ball.radius), cross(n, u));
  };
  if (slip == Slip::none && holds(ball, friction, pull)) {
    law.mode = Mode::rolls;
    a = scaled(1 / (1 + ball.kappa), pull);
    alpha = scaled(1 / ball.radius, cross(n, a));
  } else if (slip == Slip::none) {
    slides_along(scaled(1 / length(pull), pull));
  } else if (!friction.is_zero()) {
    EnclosedVec u = minus(v, scaled(ball.radius, cross(w, n)));
    u[face.axis] = 0;
    const EnclosedVec along = direction(u, pull, slip);
    slides_along(along);
    const Enclosed growth = inner(along, pull) - friction * (1 + 1 / ball.kappa);
    if (sign_of(growth, "whether slip grows") < 0) {
      law.slip_rate = -growth;
      law.slip_stops = length(u) / law.slip_rate;
    }
  }
  const auto out = [&](const EnclosedVec& b) { return face.slab->turned_out(b); };
  law.way = {start.start, start.p, out(v), out(a), out(w), out(alpha)};
  return law;
}

std::optional<Passing> first_passing(const Face& face, const Parabola& way, const Enclosed& horizon) {
  const EnclosedVec p = face.slab->in(way.p), v = face.slab->turned_in(way.v), a = face.slab->turned_in(way.a);
  std::optional<Passing> first;
  for (std::size_t i = 0; i < 3; ++i) {
    if (i == face.axis) continue;
    for (const int side : {1, -1}) {
      // The least root τ > 0 of D = B τ + A τ², D > 0 the way to the edge: 2 D/(B + √(B² + 4 A D)).
      const Enclosed D = face.slab->half[i] - side * p[i], B = side * v[i], A = side * a[i] / 2;
      if ((D - horizon * (magnitude(B) + horizon * magnitude(A))).is_positive()) continue;
      if (B.hi() <= 0 && A.hi() <= 0) continue;
      const Enclosed under = square(B) + 4 * A * D;
      if (under.is_negative()) continue;
      if (!under.is_positive()) throw Undecided("whether the ball reaches the edge");
      const Enclosed speed = root(under), tau = 2 * D / (B + speed);
      if ((tau - horizon).is_positive()) continue;
      if (!first || (first->tau - tau).is_positive()) {
        first = {tau, i, speed};
      } else if ((tau - first->tau).holds_zero()) {
        throw Undecided("which edge the ball passes first");
      }
    }
  }
  return first;
}

Float least_inside(const Face& face, const Parabola& way, const Enclosed& span, std::optional<std::size_t> but) {
  constexpr int pieces = 32;
  const EnclosedVec p = face.slab->in(way.p), v = face.slab->turned_in(way.v), a = face.slab->turned_in(way.a);
  const Enclosed step = span / pieces, within(Float(0), step.hi());
  std::optional<Float> least;
  for (std::size_t i = 0; i < 3; ++i) {
    if (i == face.axis || i == but) continue;
    for (int k = 0; k < pieces; ++k) {
      const Enclosed from = step * k;
      const Enclosed c = p[i] + from * (v[i] + from / 2 * a[i]) + within * (v[i] + from * a[i] + within / 2 * a[i]);
      const Float inside = (face.slab->half[i] - magnitude(c)).lo();
      if (!least || inside < *least) least = inside;
    }
  }
  return *least;
}

}  // namespace touchstone::reference
