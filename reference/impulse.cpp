#include "reference/impulse.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "model/input_error.h"
#include "reference/double_double_impl.h"
#include "reference/float_impl.h"
#include "reference/impact_impl.h"
#include "reference/impact_law_impl.h"
#include "reference/impact_lines_impl.h"
#include "reference/impact_root_impl.h"
#include "reference/impact_slide_impl.h"
#include "reference/impact_sweep_impl.h"
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

/// A power of two that brings x > 0 near 1.
int exponent_to_one(const Float& x) { return -static_cast<int>(mpfr_get_exp(x.backend().data())); }

/// The impact in other units of mass and velocity, powers of two that bring K and u0 near 1: P is 2^shift times that of
/// the scene.
struct Scaled {
  Blow<DoubleDouble> blow;
  int shift = 0;
  int shift_of_u = 0;  ///< u is 2^shift_of_u times that of the scene
};

DoubleDouble double_double(const Float& x, int shift) {
  const Float scaled = ldexp(x, shift);
  const auto hi = static_cast<double>(scaled);
  return {hi, static_cast<double>(Float(scaled - hi))};
}

Three<DoubleDouble> double_double(const Three<Float>& a, int shift) {
  return {double_double(a[0], shift), double_double(a[1], shift), double_double(a[2], shift)};
}

Square<DoubleDouble> double_double(const Square<Float>& M, int shift) {
  return {double_double(M[0], shift), double_double(M[1], shift), double_double(M[2], shift)};
}

Scaled in_double_doubles(const Blow<Float>& blow) {
  const int for_K = exponent_to_one(Float(blow.K[0][0] + blow.K[1][1] + blow.K[2][2]));
  const int for_u = exponent_to_one(Float(abs(blow.u0[0]) + abs(blow.u0[1]) + abs(blow.u0[2])));
  Scaled result;
  result.shift = for_u - for_K;
  result.shift_of_u = for_u;
  result.blow.K = double_double(blow.K, for_K);
  result.blow.K_inverse = double_double(blow.K_inverse, -for_K);
  result.blow.u0 = double_double(blow.u0, for_u);
  result.blow.N = double_double(blow.N, 0);
  result.blow.square = 1.0;
  result.blow.cone = double_double(blow.cone, 0);
  result.blow.e = double_double(blow.e, 0);
  result.blow.law = blow.law;
  result.blow.facts = blow.facts;
  return result;
}

template <class T>
struct Outcome {
  Moment<T> end;
  T p_c;
  std::optional<T> stopped, near_jump;
  bool recompressed;
};

/// Some dozens are usual. Where K's numbers are so far apart that the floats' digits do not tell them from each other
/// (a lever of 1e160 m), slip may turn for ever.
constexpr int most_stretches = 4096;

template <class T, class Course>
Outcome<T> walked(const Blow<T>& blow, Course course) {
  Walk<T> walk(blow, before(blow));
  for (int stretches = 0; !walk.done(); ++stretches) {
    if (stretches == most_stretches) throw InputError("contact", "slip turns in more steps than are followed");
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

template <class T>
Outcome<T> nearly(const Blow<T>& blow) {
  return on_lines(blow.facts) ? walked(blow, Lines<T>(blow)) : walked(blow, Slide<T>(blow));
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

/// √(u0ᵀ K⁻¹ u0), the scale of what an impact does.
Float energy_norm(const Blow<Float>& blow) {
  return sqrt(std::max(Float(0), inner(blow.u0, times(blow.K_inverse, blow.u0))));
}

/// Farther away, a jump is none of this scene's.
constexpr double ambiguity = 1e-9;

/// Where μ |K_tn| ≤ K_nn, U never falls and there is no jump; rounding must not make one.
void set_ambiguous(ImpulseTruth& truth, const Blow<Float>& blow, const Float& missing_u_n) {
  if (!blow.facts.painleve) return;
  const Float scale = sqrt(inner(blow.N, times(blow.K, blow.N))) * energy_norm(blow);
  if (missing_u_n <= ambiguity * scale) truth.ambiguous = scale == 0 ? 0 : static_cast<double>(missing_u_n / scale);
}

/// At least cond(K).
Float condition(const Blow<Float>& blow) {
  const auto trace = [](const Square<Float>& M) { return Float(M[0][0] + M[1][1] + M[2][2]); };
  return trace(blow.K) * trace(blow.K_inverse);
}

/// Of many digits: series are cut at 2^-165 and floats have 254 bits; 2^-150 is 45 digits and leaves 2^15 for what
/// steps add up. Of some: cut at 2^-84, 106 bits, 2^-75. The second term is what the bits leave of an ill-conditioned
/// K, the third what they leave of Stronge's end, where W has risen by e² of itself and p by e. All relative to the
/// energy norm, or to half of |P|_K where that is more: Newton's law alone can gain energy.
double stated_error(const Blow<Float>& blow, const Triple& exact_P, Digits digits) {
  const Three<Float> P = {float_of(exact_P[0]), float_of(exact_P[1]), float_of(exact_P[2])};
  const Float size = std::max(energy_norm(blow), Float(sqrt(std::max(Float(0), inner(P, times(blow.K, P)))) / 2));
  const bool many = digits == Digits::many;
  const Float bits_left = ldexp(Float(1), many ? -240 : -95);
  const bool rises_little = blow.law == Law::stronge && blow.e > 0;
  const Float relative = ldexp(Float(1), many ? -150 : -75) + condition(blow) * bits_left +
                         (rises_little ? std::min(Float(bits_left / blow.e), Float(sqrt(bits_left))) : Float(0));
  return std::max(std::nextafter(static_cast<double>(Float(size * relative)), std::numeric_limits<double>::infinity()),
                  std::numeric_limits<double>::denorm_min());
}

/// Two doubles are enough for some digits: of a K that is not near singular, an approach not lost beside the slip, and
/// a restitution not lost beside the compression.
bool two_doubles_do(const Blow<Float>& blow) {
  const Float fast = abs(blow.u0[0]) + abs(blow.u0[1]) + abs(blow.u0[2]);
  return condition(blow) <= 0x1p44 && -inner(blow.u0, blow.N) >= ldexp(fast, -200) &&
         (blow.e == 0 || blow.e >= 0x1p-18);
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

/// Both named as for the other kinds of numbers.
using reference::exact_of;
mpq_class exact_of(const Enclosed& x) { return exact_of(x.middle()); }

/// What a walk in other numbers found, `shift` and `shift_of_u` being the exponents of its units.
template <class T>
Triple told(ImpulseTruth& truth, const Blow<mpq_class>& exact, const Blow<Float>& blow, const Outcome<T>& outcome,
            int shift = 0, int shift_of_u = 0) {
  const auto in_si = [&](const T& p) {
    mpq_class q = exact_of(p);
    (shift < 0 ? mpq_mul_2exp : mpq_div_2exp)(q.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(std::abs(shift)));
    return q;
  };
  set_modes(truth.modes, exact, outcome);
  truth.p_c = rational_of(in_si(outcome.p_c));
  truth.p_f = rational_of(in_si(outcome.end.p));
  if (outcome.near_jump) set_ambiguous(truth, blow, ldexp(float_of(exact_of(*outcome.near_jump)), -shift_of_u));
  return {in_si(outcome.end.P[0]), in_si(outcome.end.P[1]), in_si(outcome.end.P[2])};
}

Blow<Enclosed> enclosed(const Blow<mpq_class>& exact) {
  const auto vector = [](const Triple& a) { return EnclosedVec{a[0], a[1], a[2]}; };
  const auto matrix = [&](const std::array<Triple, 3>& M) {
    return Square<Enclosed>{vector(M[0]), vector(M[1]), vector(M[2])};
  };
  Blow<Enclosed> blow;
  blow.K = matrix(exact.K);
  blow.K_inverse = matrix(exact.K_inverse);
  blow.u0 = vector(exact.u0);
  blow.N = scaled(Enclosed(1 / root(Enclosed(exact.square))), vector(exact.N));
  blow.square = 1;
  blow.cone = mpq_class(exact.cone / exact.square);
  blow.e = exact.e;
  blow.law = exact.law;
  blow.facts = exact.facts;
  return blow;
}

/// √(dPᵀ K dP) of half the box's diagonal dP, at most √(tr K) |dP|; rounded up.
double enclosed_error(const Blow<Enclosed>& blow, const EnclosedVec& P) {
  Enclosed square_of_dP = 0;
  for (const Enclosed& p : P) square_of_dP = square_of_dP + square(Enclosed(p.width()));
  return root(Enclosed(square_of_dP * (blow.K[0][0] + blow.K[1][1] + blow.K[2][2]))).in_doubles().hi;
}

/// None where an order of two numbers does not show in 254 bits, or slip turns for too long.
std::optional<Triple> strike_enclosed(ImpulseTruth& truth, const Blow<mpq_class>& exact, const Blow<Float>& blow) try {
  const Blow<Enclosed> numbers = enclosed(exact);
  const Outcome<Enclosed> outcome =
      on_lines(exact.facts) ? walked(numbers, Lines<Enclosed>(numbers)) : walked(numbers, Sweep(numbers));
  ImpulseTruth proved = truth;
  const Triple P = told(proved, exact, blow, outcome);
  truth = proved;
  truth.error = enclosed_error(numbers, outcome.end.P);
  truth.certified = !truth.pi;
  return P;
} catch (const Undecided&) {
  return {};
}

Triple strike_exactly(ImpulseTruth& truth, const Blow<mpq_class>& exact, const Blow<Float>& blow) {
  const Outcome<mpq_class> outcome = exactly(exact);
  set_modes(truth.modes, exact, outcome);
  set_normal_impulses(truth, exact.square, outcome.p_c, outcome.end.p);
  if (outcome.near_jump) {
    set_ambiguous(truth, blow, float_of(*outcome.near_jump) / sqrt(float_of(exact.square)));
  }
  truth.certified = !truth.pi;
  if (!truth.certified) truth.error = stated_error(blow, outcome.end.P, Digits::many);
  return outcome.end.P;
}

Triple strike_nearly(ImpulseTruth& truth, const Blow<mpq_class>& exact, const Blow<Float>& blow, Digits digits) {
  if (digits == Digits::many) return told(truth, exact, blow, nearly(blow));
  const Scaled scaled = in_double_doubles(blow);
  return told(truth, exact, blow, nearly(scaled.blow), scaled.shift, scaled.shift_of_u);
}

Triple strike(ImpulseTruth& truth, const Blow<mpq_class>& exact, Digits digits) {
  const Blow<Float> blow = unit_normal(exact);
  try {
    return strike_exactly(truth, exact, blow);
  } catch (const Irrational&) {
    if (digits == Digits::some && !two_doubles_do(blow)) digits = Digits::many;
    if (digits == Digits::many) {
      if (const auto P = strike_enclosed(truth, exact, blow)) return *P;
    }
    const Triple P = strike_nearly(truth, exact, blow, digits);
    truth.error = stated_error(blow, P, digits);
    return P;
  }
}

/// u_n just above 0 where it would fall: were it just below 0, the impact would not be small.
void set_ambiguous_if_grazing(ImpulseTruth& truth, const Blow<mpq_class>& exact) {
  if (!exact.facts.painleve || !exact.facts.slips) return;
  const Blow<Float> blow = unit_normal(exact);
  const Three<Float> w = blow.tangential(blow.u0);
  const Three<Float> zeta = minus(blow.N, scaled(Float(sqrt(blow.cone / inner(w, w))), w));
  if (inner(blow.N, times(blow.K, zeta)) < 0) set_ambiguous(truth, blow, inner(blow.u0, blow.N));
}

}  // namespace

ImpulseTruth impulse(const Scene& scene, Digits digits) {
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
    P = strike(truth, blow, digits);
  }
  truth.P_A_W = vec_of(P);
  truth.after = {after(scene.bodies[0], hit.bodies[0], P), after(scene.bodies[1], hit.bodies[1], minus(Triple{}, P))};
  return truth;
}

}  // namespace touchstone::reference
