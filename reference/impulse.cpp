#include "reference/impulse.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "reference/float_impl.h"
#include "reference/impact_impl.h"
#include "reference/impact_law_impl.h"
#include "reference/impact_lines_impl.h"
#include "reference/impact_root_impl.h"
#include "reference/impact_slide_impl.h"
#include "reference/rational_impl.h"

namespace touchstone::reference {
namespace {

bool zero(const Triple& a) { return sgn(a[0]) == 0 && sgn(a[1]) == 0 && sgn(a[2]) == 0; }
bool parallel(const Triple& a, const Triple& b) { return zero(cross(a, b)); }

/// (μ ν)², and 0 for friction without limit: nobody reads it then.
mpq_class cone_of(const Impact& impact, const mpq_class& square) {
  return impact.mu ? mpq_class(*impact.mu * *impact.mu * square) : mpq_class(0);
}

/// Slip keeps its direction w/|w| iff it is not turned: m·K(N − μν w/|w|) = 0 for the m ⊥ w, that is m·K N and m·K w
/// are both 0, or of one sign with (m·K N)² |w|² = (μν)² (m·K w)².
bool keeps_direction(const Impact& impact, const Triple& w, const mpq_class& cone) {
  const Triple m = cross(impact.N, w);
  const mpq_class by_normal = dot(m, times(impact.K, impact.N));
  const mpq_class by_friction = dot(m, times(impact.K, w));
  if (sgn(by_normal) != sgn(by_friction)) return false;
  return by_normal * by_normal * dot(w, w) == cone * by_friction * by_friction;
}

Blow<mpq_class> blow_of(const Impact& impact) {
  Blow<mpq_class> blow;
  blow.K = impact.K;
  blow.K_inverse = inverted(impact.K);
  blow.u0 = impact.u0;
  blow.N = impact.N;
  blow.square = dot(blow.N, blow.N);
  blow.cone = cone_of(impact, blow.square);
  blow.e = impact.e;
  blow.law = impact.law;
  Facts& facts = blow.facts;
  const Triple w = blow.tangential(blow.u0);
  const Triple stick = minus(sticking_zeta(blow), blow.N);
  const Triple pull = blow.tangential(times(blow.K, blow.N));
  const mpq_class rise = dot(blow.N, times(blow.K, blow.N)) / blow.square;
  facts.separating = sgn(dot(blow.u0, blow.N)) >= 0;
  facts.frictionless = impact.mu && sgn(*impact.mu) == 0;
  facts.no_limit = !impact.mu;
  facts.slips = !zero(w);
  facts.straight = facts.slips && !facts.no_limit && keeps_direction(impact, w, blow.cone);
  facts.rest_sticks = facts.no_limit || dot(stick, stick) <= blow.cone;
  facts.rest_turns = parallel(stick, blow.tangential(times(blow.K, stick)));
  facts.painleve = blow.cone * dot(pull, pull) > rise * rise * blow.square * blow.square;
  return blow;
}

/// In floats, with N of length 1.
Blow<Float> unit_normal(const Blow<mpq_class>& exact) {
  Blow<Float> blow;
  blow.K = float_of(exact.K);
  blow.K_inverse = float_of(exact.K_inverse);
  blow.u0 = float_of(exact.u0);
  blow.N = scaled(Float(1 / sqrt(float_of(exact.square))), float_of(exact.N));
  blow.square = 1;
  blow.cone = float_of(mpq_class(exact.cone / exact.square));
  blow.e = float_of(exact.e);
  blow.law = exact.law;
  blow.facts = exact.facts;
  return blow;
}

template <class T>
struct Outcome {
  Moment<T> end;
  T p_c;
  std::optional<T> stopped, near_jump;
  bool recompressed;
};

template <class T, class Course>
Outcome<T> walked(const Blow<T>& blow, Course course) {
  Walk<T> walk(blow, before(blow));
  while (!walk.done()) {
    const std::unique_ptr<Stretch<T>> stretch = course.next(walk);
    walk.along(*stretch);
  }
  return {walk.now(), walk.p_c(), course.stopped(), walk.near_jump(), walk.recompressed()};
}

bool on_lines(const Facts& facts) { return facts.frictionless || facts.no_limit || !facts.slips || facts.straight; }

Outcome<mpq_class> exactly(const Blow<mpq_class>& blow) {
  if (!on_lines(blow.facts)) throw Irrational();
  return walked(blow, Lines<mpq_class>(blow));
}

Outcome<Float> nearly(const Blow<Float>& blow) {
  return on_lines(blow.facts) ? walked(blow, Lines<Float>(blow)) : walked(blow, Slide(blow));
}

template <class T>
void set_modes(ImpulseTruth::Modes& modes, const Blow<mpq_class>& blow, const Outcome<T>& outcome) {
  const Facts& facts = blow.facts;
  modes.frictionless = facts.frictionless;
  modes.straight = facts.straight && !facts.frictionless;
  modes.painleve = facts.painleve;
  modes.recompressed = outcome.recompressed;
  modes.stuck_from_start = !facts.frictionless && !facts.slips && facts.rest_sticks;
  if (!outcome.stopped || *outcome.stopped > outcome.end.p) return;
  if (facts.slips)
    (*outcome.stopped <= outcome.p_c ? modes.slip_stops_in_compression : modes.slip_stops_in_restitution) = true;
  modes.sticks = facts.rest_sticks;
  modes.diverges = !facts.rest_sticks;
  const Triple w = blow.tangential(blow.u0);
  const Triple leaves = minus(blow.N, sticking_zeta(blow));
  modes.reversal = modes.diverges && facts.slips && facts.rest_turns && parallel(w, leaves);
}

ExactVec3 vec_of(const Triple& a) { return {rational_of(a[0]), rational_of(a[1]), rational_of(a[2])}; }

ExactVelocity after(const Body& body, const Response& response, const Triple& P) {
  return {vec_of(plus(triple(body.velocity.v_WBcm), response.linear(P))),
          vec_of(plus(triple(body.velocity.w_WB), response.angular(P)))};
}

/// √(u0ᵀ K⁻¹ u0), the scale of all errors.
Float energy_norm(const Blow<mpq_class>& blow) { return sqrt(float_of(dot(blow.u0, times(blow.K_inverse, blow.u0)))); }

/// Farther away, a jump is none of this scene's.
constexpr double ambiguity = 1e-9;

/// Where μ |K_tn| ≤ K_nn, U never falls and there is no jump; rounding must not make one.
void set_ambiguous(ImpulseTruth& truth, const Blow<mpq_class>& blow, const Float& missing_u_n) {
  if (!blow.facts.painleve) return;
  const Float rise = sqrt(float_of(mpq_class(dot(blow.N, times(blow.K, blow.N)) / blow.square)));
  const Float scale = rise * energy_norm(blow);
  if (missing_u_n <= ambiguity * scale) truth.ambiguous = scale == 0 ? 0 : static_cast<double>(missing_u_n / scale);
}

/// Series are cut at 2^-165 and floats have 254 bits; 2^-150 is 45 digits and leaves 2^15 for what steps add up. The
/// second term is what 254 bits leave of an ill-conditioned K.
double stated_error(const Blow<mpq_class>& blow) {
  const auto trace = [](const std::array<Triple, 3>& M) { return float_of(mpq_class(M[0][0] + M[1][1] + M[2][2])); };
  const Float condition = trace(blow.K) * trace(blow.K_inverse);
  const Float bound = energy_norm(blow) * (ldexp(Float(1), -150) + condition * ldexp(Float(1), -240));
  return std::max(std::nextafter(static_cast<double>(bound), std::numeric_limits<double>::infinity()),
                  std::numeric_limits<double>::denorm_min());
}

/// Of the normal, not of N: ν is a root in general, so these are within 2^-260 even where P is exact.
void set_normal_impulses(ImpulseTruth& truth, const mpq_class& square, const mpq_class& p_c, const mpq_class& p_f) {
  const auto times_length = [&](const mpq_class& p) {
    if (square == 1) return p;
    return exact_of(Float(sqrt(float_of(square)) * float_of(p)));
  };
  truth.p_c = rational_of(times_length(p_c));
  truth.p_f = rational_of(times_length(p_f));
}

Triple strike(ImpulseTruth& truth, const Blow<mpq_class>& blow) {
  const Float length = sqrt(float_of(blow.square));
  try {
    const Outcome<mpq_class> outcome = exactly(blow);
    set_modes(truth.modes, blow, outcome);
    set_normal_impulses(truth, blow.square, outcome.p_c, outcome.end.p);
    if (outcome.near_jump) set_ambiguous(truth, blow, float_of(*outcome.near_jump) / length);
    truth.certified = !truth.pi;
    return outcome.end.P;
  } catch (const Irrational&) {
    const Outcome<Float> outcome = nearly(unit_normal(blow));
    set_modes(truth.modes, blow, outcome);
    truth.p_c = rational_of(exact_of(outcome.p_c));
    truth.p_f = rational_of(exact_of(outcome.end.p));
    if (outcome.near_jump) set_ambiguous(truth, blow, *outcome.near_jump);
    return exact_of(outcome.end.P);
  }
}

/// u_n just above 0 where it would fall: were it just below 0, the impact would not be small.
void set_ambiguous_if_grazing(ImpulseTruth& truth, const Blow<mpq_class>& exact) {
  if (!exact.facts.painleve || !exact.facts.slips) return;
  const Blow<Float> blow = unit_normal(exact);
  const Three<Float> w = blow.tangential(blow.u0);
  const Three<Float> zeta = minus(blow.N, scaled(Float(sqrt(blow.cone / inner(w, w))), w));
  if (inner(blow.N, times(blow.K, zeta)) < 0) set_ambiguous(truth, exact, inner(blow.u0, blow.N));
}

}  // namespace

ImpulseTruth impulse(const Scene& scene) {
  const Impact hit = impact(scene);
  const Blow<mpq_class> blow = blow_of(hit);
  ImpulseTruth truth;
  truth.K_W = {vec_of(hit.K[0]), vec_of(hit.K[1]), vec_of(hit.K[2])};
  truth.u0_W = vec_of(hit.u0);
  truth.pi = hit.pi;
  Triple P;
  if (blow.facts.separating) {
    truth.modes.separating = true;
    truth.certified = true;
    set_ambiguous_if_grazing(truth, blow);
  } else {
    P = strike(truth, blow);
  }
  if (!truth.certified) truth.error = stated_error(blow);
  truth.P_A_W = vec_of(P);
  truth.after = {after(scene.bodies[0], hit.bodies[0], P), after(scene.bodies[1], hit.bodies[1], minus(Triple{}, P))};
  return truth;
}

}  // namespace touchstone::reference
