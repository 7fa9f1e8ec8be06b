#include "reference/ballistic_motion.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include "model/input_error.h"
#include "reference/exact/float_mode.h"
#include "reference/exact/linear.h"
#include "reference/motion/ballistic_motion.h"

namespace touchstone::reference {
namespace {

using Matrix = std::array<Triple, 3>;

/// λ if two moments of inertia are equal to it. With I's characteristic polynomial x³ + a x² + b x + c, a double root
/// is λ = (9c − ab)/(2(a² − 3b)), a triple one −a/3. It is double exactly if I − λ 1 has rank 1 or less.
std::optional<mpq_class> repeated_moment(const Matrix& I) {
  const mpq_class a = -(I[0][0] + I[1][1] + I[2][2]);
  const mpq_class b = I[0][0] * I[1][1] + I[1][1] * I[2][2] + I[2][2] * I[0][0] - I[0][1] * I[1][0] -
                      I[1][2] * I[2][1] - I[2][0] * I[0][2];
  const mpq_class c = -determinant(I);
  const mpq_class spread = a * a - 3 * b;
  const mpq_class lambda = spread == 0 ? mpq_class(-a / 3) : mpq_class((9 * c - a * b) / (2 * spread));
  Matrix D = I;
  for (std::size_t i = 0; i < 3; ++i) D[i][i] -= lambda;
  for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{0, 1}, {1, 2}, {2, 0}}) {
    const Triple minors = cross(D[i], D[j]);
    if (minors[0] != 0 || minors[1] != 0 || minors[2] != 0) return std::nullopt;
  }
  return lambda;
}

/// Rᵀ a.
Triple in_body(const Motion& X_WB, const Triple& a) {
  return plus(plus(scaled(a[0], X_WB.rows[0]), scaled(a[1], X_WB.rows[1])), scaled(a[2], X_WB.rows[2]));
}

void set_turning(BallisticStart& start, const MovingMass& mass, const Motion& X_WB) {
  start.Omega = start.w;
  const Triple w_B = in_body(X_WB, start.w);
  const Triple L_B = times(mass.inertia, w_B);
  const Triple torque = cross(L_B, w_B);
  if (torque[0] == 0 && torque[1] == 0 && torque[2] == 0) return;  // about a principal axis, or I = λ 1
  const std::optional<mpq_class> lambda = repeated_moment(mass.inertia);
  if (!lambda) {
    start.tumble = std::make_shared<const Tumble>(mass.inertia, start.q, w_B);
    return;
  }
  const mpq_class shrink = 1 / *lambda;
  start.sigma = minus(w_B, scaled(shrink, L_B));
  for (std::size_t i = 0; i < 3; ++i) start.Omega[i] = shrink * dot(X_WB.rows[i], L_B);
}

double start_time(const touchstone::Motion& motion, std::size_t body) {
  return motion.start_times.empty() ? 0 : motion.start_times[body];
}

/// The last applied force that begins by the body's start.
Triple force_on(const touchstone::Motion& motion, std::size_t body) {
  Triple force;
  for (std::size_t i = 0; i < motion.forces.size(); ++i) {
    const AppliedForce& applied = motion.forces[i];
    if (applied.body != static_cast<int>(body)) continue;
    if (applied.time > start_time(motion, body)) {
      throw InputError("motion.forces[" + std::to_string(i) + "]",
                       "begins after its body's start; ask from its time on, by `since`");
    }
    force = triple(applied.force_W);
  }
  return force;
}

}  // namespace

BallisticStart ballistic_start(const Scene& scene, std::size_t index) {
  const Body& body = scene.bodies.at(index);
  const Motion X_WB = motion(body.X_WB);
  const Quaternion& q = body.X_WB.q_WB;
  BallisticStart start;
  start.start_time = start_time(*scene.motion, index);
  start.v = triple(body.velocity.v_WBcm);
  start.w = triple(body.velocity.w_WB);
  start.q = {mpq_class(q.w), mpq_class(q.x), mpq_class(q.y), mpq_class(q.z)};
  // Products of longer or shorter ones may be beyond the doubles in which poses are told.
  const int exponent = std::ilogb(std::max({std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)}));
  if (std::abs(exponent) > 256) {
    const mpq_class scale(std::ldexp(1.0, exponent > 0 ? -512 : 512));
    for (mpq_class& part : start.q) part *= scale;
  }
  for (const mpq_class& part : start.q) start.q_squared += part * part;
  if (std::holds_alternative<Fixed>(body.mass)) {
    start.p = triple(body.X_WB.p_WB);
    start.Omega = start.w;
    return start;
  }
  const MovingMass weight = moving_mass(body, "bodies[" + std::to_string(index) + "]");
  start.pi = weight.pi;
  start.centre = weight.centre;
  start.p = X_WB(weight.centre);
  start.c = plus(triple(scene.gravity), scaled(mpq_class(1 / weight.mass), force_on(*scene.motion, index)));
  set_turning(start, weight, X_WB);
  return start;
}

template <class Tier>
RigidBodyModel<Tier>::RigidBodyModel(const BallisticStart& start)
    : start_time_(enclosed<E>(start.start_time)),
      q_squared_(enclosed<E>(start.q_squared)),
      centre_(enclosed<E>(start.centre)),
      p_(enclosed<E>(start.p)),
      v_(enclosed<E>(start.v)),
      c_(enclosed<E>(start.c)),
      q_{enclosed<E>(start.q[0]), enclosed<E>(start.q[1]), enclosed<E>(start.q[2]), enclosed<E>(start.q[3])},
      outer_(spin<E>(start.Omega)),
      inner_(spin<E>(start.sigma)),
      tumble_(start.tumble) {
  if (start.pi) {  // the rational for π is off by 2^-319; an ulp is more
    for (Coordinates<E>* v : {&centre_, &p_, &c_}) *v = {widened(v->x), widened(v->y), widened(v->z)};
  }
  if (tumble_) {
    turning_ = converted<E>(tumble_->turning());
    return;
  }
  // |ω| and |ω'| = |Ω × (ω − Ω)| are constant.
  const Triple precession = cross(start.Omega, start.w);
  turning_ = enclosed<E>(dot(start.w, start.w)) + length(enclosed<E>(precession));
}

template <class Tier>
BallisticState<typename Tier::E> RigidBodyModel<Tier>::at(const E& time) const {
  const E tau = time - start_time_;
  BallisticState<E> now;
  now.v = v_ + tau * c_;
  now.p = p_ + tau * (v_ + E(tau / E(2)) * c_);
  if (tumble_) {
    const auto turned_to = tumble_->at(tau);
    now.q = turned_to.q;
    now.R = matrix_of(now.q, q_squared_);
    now.w = turned(now.R, turned_to.w_B);
    return now;
  }
  now.q = q_;
  if (!inner_.none) now.q = now.q * turn(inner_, tau);
  if (!outer_.none) now.q = turn(outer_, tau) * now.q;
  now.R = matrix_of(now.q, q_squared_);
  now.w = {E(0), E(0), E(0)};
  if (!inner_.none) now.w = turned(now.R, Coordinates<E>(inner_.rate * inner_.axis));
  if (!outer_.none) now.w = now.w + outer_.rate * outer_.axis;
  return now;
}

template class RigidBodyModel<InDoubles>;
template class RigidBodyModel<InWide>;

namespace {

std::array<Interval, 3> in_doubles(const Coordinates<WideEnclosure>& v) {
  return {reference::in_doubles(v.x), reference::in_doubles(v.y), reference::in_doubles(v.z)};
}

}  // namespace

BallisticTruth ballistic_state(const Scene& scene, std::size_t body, double time) {
  if (!scene.motion) throw InputError("motion", "missing; expected one for a question about motion");
  if (time < start_time(*scene.motion, body))
    throw InputError("motion.start_times", "the body has not started yet at this time");
  const DefaultFloatMode mode;
  const RigidBodyModel<InWide> model(ballistic_start(scene, body));
  const BallisticState<WideEnclosure> now = model.at(thin(Float(time)));
  const Coordinates<WideEnclosure> p_WB = now.p - turned(now.R, model.centre());
  BallisticTruth truth;
  truth.p_WB = in_doubles(p_WB);
  for (std::size_t i = 0; i < 4; ++i) truth.q_WB[i] = reference::in_doubles(now.q[i]);
  for (std::size_t i = 0; i < 9; ++i) truth.R_WB[i / 3][i % 3] = reference::in_doubles(now.R[i]);
  truth.v_WBcm = in_doubles(now.v);
  truth.w_WB = in_doubles(now.w);
  return truth;
}

}  // namespace touchstone::reference
