#include "reference/constraint/face_contact.h"

#include "model/input_error.h"

namespace touchstone::reference {
namespace {

using Mode = ConstraintTruth::Mode;

Enclosed length(const EnclosedVec& a) { return root(inner(a, a)); }

/// Can friction prevent slip? It can if κ/(1 + κ) |g_t| ≤ μ N.
bool holds(const RollingBall& ball, const Enclosed& friction, const EnclosedVec& acceleration) {
  if (is_zero(acceleration)) return true;
  const Enclosed needed = square(ball.kappa / (1 + ball.kappa)) * inner(acceleration, acceleration);
  return sign_of(square(friction) - needed, "whether a ball rolls on a slope") >= 0;
}

/// û, if the slip u keeps its direction.
EnclosedVec direction(const EnclosedVec& u, const EnclosedVec& acceleration, SlipKnowledge slip) {
  const bool keeps = is_zero(acceleration) || slip == SlipKnowledge::straight || is_zero(cross(u, acceleration));
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

Enclosed Face::weight() const { return -(Enclosed(side) * box->gravity[axis]); }

EnclosedVec Face::tangential_gravity_B() const {
  EnclosedVec acceleration = box->gravity;
  acceleration[axis] = 0;
  return acceleration;
}

ContactLaw contact_law(const RollingBall& ball, const Face& face, const Parabola& start, SlipKnowledge slip) {
  const EnclosedVec n = face.normal_B(), acceleration = face.tangential_gravity_B();
  if (sign_of(face.weight(), "whether gravity holds the ball") <= 0) {
    throw InputError("gravity", "nothing holds the ball to the face that it touches");
  }
  const Enclosed friction = face.box->friction * face.weight();
  EnclosedVec v = face.box->turned_in(start.v), w = face.box->turned_in(start.w);
  v[face.axis] = 0;
  EnclosedVec a = acceleration, alpha;
  ContactLaw law;
  law.mode = Mode::sliding;
  const auto slides_along = [&](const EnclosedVec& u) {
    a = minus(acceleration, scaled(friction, u));
    alpha = scaled(friction / (ball.kappa * ball.radius), cross(n, u));
  };
  if (slip == SlipKnowledge::none && holds(ball, friction, acceleration)) {
    law.mode = Mode::rolling;
    a = scaled(1 / (1 + ball.kappa), acceleration);
    alpha = scaled(1 / ball.radius, cross(n, a));
  } else if (slip == SlipKnowledge::none) {
    slides_along(scaled(1 / length(acceleration), acceleration));
  } else if (!friction.is_zero()) {
    EnclosedVec u = minus(v, scaled(ball.radius, cross(w, n)));
    u[face.axis] = 0;
    const EnclosedVec along = direction(u, acceleration, slip);
    slides_along(along);
    const Enclosed growth = inner(along, acceleration) - friction * (1 + 1 / ball.kappa);
    if (sign_of(growth, "whether slip grows") < 0) {
      law.slip_rate = -growth;
      law.slip_stops = length(u) / law.slip_rate;
    }
  }
  const auto out = [&](const EnclosedVec& b) { return face.box->turned_out(b); };
  law.path = {start.start, start.p, out(v), out(a), out(w), out(alpha)};
  return law;
}

std::optional<EdgeCrossing> first_edge_crossing(const Face& face, const Parabola& path, const Enclosed& horizon) {
  const EnclosedVec p = face.box->in(path.p), v = face.box->turned_in(path.v), a = face.box->turned_in(path.a);
  std::optional<EdgeCrossing> first;
  for (std::size_t i = 0; i < 3; ++i) {
    if (i == face.axis) continue;
    for (const int side : {1, -1}) {
      // The least root τ > 0 of D = B τ + A τ², with D > 0 the distance to the edge: 2 D/(B + √(B² + 4 A D)).
      const Enclosed D = face.box->half[i] - side * p[i], B = side * v[i], A = side * a[i] / 2;
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

Float least_inside(const Face& face, const Parabola& path, const Enclosed& span, std::optional<std::size_t> but) {
  constexpr int pieces = 32;
  const EnclosedVec p = face.box->in(path.p), v = face.box->turned_in(path.v), a = face.box->turned_in(path.a);
  const Enclosed step = span / pieces, within(Float(0), step.hi());
  std::optional<Float> least;
  for (std::size_t i = 0; i < 3; ++i) {
    if (i == face.axis || i == but) continue;
    for (int k = 0; k < pieces; ++k) {
      const Enclosed from = step * k;
      const Enclosed c = p[i] + from * (v[i] + from / 2 * a[i]) + within * (v[i] + from * a[i] + within / 2 * a[i]);
      const Float inside = (face.box->half[i] - magnitude(c)).lo();
      if (!least || inside < *least) least = inside;
    }
  }
  return *least;
}

}  // namespace touchstone::reference
