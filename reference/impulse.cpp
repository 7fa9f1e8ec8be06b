#include "reference/impulse.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "model/infinity.h"
#include "model/input_error.h"
#include "reference/exact/double_double.h"
#include "reference/exact/float.h"
#include "reference/exact/rational.h"
#include "reference/impulse/exact_vectors.h"
#include "reference/impulse/impact.h"
#include "reference/impulse/law.h"
#include "reference/impulse/lines.h"
#include "reference/impulse/root.h"
#include "reference/impulse/slide.h"
#include "reference/impulse/sweep.h"

namespace touchstone::reference {
namespace {

bool zero(const Triple& a) { return sgn(a[0]) == 0 && sgn(a[1]) == 0 && sgn(a[2]) == 0; }
bool parallel(const Triple& a, const Triple& b) { return zero(cross(a, b)); }

/// (μ ν)²; 0 for unlimited friction, where it is not used.
mpq_class cone_of(const Impact& impact, const mpq_class& square) {
  return impact.mu ? mpq_class(*impact.mu * *impact.mu * square) : mpq_class(0);
}

/// Slip keeps its direction w/|w| iff m·K(N − μν w/|w|) = 0 for the m ⊥ w: that is, m·K N and m·K w are both 0, or have
/// the same sign with (m·K N)² |w|² = (μν)² (m·K w)².
bool keeps_direction(const Impact& impact, const Triple& w, const mpq_class& cone) {
  const Triple m = cross(impact.N, w);
  const mpq_class by_normal = dot(m, times(impact.K, impact.N));
  const mpq_class by_friction = dot(m, times(impact.K, w));
  if (sgn(by_normal) != sgn(by_friction)) return false;
  return by_normal * by_normal * dot(w, w) == cone * by_friction * by_friction;
}

ImpactProblem<mpq_class> problem_of(const Impact& impact) {
  ImpactProblem<mpq_class> problem;
  problem.K = impact.K;
  problem.K_inverse = inverted(impact.K);
  problem.u0 = impact.u0;
  problem.N = impact.N;
  problem.square = dot(problem.N, problem.N);
  problem.cone = cone_of(impact, problem.square);
  problem.e = impact.e;
  problem.law = impact.law;
  Facts& facts = problem.facts;
  const Triple w = problem.tangential(problem.u0);
  const Triple stick = minus(sticking_zeta(problem), problem.N);
  const Triple pull = problem.tangential(times(problem.K, problem.N));
  const mpq_class rise = dot(problem.N, times(problem.K, problem.N)) / problem.square;
  facts.separating = sgn(dot(problem.u0, problem.N)) >= 0;
  facts.frictionless = impact.mu && sgn(*impact.mu) == 0;
  facts.no_limit = !impact.mu;
  facts.slips = !zero(w);
  facts.straight = facts.slips && !facts.no_limit && keeps_direction(impact, w, problem.cone);
  facts.rest_sticks = facts.no_limit || dot(stick, stick) <= problem.cone;
  facts.rest_turns = parallel(stick, problem.tangential(times(problem.K, stick)));
  facts.painleve = problem.cone * dot(pull, pull) > rise * rise * problem.square * problem.square;
  return problem;
}

/// In floats, with |N| = 1.
ImpactProblem<Float> unit_normal(const ImpactProblem<mpq_class>& exact) {
  ImpactProblem<Float> problem;
  problem.K = float_of(exact.K);
  problem.K_inverse = float_of(exact.K_inverse);
  problem.u0 = float_of(exact.u0);
  problem.N = scaled(Float(1 / sqrt(float_of(exact.square))), float_of(exact.N));
  problem.square = 1;
  problem.cone = float_of(mpq_class(exact.cone / exact.square));
  problem.e = float_of(exact.e);
  problem.law = exact.law;
  problem.facts = exact.facts;
  return problem;
}

/// The exponent of a power of two that scales x > 0 to near 1.
int exponent_to_one(const Float& x) { return -static_cast<int>(mpfr_get_exp(x.backend().data())); }

/// The impact in other units of mass and velocity, powers of two that scale K and u0 to near 1. P is 2^shift times that
/// of the scene.
struct Scaled {
  ImpactProblem<DoubleDouble> problem;
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

Scaled in_double_doubles(const ImpactProblem<Float>& problem) {
  const int for_K = exponent_to_one(Float(problem.K[0][0] + problem.K[1][1] + problem.K[2][2]));
  const int for_u = exponent_to_one(Float(abs(problem.u0[0]) + abs(problem.u0[1]) + abs(problem.u0[2])));
  Scaled result;
  result.shift = for_u - for_K;
  result.shift_of_u = for_u;
  result.problem.K = double_double(problem.K, for_K);
  result.problem.K_inverse = double_double(problem.K_inverse, -for_K);
  result.problem.u0 = double_double(problem.u0, for_u);
  result.problem.N = double_double(problem.N, 0);
  result.problem.square = 1.0;
  result.problem.cone = double_double(problem.cone, 0);
  result.problem.e = double_double(problem.e, 0);
  result.problem.law = problem.law;
  result.problem.facts = problem.facts;
  return result;
}

template <class T>
struct Outcome {
  ImpactState<T> end;
  T p_c;
  std::optional<T> stopped, near_jump;
  bool recompressed;
  std::vector<T> slopes;  ///< over K_nn
};

/// A few dozen phases are usual. Where the entries of K differ so much that the floats' digits do not separate them
/// (a lever of 1e160 m), slip may turn without end.
constexpr int max_phases = 4096;

template <class T, class PhaseSource>
Outcome<T> solved(const ImpactProblem<T>& problem, PhaseSource source) {
  ImpactProgress<T> progress(problem, before(problem));
  for (int phases = 0; !progress.done(); ++phases) {
    if (phases == max_phases) throw InputError("contact", "slip turns in more phases than are followed");
    const std::unique_ptr<Phase<T>> phase = source.next(progress);
    progress.along(*phase);
  }
  const T K_nn = inner(problem.N, times(problem.K, problem.N));
  std::vector<T> slopes = progress.slopes();
  for (T& slope : slopes) slope = T(slope / K_nn);
  return {progress.now(),       progress.p_c(),          source.stopped(),
          progress.near_jump(), progress.recompressed(), std::move(slopes)};
}

bool on_lines(const Facts& facts) { return facts.frictionless || facts.no_limit || !facts.slips || facts.straight; }

Outcome<mpq_class> exactly(const ImpactProblem<mpq_class>& problem) {
  if (!on_lines(problem.facts)) throw Irrational();
  return solved(problem, Lines<mpq_class>(problem));
}

template <class T>
Outcome<T> nearly(const ImpactProblem<T>& problem) {
  return on_lines(problem.facts) ? solved(problem, Lines<T>(problem)) : solved(problem, Slide<T>(problem));
}

template <class T>
void set_modes(ImpulseTruth::Modes& modes, const ImpactProblem<mpq_class>& problem, const Outcome<T>& outcome) {
  const Facts& facts = problem.facts;
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
  const Triple w = problem.tangential(problem.u0);
  const Triple leaves = minus(problem.N, sticking_zeta(problem));
  modes.reversal = modes.diverges && facts.slips && facts.rest_turns && parallel(w, leaves);
}

ExactVelocity after(const Body& body, const Response& response, const Triple& P) {
  return {exact_vec(plus(triple(body.velocity.v_WBcm), response.linear(P))),
          exact_vec(plus(triple(body.velocity.w_WB), response.angular(P)))};
}

/// √(u0ᵀ K⁻¹ u0), the scale of the impact's effect.
Float energy_norm(const ImpactProblem<Float>& problem) {
  return sqrt(std::max(Float(0), inner(problem.u0, times(problem.K_inverse, problem.u0))));
}

/// A jump of the law farther away than this does not concern the scene.
constexpr double ambiguity = 1e-9;

void set_jump(ImpulseTruth& truth, const ImpactProblem<Float>& problem, const Float& missing_u_n) {
  const Float scale = sqrt(inner(problem.N, times(problem.K, problem.N))) * energy_norm(problem);
  if (missing_u_n <= ambiguity * scale) truth.ambiguous = scale == 0 ? 0 : static_cast<double>(missing_u_n / scale);
}

/// If μ |K_tn| ≤ K_nn, U never falls and the law has no jump; rounding must not make one.
void set_ambiguous(ImpulseTruth& truth, const ImpactProblem<Float>& problem, const Float& missing_u_n) {
  if (problem.facts.painleve) set_jump(truth, problem, missing_u_n);
}

/// Upper bound of cond(K).
Float condition(const ImpactProblem<Float>& problem) {
  const auto trace = [](const Square<Float>& M) { return Float(M[0][0] + M[1][1] + M[2][2]); };
  return trace(problem.K) * trace(problem.K_inverse);
}

/// ≥ 1: how small the approach is beside the velocity, |u|₁/|u_n|.
Float grazes(const ImpactProblem<Float>& problem) {
  const Float fast = abs(problem.u0[0]) + abs(problem.u0[1]) + abs(problem.u0[2]);
  const Float u_n = -inner(problem.u0, problem.N);
  return u_n > 0 ? std::max(Float(1), Float(fast / u_n)) : Float(1);
}

/// ≥ 1: by how much an error of u_n, over K_nn, becomes greater as one of p, where u_n reaches its goal. In a regular
/// contact du_n/dp ≥ K_nn − μ|K_tn| everywhere; otherwise it is known where compression ended.
Float flatness(const ImpactProblem<Float>& problem, double flattest) {
  const Three<Float> of_N = times(problem.K, problem.N);
  const Float K_nn = inner(problem.N, of_N);
  const Three<Float> K_tn = minus(of_N, scaled(K_nn, problem.N));
  const Float slope = Float(K_nn - sqrt(problem.cone * inner(K_tn, K_tn)));
  return slope > 0 ? Float(K_nn / slope) : Float(1 / Float(std::max(flattest, 0.0)));
}

/// For `many` digits: series are cut at 2^-165 and floats have 254 bits; 2^-150 is 45 digits and leaves a factor 2^15
/// for errors that add up over the steps. For `some`: cut at 2^-84, 106 bits, 2^-75. The second term is the precision
/// left for an ill-conditioned K. The third is the precision left at the end of Stronge's restitution, where W has
/// risen by the fraction e² of itself and p by e; where the approach grazes, W is small beside the numbers from which
/// it is computed, and an error δW is an error δW/u_n of p. All are relative to the energy norm, or to half of |P|_K if
/// that is larger: only Newton's law can gain energy.
double stated_error(const ImpactProblem<Float>& problem, const Triple& exact_P, double flattest, Digits digits) {
  const Three<Float> P = {float_of(exact_P[0]), float_of(exact_P[1]), float_of(exact_P[2])};
  const Float size = std::max(energy_norm(problem), Float(sqrt(std::max(Float(0), inner(P, times(problem.K, P)))) / 2));
  const bool many = digits == Digits::many;
  const Float bits_left = ldexp(Float(1), many ? -240 : -95);
  const bool rises_little = problem.law == Law::stronge && problem.e > 0;
  const Float relative =
      flatness(problem, flattest) * (ldexp(Float(1), many ? -150 : -75) + condition(problem) * bits_left) +
      (rises_little ? std::min(Float(bits_left * grazes(problem) / problem.e), Float(sqrt(bits_left))) : Float(0));
  return std::max(std::nextafter(static_cast<double>(Float(size * relative)), infinity),
                  std::numeric_limits<double>::denorm_min());
}

/// Double-doubles are enough for `some` digits if K is not near singular, the approach is not lost beside the slip (the
/// work of Stronge's law sooner than velocities), the restitution is not lost beside the compression, and friction is
/// moderate: the work of Stronge's law is a difference of terms that grow with μ², and fourth powers of μ ≤ 2^30 are
/// far from overflow.
bool two_doubles_do(const ImpactProblem<Float>& problem) {
  const bool by_work = problem.law == Law::stronge && problem.e > 0;
  const bool approaches = inner(problem.u0, problem.N) < 0;
  return condition(problem) <= 0x1p44 && approaches && grazes(problem) <= ldexp(Float(1), by_work ? 20 : 200) &&
         (problem.e == 0 || problem.e >= 0x1p-18) && problem.cone <= ldexp(Float(1), by_work ? 12 : 60);
}

/// Impulses along n, not along N. ν is an irrational root in general, so they are only within 2^-260 even where P is
/// exact.
void set_normal_impulses(ImpulseTruth& truth, const mpq_class& square, const mpq_class& p_c, const mpq_class& p_f) {
  const auto times_length = [&](const mpq_class& p) {
    if (square == 1) return p;
    return exact_of(Float(sqrt(float_of(square)) * float_of(p)));
  };
  truth.p_c = rational_of(times_length(p_c));
  truth.p_f = rational_of(times_length(p_f));
}

/// All under the same name.
using reference::exact_of;
const mpq_class& exact_of(const mpq_class& x) { return x; }
mpq_class exact_of(const Enclosed& x) { return exact_of(x.middle()); }

template <class T>
void set_flattest(ImpulseTruth& truth, const Outcome<T>& outcome) {
  for (const T& slope : outcome.slopes)
    truth.flattest = std::min(truth.flattest, static_cast<double>(float_of(exact_of(slope))));
}

/// Records the result of a solution in other numbers; `shift` and `shift_of_u` are the exponents of its units.
template <class T>
Triple recorded(ImpulseTruth& truth, const ImpactProblem<mpq_class>& exact, const ImpactProblem<Float>& problem,
                const Outcome<T>& outcome, int shift = 0, int shift_of_u = 0) {
  const auto in_si = [&](const T& p) {
    mpq_class q = exact_of(p);
    (shift < 0 ? mpq_mul_2exp : mpq_div_2exp)(q.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(std::abs(shift)));
    return q;
  };
  set_modes(truth.modes, exact, outcome);
  set_flattest(truth, outcome);
  truth.p_c = rational_of(in_si(outcome.p_c));
  truth.p_f = rational_of(in_si(outcome.end.p));
  if (outcome.near_jump) set_ambiguous(truth, problem, ldexp(float_of(exact_of(*outcome.near_jump)), -shift_of_u));
  return {in_si(outcome.end.P[0]), in_si(outcome.end.P[1]), in_si(outcome.end.P[2])};
}

ImpactProblem<Enclosed> enclosed(const ImpactProblem<mpq_class>& exact) {
  const auto vector = [](const Triple& a) { return EnclosedVec{a[0], a[1], a[2]}; };
  const auto matrix = [&](const std::array<Triple, 3>& M) {
    return Square<Enclosed>{vector(M[0]), vector(M[1]), vector(M[2])};
  };
  ImpactProblem<Enclosed> problem;
  problem.K = matrix(exact.K);
  problem.K_inverse = matrix(exact.K_inverse);
  problem.u0 = vector(exact.u0);
  problem.N = scaled(Enclosed(1 / root(Enclosed(exact.square))), vector(exact.N));
  problem.square = 1;
  problem.cone = mpq_class(exact.cone / exact.square);
  problem.e = exact.e;
  problem.law = exact.law;
  problem.facts = exact.facts;
  return problem;
}

/// √(dPᵀ K dP) for half the diagonal dP of the enclosing box, at most √(tr K) |dP|; rounded up.
double enclosed_error(const ImpactProblem<Enclosed>& problem, const EnclosedVec& P) {
  Enclosed square_of_dP = 0;
  for (const Enclosed& p : P) square_of_dP = square_of_dP + square(Enclosed(p.width()));
  return root(Enclosed(square_of_dP * (problem.K[0][0] + problem.K[1][1] + problem.K[2][2]))).in_doubles().hi;
}

/// None if 254 bits do not decide the order of two numbers, or if slip turns for too long.
std::optional<Triple> solve_enclosed(ImpulseTruth& truth, const ImpactProblem<mpq_class>& exact,
                                     const ImpactProblem<Float>& problem) try {
  const ImpactProblem<Enclosed> numbers = enclosed(exact);
  const Outcome<Enclosed> outcome =
      on_lines(exact.facts) ? solved(numbers, Lines<Enclosed>(numbers)) : solved(numbers, Sweep(numbers));
  ImpulseTruth proved = truth;
  const Triple P = recorded(proved, exact, problem, outcome);
  truth = proved;
  truth.error = enclosed_error(numbers, outcome.end.P);
  truth.certified = !truth.pi;
  return P;
} catch (const Undecided&) {
  return {};
}

Triple solve_exactly(ImpulseTruth& truth, const ImpactProblem<mpq_class>& exact, const ImpactProblem<Float>& problem) {
  const Outcome<mpq_class> outcome = exactly(exact);
  set_modes(truth.modes, exact, outcome);
  set_flattest(truth, outcome);
  set_normal_impulses(truth, exact.square, outcome.p_c, outcome.end.p);
  if (outcome.near_jump) {
    set_ambiguous(truth, problem, float_of(*outcome.near_jump) / sqrt(float_of(exact.square)));
  }
  truth.certified = !truth.pi;
  if (!truth.certified) truth.error = stated_error(problem, outcome.end.P, truth.flattest, Digits::many);
  return outcome.end.P;
}

/// In double-doubles. None if these are not enough, if a result is not finite, or if slip turns in too many phases.
std::optional<Triple> solve_shortly(ImpulseTruth& truth, const ImpactProblem<mpq_class>& exact,
                                    const ImpactProblem<Float>& problem) try {
  if (!two_doubles_do(problem)) return {};
  const Scaled scaled = in_double_doubles(problem);
  const Outcome<DoubleDouble> outcome = nearly(scaled.problem);
  const auto is_number = [](const DoubleDouble& x) { return std::isfinite(x.hi) && std::isfinite(x.lo); };
  const auto& [P1, P2, P3] = outcome.end.P;
  for (const DoubleDouble& x : {P1, P2, P3, outcome.p_c, outcome.end.p, outcome.near_jump.value_or(0)}) {
    if (!is_number(x)) return {};
  }
  if (!std::ranges::all_of(outcome.slopes, is_number)) return {};
  const Triple P = recorded(truth, exact, problem, outcome, scaled.shift, scaled.shift_of_u);
  truth.error = stated_error(problem, P, truth.flattest, Digits::some);
  return P;
} catch (const InputError&) {
  return {};
}

Triple solve(ImpulseTruth& truth, const ImpactProblem<mpq_class>& exact, Digits digits) {
  const ImpactProblem<Float> problem = unit_normal(exact);
  try {
    return solve_exactly(truth, exact, problem);
  } catch (const Irrational&) {
    if (digits == Digits::some) {
      if (const auto P = solve_shortly(truth, exact, problem)) return *P;
    }
    if (const auto P = solve_enclosed(truth, exact, problem)) return *P;
    const Triple P = recorded(truth, exact, problem, nearly(problem));
    truth.error = stated_error(problem, P, truth.flattest, Digits::many);
    return P;
  }
}

/// Sets `ambiguous` if u_n is just above 0 but would fall: if it were just below 0, the impulse would not be small.
void set_ambiguous_if_grazing(ImpulseTruth& truth, const ImpactProblem<mpq_class>& exact) {
  if (!exact.facts.painleve || !exact.facts.slips) return;
  const ImpactProblem<Float> problem = unit_normal(exact);
  const Three<Float> w = problem.tangential(problem.u0);
  const Three<Float> zeta = minus(problem.N, scaled(Float(sqrt(problem.cone / inner(w, w))), w));
  if (inner(problem.N, times(problem.K, zeta)) < 0) set_ambiguous(truth, problem, inner(problem.u0, problem.N));
}

/// Infinite friction stops the slip of bodies that approach, however slowly, and of no others.
void set_ambiguous_if_slip_stops(ImpulseTruth& truth, const ImpactProblem<mpq_class>& exact) {
  if (!exact.facts.slips) return;
  const ImpactProblem<Float> problem = unit_normal(exact);
  set_jump(truth, problem, abs(inner(problem.u0, problem.N)));
}

}  // namespace

ImpulseTruth impulse(const Scene& scene, Digits digits) {
  const Impact hit = impact(scene);
  const ImpactProblem<mpq_class> problem = problem_of(hit);
  ImpulseTruth truth;
  truth.K_W = {exact_vec(hit.K[0]), exact_vec(hit.K[1]), exact_vec(hit.K[2])};
  truth.u0_W = exact_vec(hit.u0);
  truth.pi = hit.pi;
  Triple P;
  if (problem.facts.separating) {
    truth.modes.separating = true;
    truth.certified = true;
    set_ambiguous_if_grazing(truth, problem);
  } else {
    P = solve(truth, problem, digits);
  }
  if (!hit.mu) set_ambiguous_if_slip_stops(truth, problem);
  truth.P_A_W = exact_vec(P);
  truth.after = {after(scene.bodies[0], hit.bodies[0], P), after(scene.bodies[1], hit.bodies[1], minus(Triple{}, P))};
  return truth;
}

}  // namespace touchstone::reference
