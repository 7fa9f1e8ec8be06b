#include "oracle/tolerance/motion.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "oracle/tolerance/impulse.h"
#include "oracle/tolerance/precision.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/truth.h"

namespace touchstone::oracle::tolerance {
namespace {

/// The properties of a body's ballistic motion, in long double.
struct Facts {
  bool fixed = false;
  bool round = true;         ///< turns at a constant rate: all moments equal, or fixed
  bool tumbles = false;      ///< no two moments are equal
  Real growth = 0;           ///< 1/rad, if it tumbles: of an error of ω, over Ω
  Real tau = 0;              ///< s
  Real v = 0, w = 0, a = 0;  ///< m/s; rad/s, the greatest of the motion; m/s²
  Real centre = 0;           ///< m: |p_BBcm|
  Real centre_error = 0;     ///< m, without u
  Real moment_error = 0;     ///< 1: of a moment, relative to the least one
  Real mass_error = 0;       ///< 1
};

Real length(const Vec3& v) { return v.cast<Real>().norm(); }

Vec3 force(const Motion& motion, std::size_t body, double time) {
  Vec3 latest = Vec3::Zero();
  for (const AppliedForce& applied : motion.forces) {
    if (static_cast<std::size_t>(applied.body) == body && applied.time <= time) latest = applied.force_W;
  }
  return latest;
}

// Moments that differ by less, relative to the greatest, count as equal. They come from doubles and are computed in
// long doubles, so 2^-40 is far above their rounding. A choice: the bounds hold on both sides of it.
constexpr Real equal = 0x1p-40L;

// The greatest rate of a torque-free rotation, Ω² = 2T(1/I₁ + 1/I₃) − L²/(I₁I₃), moments ascending.
Real greatest_rate(const ImpactBody& body) {
  const Real I1 = body.moments[0], I3 = body.moments[2], L = body.angular_momentum(body.w_WB).norm();
  return std::sqrt(std::max<Real>(0, body.spin_energy_twice(body.w_WB) * (1 / I1 + 1 / I3) - L * L / (I1 * I3)));
}

// Growth of an error of a torque-free angular velocity. Euler: ω₁' = c₁ω₂ω₃ and so on, c₁ = (I₂ − I₃)/I₁, |c| ≤ 1 by
// the triangle inequality of moments. An error δω grows no faster than the symmetric part of the linearised equations
// allows. Its entries off the diagonal are m_k = (c_i + c_j)ω_k/2 = −c_k(1 + c_i c_j)ω_k/2, and it has no trace, so its
// greatest eigenvalue is at most √(4/3 Σ m_k²). That is 1.16Ω at most; for a body that rotates almost about its first
// or last axis it is far less.
constexpr Real greatest_growth = 1.16L;

// The greatest √(4/3 Σ m_k²) of a motion over its Ω. ω₁² and ω₃² are linear in ω₂² (2T and L² are constant), so Σ m_k²
// is greatest where ω₂ = 0 or where ω₂² is greatest: there ω₁ = 0, or ω₃ = 0 if L² < 2T I₂.
Real growth(const ImpactBody& body, Real rate) {
  const Real I1 = body.moments[0], I2 = body.moments[1], I3 = body.moments[2];
  const Real twice_T = body.spin_energy_twice(body.w_WB), L = body.angular_momentum(body.w_WB).norm(), L2 = L * L;
  const Real c1 = (I2 - I3) / I1, c2 = (I3 - I1) / I2, c3 = (I1 - I2) / I3;
  const auto sum = [&](Real square1, Real square2, Real square3) {
    const auto term = [](Real c, Real square) { return c * c / 4 * std::max<Real>(square, 0); };
    return term(c2 + c3, square1) + term(c3 + c1, square2) + term(c1 + c2, square3);
  };
  const Real above1 = L2 - twice_T * I1, above2 = L2 - twice_T * I2, below3 = twice_T * I3 - L2;
  const Real at_0 = sum(below3 / (I1 * (I3 - I1)), 0, above1 / (I3 * (I3 - I1)));
  const Real at_most = above2 > 0 ? sum(0, below3 / (I2 * (I3 - I2)), above2 / (I3 * (I3 - I2)))
                                  : sum(-above2 / (I1 * (I2 - I1)), above1 / (I2 * (I2 - I1)), 0);
  return rate > 0 ? std::min(greatest_growth, std::sqrt(std::max(at_0, at_most) * 4 / 3) / rate) : 0;
}

Real start_of(const Scene& scene, std::size_t index) {
  const std::vector<double>& starts = scene.motion->start_times;
  return starts.empty() ? 0 : starts[index];
}

Facts facts(const Scene& scene, std::size_t index, double time, Precision precision) {
  const Body& body = scene.bodies[index];
  const Motion& motion = *scene.motion;
  Facts it;
  it.tau = static_cast<Real>(time) - start_of(scene, index);
  it.v = length(body.velocity.v_WBcm);
  it.w = length(body.velocity.w_WB);
  it.fixed = std::holds_alternative<Fixed>(body.mass);
  if (it.fixed) return it;
  const ImpactBody still = impact_body(scene, index, body.X_WB.p_WB);
  it.centre = still.p_BBcm.norm();
  it.a = (scene.gravity.cast<Real>() + force(motion, index, time).cast<Real>() / still.mass).norm();
  const Point& I = still.moments;
  it.round = I[2] - I[0] <= equal * I[2];
  it.tumbles = !it.round && I[1] - I[0] > equal * I[2] && I[2] - I[1] > equal * I[2];
  if (!it.round) it.w = greatest_rate(still);
  if (it.tumbles) it.growth = growth(still, it.w);
  const MassBound of_density = mass(body, precision);
  it.mass_error = static_cast<Real>(of_density.mass) / still.mass;
  it.centre_error = of_density.centre;
  it.moment_error = static_cast<Real>(of_density.inertia) / I[0];
  return it;
}

// An error source of 1 for each radian makes δω/Ω at most (exp(gθ) − 1)/g, which is less than θ exp(gθ); the rotation's
// error is the integral of that over θ, at most θ times as much. Where g is 1.16, exp(gθ) − 1 bounds both. Errors of
// the moments, κ relative to the least, are a source of at most 3κΩ².
Real grown(const Facts& it, Real theta) {
  if (!it.tumbles) return 2 * theta;
  const Real slowly = theta * std::max<Real>(theta, 1) * std::exp(it.growth * theta);
  return std::min(slowly, std::expm1(greatest_growth * theta));
}

// How an error of 1 of ω/Ω at the start has grown; of two parts if two moments are equal, since L and the spin about
// the axis each keep theirs. The rotation's error is the integral over θ, at most θ times as much.
Real grown_from_start(const Facts& it, Real theta) {
  if (it.round) return 0;
  return it.tumbles ? std::exp(it.growth * theta) : 2;
}

// A body with unequal moments is followed in its own axes, so its motion begins with Rᵀω: the entries of R, from a
// quaternion of any length, 12u, and three products and two sums a row, √3·3u (fast/lin_canny/rotation.h derives both).
constexpr Real into_own_axes = 18;

/// The errors of the moments, as the rate of error that they cause.
Real uneven(const Facts& it, Real u) { return it.round ? 0 : 3 * it.moment_error + 8 * u; }

// θ = ωτ: |ω| 3.5u, a product, sine and cosine: 8uθ; the composition with the initial pose: 32u; where the moments
// differ, the grown errors.
Real turned(const Facts& it, Real theta, Real u) {
  return u * (8 * theta + 32) + uneven(it, u) * grown(it, theta) +
         into_own_axes * u * theta * grown_from_start(it, theta);
}

/// m, from W's origin: the body's at the start, its points' from the centre of mass, and the centre's in the end.
struct Ways {
  Real p = 0, rho = 0, far = 0;
};

Ways ways_of(const Scene& scene, std::size_t body, const Facts& it) {
  const Real p = length(scene.bodies[body].X_WB.p_WB);
  return {p, radius(scene.bodies[body]) + it.centre, p + it.centre + it.v * it.tau + it.a * it.tau * it.tau / 2};
}

// Poses 2u(|c| + ρ), velocities 2u.
BallisticBound rounded(const Facts& it, const Ways& ways, Real u) {
  const Real v = it.v + it.a * it.tau;
  BallisticBound bound;
  bound.fastest = static_cast<double>(v + it.w * ways.rho);
  bound.farthest = static_cast<double>(ways.far + ways.rho);
  bound.place = static_cast<double>(2 * u * (ways.far + ways.rho));
  bound.velocity = static_cast<double>(2 * u * v);
  bound.spin = static_cast<double>(2 * u * it.w);
  return bound;
}

/// m/s²: what applied forces add to g at most.
Real greatest_push(const Scene& scene) {
  Real greatest = 0;
  for (const AppliedForce& applied : scene.motion->forces) {
    const auto i = static_cast<std::size_t>(applied.body);
    const ImpactBody pushed = impact_body(scene, i, scene.bodies[i].X_WB.p_WB);
    if (!pushed.fixed) greatest = std::max(greatest, length(applied.force_W) / pushed.mass);
  }
  return greatest;
}

}  // namespace

// To first order in u, over τ seconds:
//   centre   c(τ) = p + R p_BBcm + vτ + aτ²/2: the pose 52u(|p| + |p_BBcm|) (oracle/tolerance/tolerance.cpp);
//            g + F/m to 3u and the error of m; three products and three sums for each coordinate,
//            √3·4u < 7u of each term, twice for the rounding of τ: 14u.
//   point    at most ρ from the centre of mass: the error of the turn times ρ, and the error of the centre of mass.
//   v + aτ   4u(|v| + aτ), and the error of a.
//   ω        8uΩ, and, where it changes, that and the grown error.
//   times    those of an answer, the start's too, are next to the right ones: 2u of the start each, beyond what τ is
//            rounded above. So the motion lasts 4u·start more or less, in which a point moves by (|v| + aτ + Ωρ), v
//            changes by a, and ω by less than Ω² (|cᵢ| ≤ 1), per second.
BallisticBound ballistic(const Scene& scene, std::size_t body, double time, Precision precision) {
  const Facts it = facts(scene, body, time, precision);
  const Ways ways = ways_of(scene, body, it);
  const Real u = unit_roundoff(precision), clock = 4 * u * start_of(scene, body);
  BallisticBound bound = rounded(it, ways, u);
  if (precision != Precision::exact) {
    const Real theta = it.w * it.tau, pushed = it.mass_error * it.a;
    bound.place = static_cast<double>(u * (52 * (ways.p + it.centre) + 14 * ways.far) + pushed * it.tau * it.tau / 2 +
                                      turned(it, theta, u) * ways.rho + 2 * it.centre_error);
    bound.velocity = static_cast<double>(4 * u * (it.v + it.a * it.tau) + pushed * it.tau);
    bound.spin = static_cast<double>(
        it.w * (8 * u + uneven(it, u) * (grown(it, theta) + 1) + into_own_axes * u * grown_from_start(it, theta)));
  }
  bound.place += static_cast<double>(clock * bound.fastest);
  bound.velocity += static_cast<double>(clock * it.a);
  if (!it.round) bound.spin += static_cast<double>(clock * it.w * it.w);
  return bound;
}

BallisticBound rounded_state(const Scene& scene, std::size_t body, double time, Precision precision) {
  const Facts it = facts(scene, body, time, precision);
  return rounded(it, ways_of(scene, body, it), unit_roundoff(precision));
}

// y = (R, ω/Ω) of a body with unequal moments follows y' = f(y), in units of 1/Ω. |R'| = 1; |ω'| ≤ 1/√3, as |c| ≤ 1 and
// Σ ω_j²ω_k² ≤ 1/3. In W, |ω''| ≤ 2/√3 + 1/√3, and |R''| ≤ 1 + 1/√3, so |y''| ≤ 2.34. An error of ω grows by 1.16 of
// itself, one of R turns the axes of f_ω: at most 1/√3 + 1.16 of it. The symmetric part of that matrix has the
// eigenvalue 2.07 at most.
constexpr Real second_derivative = 2.34L, coupled_growth = 2.07L;

// A method of order 1 errs by h²/2 |y''| in a step, so after τ by h/2 |y''| τ, or grown by (e^(gτ) − 1)/(gτ). The
// centre has |y''| = a, and so has none at order 2, whose local error h³/6 |y'''| is at most 2 hΩ of that of order 1,
// as |y'''| ≤ 6 Ω |y''|. `displacement` counts an angle √2 times.
//
// Each step rounds the pose by 8u of its parts (a sum and a product; a quaternion is turned and normalised), and each
// speed as below.
BallisticBound stepped(const Scene& scene, std::size_t body, double time, const Stepping& stepping,
                       Precision precision) {
  const Facts it = facts(scene, body, time, Precision::exact);
  const Real h = stepping.step, rho = radius(scene.bodies[body]) + it.centre, theta = it.w * it.tau;
  const Real of_order = stepping.order > 1 ? 2 * h * it.w : 1;
  const Real angle = it.round ? theta : second_derivative * std::expm1(coupled_growth * theta) / coupled_growth;
  const Real turned = of_order * h * it.w / 2 * angle;
  BallisticBound bound;
  bound.place = static_cast<double>((stepping.order > 1 ? 0 : it.a * h * it.tau / 2) + std::sqrt(2.0L) * turned * rho);
  bound.spin = static_cast<double>(it.round ? 0 : it.w * turned);
  const Real rounding = rounding_of_steps(static_cast<double>(it.tau), stepping, precision);
  const Real v = it.v + it.a * it.tau, far = length(scene.bodies[body].X_WB.p_WB) + it.centre + v * it.tau;
  bound.velocity += static_cast<double>(rounding * v);
  bound.spin += static_cast<double>(rounding * it.w);
  bound.place += static_cast<double>(rounding * (far + v * it.tau + 2 * rho * (1 + theta)));
  return bound;
}

// A step adds h times an acceleration to v: 2u of the sum. It adds h I⁻¹(ω × Iω) to ω, even where that should be 0: I
// and I⁻¹ are turned to the world's axes, so it is 8u ω² at most for each, which counts h Ω < 1/2 times. A solver that
// keeps ω otherwise, as a momentum or as the difference of two poses, does not round more.
double rounding_of_steps(double time, const Stepping& stepping, Precision precision) {
  constexpr double in_a_step = 8;
  return in_a_step * unit_roundoff(precision) * std::ceil(time / stepping.step);
}

double fastest_at_start(const Scene& scene) {
  double fastest = 0;
  for (const Body& body : scene.bodies) {
    fastest = std::max(fastest, body.velocity.v_WBcm.norm() + radius(body) * body.velocity.w_WB.norm());
  }
  return fastest;
}

double longest_way(const Scene& scene, double seconds) {
  return seconds * (fastest_at_start(scene) + scene.gravity.norm() * seconds / 2);
}

// Each body has at most the speed of the fastest at the start, and what gravity and applied forces add. Spin may become
// speed: half the energy ½ I w² ≤ ½ m ρ² w², with ρ the body's reach.
double way_of_step(const Scene& scene, double step) {
  const double falls = scene.gravity.norm() + static_cast<double>(greatest_push(scene));
  return 2 * step * (fastest_at_start(scene) + falls * scene.motion->sample_times.back());
}

// A shift stays, and a velocity adds to it. `place` bounds the error of the turn times rho as well. A turned body whose
// angular velocity is as stated has it turned in its own axes, by Ω place/rho. That and the error of ω grow as above,
// at most by e^(1.16Ωτ); a round body keeps its ω. Twice the rotations, since `displacement` counts an angle √2 times.
double carried(const Scene& scene, std::size_t body, double time, double until, const BallisticBound& off) {
  const Facts it = facts(scene, body, until, Precision::exact);
  const Real tau = static_cast<Real>(until) - time, rho = radius(scene.bodies[body]) + it.centre;
  const Real own = it.round ? 0 : it.w * off.place;
  const Real growth = it.round ? 1 : std::exp(greatest_growth * it.w * tau);
  return static_cast<double>(off.place + tau * off.velocity + 2 * (off.place + tau * growth * (rho * off.spin + own)));
}

double turn(const Scene& scene, std::size_t body, double rate, double seconds, Precision precision) {
  Facts it = facts(scene, body, seconds, precision);
  it.growth = greatest_growth;  // `rate` is that of any of its motions, of which the scene's is only the first
  return static_cast<double>(turned(it, static_cast<Real>(rate) * seconds, unit_roundoff(precision)));
}

// The errors of two motions; the error of a distance of poses as far out as the motion reaches (tolerance::distance is
// proportional to that); the rounding u of the time, at the speed of the fastest points; and one more rounding of each
// motion for the judge's own poses.
double moving_distance(const Scene& scene, double time, Precision precision) {
  const double u = unit_roundoff(precision);
  double motions = 0, speed = 0, farthest = scale(scene);
  for (std::size_t i = 0; i < 2; ++i) {
    const BallisticBound bound = ballistic(scene, i, time, precision);
    motions += bound.place + ballistic(scene, i, time, Precision::exact).place;
    speed += bound.fastest;
    farthest = std::max(farthest, bound.farthest);
  }
  return distance(scene, precision) * (farthest / scale(scene)) + motions + 2 * u * time * speed;
}

double granted(const Scene& scene, const ContactTolerance& declared) {
  double sum = declared.absolute;
  if (declared.size > 0) sum += declared.size * sizes_of(scene).lengths.lo;
  if (declared.way > 0) sum += declared.way * longest_way(scene, scene.motion->sample_times.back());
  return sum;
}

// u is a difference of v + w × r.
double at_contact(const Impact& impact, const std::array<BallisticBound, 2>& before,
                  const std::array<double, 2>& arms) {
  Real sum = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const ImpactBody& body = impact.bodies[i];
    sum += before[i].velocity + before[i].spin * body.p_BcmC_W.norm() + body.w_WB.norm() * arms[i];
  }
  return static_cast<double>(sum);
}

// The impulse depends on the arms and on the velocity at C (oracle/tolerance/impulse.cpp: of_input). In addition the
// errors of the velocities before remain in those after.
double through_impact(const Scene& scene, const Impact& impact, const std::array<BallisticBound, 2>& before,
                      const std::array<double, 2>& arms) {
  Real remain = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const ImpactBody& body = impact.bodies[i];
    if (!body.fixed) remain += std::sqrt(body.mass) * before[i].velocity + std::sqrt(body.moments[2]) * before[i].spin;
  }
  return of_input(scene, impact, arms, at_contact(impact, before, arms)) + static_cast<double>(remain);
}

// v is e times the speed before, or n̂·v as reported: in each v + w × r with an arm from C and the centre, 4u of
// either's distance from the origin and 8u of the speeds; the normal, 4u more; n̂·v, 3u. So 19u of the speeds for each
// of the two, 38u. g_n: a normal and three products, 8u of |g|. 1 − e, the products and the quotient: 4u. The sum: u of
// `end`, and as much for the time of the impact.
double end_of_bounces(const Bounces& bounces, double end, Precision precision) {
  const Real u = unit_roundoff(precision), seconds = bounces.seconds();
  const Real of_seconds = 38 * bounces.speeds / bounces.speed + 8 * bounces.gravity / bounces.presses + 4;
  return static_cast<double>(u * (of_seconds * seconds + 2 * end));
}

// (p_WCa − p_WCb)/|…|: the errors of two witness points over their distance. If that is more than 1/1024, the two
// practically touch, and features give the normal at least as well.
double normal(const Scene& scene, double apart, Precision precision) {
  const double off = 2 * witness(scene, precision) + 16 * ulp(scene, precision);
  return apart * 0x1p-10 > off ? off / apart : 0x1p-10;
}

// An event changes the terms of two bodies, each within a few ulps of itself (oracle/tolerance/impulse.cpp: momentum,
// 2u·2). The motion of a body between events adds another 8u for each term.
double accumulated(std::size_t events, std::size_t bodies) {
  return 8 * (static_cast<double>(events) + static_cast<double>(bodies) + 1);
}

}  // namespace touchstone::oracle::tolerance
