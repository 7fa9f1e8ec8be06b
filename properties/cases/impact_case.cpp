#include "properties/cases/impact_case.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "oracle/judge/words.h"
#include "oracle/tolerance/precision.h"
#include "oracle/truth/truth.h"

namespace touchstone::properties {
namespace {

// Of quantities that are 0 or positive in exact arithmetic: long doubles round by 2^-64, and a few roundings add up to
// less than this.
constexpr Real margin = 0x1p-60L;

}  // namespace

After moving(const std::array<Velocity, 2>& velocities) {
  After after;
  for (std::size_t i = 0; i < 2; ++i) {
    after[i] = {velocities[i].v_WBcm.cast<Real>(), velocities[i].w_WB.cast<Real>()};
  }
  return after;
}

ImpactCase::ImpactCase(const Scene& asked, oracle::Precision subject)
    : scene(asked), contact(*asked.contact), impact(oracle::impact(asked)), precision(subject) {}

bool ImpactCase::uncoupled() const { return impact.k().norm() <= margin * impact.K_nn(); }

bool ImpactCase::slips() const { return impact.energy_norm(impact.u_t()) > margin * impact.energy_norm(impact.u); }

bool ImpactCase::regular() const { return uncoupled() || mu() * impact.k().norm() <= impact.K_nn() * (1 - margin); }

bool ImpactCase::law_jumps() const {
  const bool slip_stops_at_once = std::isinf(mu()) && slips();
  if (regular() && !slip_stops_at_once) return false;
  const Real scale = std::sqrt(impact.K_nn()) * impact.energy_norm(impact.u);
  return std::abs(impact.u_n()) <= 1e-9L * scale || oracle::truth::impulse(scene).ambiguous.has_value();
}

After ImpactCase::moved_by(const Point& P_A_W) const {
  After after;
  for (std::size_t i = 0; i < 2; ++i) {
    const oracle::ImpactBody& body = impact.bodies[i];
    const Point P = (i == 0 ? 1 : -1) * P_A_W;
    after[i] = {body.v_WBcm, body.w_WB};
    if (body.fixed) continue;
    after[i].v_WBcm += P / body.mass;
    after[i].w_WB += body.spin(body.p_BcmC_W.cross(P));
  }
  return after;
}

Real ImpactCase::kinetic_energy(const After& after) const {
  Real twice = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const oracle::ImpactBody& body = impact.bodies[i];
    twice += body.mass * after[i].v_WBcm.squaredNorm() + body.spin_energy_twice(after[i].w_WB);
  }
  return twice / 2;
}

bool ImpactCase::fixed_body_moves() const {
  return std::ranges::any_of(
      impact.bodies, [](const oracle::ImpactBody& b) { return b.fixed && !(b.v_WBcm.isZero(0) && b.w_WB.isZero(0)); });
}

SaidImpact::SaidImpact(const ImpactCase& asked, const Impulse& said)
    : answer(said),
      after(moving(said.after)),
      u(asked.impact.u_after(said.after)),
      P(asked.impact.impulse_for(u - asked.impact.u)),
      allowed(oracle::tolerance::impulse(asked.scene, asked.impact, said.after, asked.precision)),
      per_normal(allowed * static_cast<double>(asked.impact.energy_norm(asked.impact.nhat_BA_W))) {}

Real difference(const ImpactCase& asked, const After& a, const After& b) {
  Real square = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const oracle::ImpactBody& body = asked.impact.bodies[i];
    const Point dv = a[i].v_WBcm - b[i].v_WBcm, dw = a[i].w_WB - b[i].w_WB;
    square += body.mass * dv.squaredNorm() + body.spin_energy_twice(dw);
  }
  return std::sqrt(std::max<Real>(0, square));
}

oracle::judge::Allowance in_ulps_of(const ImpactCase& asked, Real size, double bound, const std::string& name) {
  const Real unit = oracle::unit_roundoff(asked.precision) * size;
  return {bound, std::max(static_cast<double>(unit), std::numeric_limits<double>::denorm_min()), "ulps of " + name, 0,
          static_cast<double>(size)};
}

oracle::judge::Allowance of_energy(const ImpactCase& asked, double bound) {
  return in_ulps_of(asked, asked.impact.energy_norm(asked.impact.u), bound, "the impact's energy norm");
}

std::string text(Real x) { return oracle::words::text(static_cast<double>(x)); }

std::string text(const Point& p) { return oracle::words::text(Vec3(p.cast<double>())); }

std::string text(const After& after) {
  std::string all;
  for (const Moving& body : after) {
    all += (all.empty() ? "A: v " : "; B: v ") + text(body.v_WBcm) + ", w " + text(body.w_WB);
  }
  return all;
}

}  // namespace touchstone::properties
