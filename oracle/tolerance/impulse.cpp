#include "oracle/tolerance/impulse.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "oracle/tolerance/precision.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/truth.h"

namespace touchstone::oracle::tolerance {
namespace {

// Relative error of the impulse in its energy norm for given K and u: what is expected of a solver. Constant for
// cond(K) ≤ 10, which includes all contacts inside uniform boxes (cond ≤ 7, proved), and proportional to it above.
// Measured for a Taylor solver: ≤ 80u and ≤ 217u·cond(K) (docs/design/impulse.md).
Real solver(const Impact& impact) {
  const Real condition = impact.condition();
  return condition <= 10 ? 256 : 1024 * condition;
}

// How much a relative change of K, or of u, can change the impulse, all in energy norms. Measured by differences over
// nine classes of contacts: at most 46 and 19 (docs/design/impulse.md; no program repeats it). This is not a theorem;
// there is none where the law itself jumps.
constexpr Real of_K = 64;
constexpr Real of_u = 32;

// At the end of compression u_n crosses 0 with the slope du_n/dp ≥ K_nn − mu|K_tn|, and an error of u_n moves p_c by
// that error over the slope. Where the bound of the slope is not positive, the crossing may be arbitrarily flat: there
// the slope is the true one.
Real crossing(const Scene& scene, const Impact& impact) {
  const Real coupling = impact.k().norm();
  const Real slope = coupling > 0 ? 1 - scene.contact->friction * coupling / impact.K_nn() : 1;
  return 1 / (slope > 0 ? slope : static_cast<Real>(truth::impulse(scene).flattest));
}

// A turn by q/|q| changes a vector by at most 44u of its length (oracle/tolerance/tolerance.cpp); there and back is two
// turns. None is needed if the body is not turned or its inertia is the same about all axes.
constexpr Real turn_factor = 44;

bool needs_turn(const Body& body, const ImpactBody& impact_body) {
  const Quaternion& q = body.X_WB.q_WB;
  return (q.x != 0 || q.y != 0 || q.z != 0) && impact_body.moments[0] != impact_body.moments[2];
}

Real length(const Vec3& v) { return v.cast<Real>().norm(); }

// The unit roundoff of what is computed from the scene: by the subject, or, for an exact one, which only rounds its
// answer, by the judge, in long double. K may be so ill-conditioned that this shows: cond(K) is up to 2^44.
constexpr Real roundoff_of_judge = 0x1p-64L;
Real working_roundoff(Precision precision) {
  return precision == Precision::exact ? roundoff_of_judge : Real(unit_roundoff(precision));
}

// Rounding errors of the properties of one body, in SI units.
struct Facts {
  Real arm = 0;      // m: of r = p_WC − p_WBcm
  Real inertia = 0;  // 1: of I⁻¹, relative to its least moment
  Real mass = 0;     // 1: of m
};

// Sphere and box: 4π/3·r³ and 8·a·b·c, times the density; m/3·(b² + c²), a sum of positive terms. A hull or a union:
// tolerance::mass.
MassBound of_density(const Body& body, const ImpactBody& impact_body, Precision precision) {
  const double u = unit_roundoff(precision);
  if (precision == Precision::exact || !std::holds_alternative<Density>(body.mass)) return {};
  const bool primitive = std::holds_alternative<Sphere>(body.shape) || std::holds_alternative<Box>(body.shape);
  if (!primitive) return mass(body, precision);
  return {.mass = 8 * u * static_cast<double>(impact_body.mass),
          .inertia = 16 * u * static_cast<double>(impact_body.moments[0])};
}

// r: the centre of mass is the body's origin, or a pose (52u, oracle/tolerance/tolerance.cpp) takes it to the world.
// The difference rounds by u|r|. Into the body's axes and back are two turns. Mass properties from a density:
// tolerance::mass.
Facts facts(const Body& body, const ImpactBody& impact_body, Precision precision) {
  if (impact_body.fixed) return {};
  const Real u = working_roundoff(precision);
  const MassBound from_density = of_density(body, impact_body, precision);
  const auto* given = std::get_if<MassProperties>(&body.mass);
  const Real r = impact_body.p_BcmC_W.norm(),
             centre = from_density.centre + (given != nullptr ? length(given->p_BBcm) : 0);
  Facts it;
  it.arm = u * r + (needs_turn(body, impact_body) ? 2 * turn_factor * u * r : 0);
  if (centre > 0) it.arm += from_density.centre + 52 * u * (length(body.X_WB.p_WB) + length(body.X_WB.p_WB) + centre);
  it.inertia = u + from_density.inertia / impact_body.moments[0];
  it.mass = u + from_density.mass / impact_body.mass;
  return it;
}

// A solver may add the impulse to the velocities in parts: along the normal, along two tangents, and that of
// restitution. Each sum rounds. An exact subject only rounds its answer.
Real sums(Precision precision) { return precision == Precision::exact ? 1 : 4; }

// √J: the stated velocities, each number rounded with each sum, and an angular velocity turned back.
Real stored(const Scene& scene, const Impact& impact, const std::array<Velocity, 2>& after, Precision precision) {
  const Real u = unit_roundoff(precision), times = sums(precision);
  const bool exact = precision == Precision::exact;
  Real sum = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const ImpactBody& body = impact.bodies[i];
    if (body.fixed) continue;
    const Real change = (after[i].w_WB.cast<Real>() - body.w_WB).norm();
    const Real turned = !exact && needs_turn(scene.bodies[i], body) ? turn_factor * change : 0;
    const Real v = length(after[i].v_WBcm) + (exact ? 0 : body.v_WBcm.norm());
    const Real w = length(after[i].w_WB) + (exact ? 0 : body.w_WB.norm());
    sum += u * (std::sqrt(body.mass) * times * v + std::sqrt(body.moments[2]) * (times * w + turned));
  }
  return sum;
}

// N: √(uᵀ K⁻¹ u), or half of the impulse's |P|_K if that is greater. An impulse that gains no energy has |P|_K ≤ 2√(uᵀ
// K⁻¹ u). Newton's law can gain any amount, so there the true impulse is used, never the stated one.
Real size(const Scene& scene, const Impact& impact) {
  const Real before = impact.energy_norm(impact.u);
  if (scene.contact->law != Law::newton) return before;
  const reference::ExactVec3& exact = truth::impulse(scene).P_A_W;
  const Point P(exact[0].nearest(), exact[1].nearest(), exact[2].nearest());
  return std::max(before, impact.energy_norm(impact.K * P) / 2);
}

// An error |dr| of this body's arm changes K relatively by this (derived below).
Real of_arm(const Impact& impact, const ImpactBody& body, Real dr) {
  return 2 * dr * std::sqrt(impact.least_mass() / body.moments[0]);
}

// √J: effect of a relative error K of K and of an error du (m/s) of u, but for `crossing`; P/m and I⁻¹(r × P) have that
// of K once more.
Real disturbed(const Impact& impact, Real N, Real K, Real du) {
  return (of_K + 2) * K * N + of_u * std::sqrt(impact.least_mass()) * du;
}

}  // namespace

// To first order, with N as above, so that |P|_K ≤ 2N. For each body b,
// with B = I^{-1/2}[r]×, K ≥ BᵀB and K ≥ 1/m* (m*: least_mass):
//   K       |B K^{-1/2}| ≤ 1 and |K^{-1/2}| ≤ √m*, so an error dr of r changes K relatively by 2|dr|√(m*/λ), λ the
//           least moment; relative errors of I and m change it by the same amount. Times of_K·N.
//   u       dr moves w × r by |w||dr|; products and sums of v + w × r: 4u(|v| + |w||r|); the K^{-1} norm of it is at
//           most √m* times its length. Times of_u.
//   solver  above, times uN.
//   applied P/m and I⁻¹(r × P): the same errors once more, of |P|_K ≤ 2N.
//   stored  above; for an exact subject also the impulse, uN.
// All but the last times crossing.
double impulse(const Scene& scene, const Impact& impact, const std::array<Velocity, 2>& after, Precision precision) {
  const Real u = working_roundoff(precision), N = size(scene, impact);
  Real said = stored(scene, impact, after, precision);
  if (precision == Precision::exact) said += unit_roundoff(precision) * N;
  Real K = 0, du = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const ImpactBody& body = impact.bodies[i];
    const Real v = body.v_WBcm.norm(), w = body.w_WB.norm();
    const Facts off = facts(scene.bodies[i], body, precision);
    if (!body.fixed) K += of_arm(impact, body, off.arm) + off.inertia + off.mass;
    du += w * off.arm + 4 * u * (v + w * body.p_BcmC_W.norm());
  }
  return static_cast<double>(crossing(scene, impact) * (disturbed(impact, N, K, du) + solver(impact) * u * N) + said);
}

double of_input(const Scene& scene, const Impact& impact, const std::array<double, 2>& arms, double u) {
  Real K = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!impact.bodies[i].fixed) K += of_arm(impact, impact.bodies[i], arms[i]);
  }
  return static_cast<double>(crossing(scene, impact) * disturbed(impact, size(scene, impact), K, u));
}

// The energy changes by Σ ½ P·(u + u'), so errors of u' count that the solution leaves, not those of P, which may be
// great where contacts are nearly redundant. A backward stable solution leaves a part of the terms of which u' is the
// sum: as `solver`, 256u. The velocity that an impulse Q gives to another contact is at most √K times |Q|_K in each
// direction, so the terms times |P| sum up to at most (Σ |P|_K)².
double solved_together(std::span<const Real> norms, Precision precision) {
  const Real sum = std::accumulate(norms.begin(), norms.end(), Real{0});
  return static_cast<double>(256 * unit_roundoff(precision) * sum * sum);
}

// m v' rounds by u m|v'|. v' = v + P/m: the sums u|v'| each, the quotient u|P|/m and the error of the mass. Twice that
// for three coordinates at once.
double momentum(const Scene& scene, const Impact& impact, const std::array<Velocity, 2>& after, Real impulse,
                Precision precision) {
  const Real u = unit_roundoff(precision);
  Real sum = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const ImpactBody& body = impact.bodies[i];
    if (body.fixed) continue;
    const Facts off = facts(scene.bodies[i], body, precision);
    sum += 2 * (sums(precision) * u * body.mass * length(after[i].v_WBcm) + (u + off.mass) * impulse);
  }
  return static_cast<double>(sum);
}

// I (w' − w) = r × m (v' − v). About C, rounding of w' (with each sum) and w is multiplied by the greatest moment, λ;
// that of v' and v by the arm. The torque r × P has the arm's error, and two products and a sum for each coordinate
// (4u). The solve I⁻¹ is off by its own error and, in turned axes, by two turns, each of which I magnifies by cond(I).
double angular_momentum(const Scene& scene, const Impact& impact, std::size_t i, const Velocity& after, Real impulse,
                        Precision precision) {
  const ImpactBody& body = impact.bodies[i];
  const Real u = unit_roundoff(precision), r = body.p_BcmC_W.norm(), torque = r * impulse;
  const Facts off = facts(scene.bodies[i], body, precision);
  const Real condition = body.moments[2] / body.moments[0];
  const Real turned = needs_turn(scene.bodies[i], body) ? 2 * turn_factor * u : 0;
  const Real times = sums(precision);
  const Real spin = u * body.moments[2] * (times * length(after.w_WB) + body.w_WB.norm());
  const Real swing = u * r * body.mass * (times * length(after.v_WBcm) + body.v_WBcm.norm());
  const Real solve = condition * (turned + off.inertia + 4 * u) * torque + off.arm * impulse + off.mass * torque;
  return static_cast<double>(2 * (spin + swing + solve));
}

// The part perpendicular to a normal of length 1 within 2u, in turned axes, is off by 16u|P|, and so is the part along
// the normal, which counts mu times. A cone clipped in such axes was measured at 4u.
double cone(Real impulse, Real friction, Precision precision) {
  return static_cast<double>(16 * unit_roundoff(precision) * (1 + friction) * impulse);
}

bool impact_is_sure(const Impact& impact, Precision precision) {
  if (precision == Precision::exact) return impact.condition() > 0 && impact.condition() < 0x1p44L;
  return solver(impact) * unit_roundoff(precision) < 1 && impact.condition() > 0;
}

double least_in_range(Precision precision) { return precision == Precision::binary32 ? 0x1p-100 : 0x1p-900; }

bool impact_in_range(const Impact& impact, Precision precision) {
  const Real least = least_in_range(precision), most = 1 / least;
  const auto normal = [&](Real x) { return x == 0 || (x >= least && x <= most); };
  Real N = impact.energy_norm(impact.u);
  bool all = normal(N * N) && normal(impact.u.squaredNorm());
  for (const ImpactBody& body : impact.bodies) {
    const Real v = body.v_WBcm.squaredNorm(), w = body.w_WB.squaredNorm(), r = body.p_BcmC_W.squaredNorm();
    all = all && normal(v) && normal(w) && normal(r) && normal(w * r) && normal(body.mass);
    all = all && normal(body.moments[0]) && normal(body.moments[2]);
    all = all && normal(body.mass * v) && normal(body.moments[2] * w);
  }
  return all;
}

}  // namespace touchstone::oracle::tolerance
