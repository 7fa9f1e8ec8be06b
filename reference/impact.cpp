#include <mpfr.h>

#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include "model/input_error.h"
#include "reference/impact_impl.h"
#include "reference/linear_impl.h"
#include "reference/mass.h"
#include "reference/rational_impl.h"

namespace touchstone::reference {
namespace {

/// Mass, centre of mass and inertia about it in B's axes; values with π hold the stand-in.
struct Heavy {
  mpq_class mass;
  Triple centre;
  std::array<Triple, 3> inertia;
  bool pi = false;
};

/// π is transcendental: a polynomial with rational coefficients vanishes at it only if it vanishes everywhere. So what
/// is exactly 0 with π is exactly 0 with a stand-in too, and what is not stays so unless it is within some 2^-300 of 0.
mpq_class pi_stand_in() {
  mpq_class pi;
  mpfr_t rounded;
  mpfr_init2(rounded, 320);
  mpfr_const_pi(rounded, MPFR_RNDN);
  mpfr_get_q(pi.get_mpq_t(), rounded);
  mpfr_clear(rounded);
  return pi;
}

Heavy heavy(const MassProperties& given) {
  const Mat3& I = given.I_BBcm_B;
  return {mpq_class(given.mass), triple(given.p_BBcm), {triple(I.row(0)), triple(I.row(1)), triple(I.row(2))}};
}

/// From moments about B's origin: c = S/V, and by Steiner I_c = I_o − V (|c|² 1 − c cᵀ).
Heavy heavy(const Shape& shape, const mpq_class& density) {
  static const mpq_class pi = pi_stand_in();
  const SolidTruth truth = solid(shape);
  const auto value = [&](const SolidTruth::Value& v) {
    return mpq_class(value_of(v.rational) + value_of(v.pi_multiple) * pi);
  };
  Heavy result;
  result.pi = truth.volume.pi_multiple.sign() != 0;
  const mpq_class volume = value(truth.volume);
  result.mass = density * volume;
  for (std::size_t i = 0; i < 3; ++i) result.centre[i] = value(truth.first_moments[i]) / volume;
  const auto& m = truth.second_moments;
  const std::array<Triple, 3> about_origin = {{{value(m[0]), value(m[3]), value(m[4])},
                                               {value(m[3]), value(m[1]), value(m[5])},
                                               {value(m[4]), value(m[5]), value(m[2])}}};
  const mpq_class square = dot(result.centre, result.centre);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const mpq_class shift = (i == j ? square : mpq_class(0)) - result.centre[i] * result.centre[j];
      result.inertia[i][j] = density * (about_origin[i][j] - volume * shift);
    }
  }
  return result;
}

/// Sylvester's criterion.
bool positive_definite(const std::array<Triple, 3>& I) {
  return sgn(I[0][0]) > 0 && sgn(mpq_class(I[0][0] * I[1][1] - I[0][1] * I[1][0])) > 0 && sgn(determinant(I)) > 0;
}

Response response(const Body& body, const Heavy& heavy, const Triple& p_WC, const std::string& place) {
  if (!positive_definite(heavy.inertia)) {
    throw InputError(place + ".mass.I_BBcm_B",
                     "positive definite within rounding, but not exactly: no impact is defined");
  }
  const Motion X_WB = motion(body.X_WB);
  Response result;
  result.inverse_mass = 1 / heavy.mass;
  const std::array<Triple, 3> inverse = inverted(heavy.inertia);
  for (std::size_t i = 0; i < 3; ++i) {
    const Triple row = times(inverse, X_WB.rows[i]);  // (R I⁻¹ Rᵀ)ij = (I⁻¹ Rᵢᵀ)·Rⱼ
    for (std::size_t j = 0; j < 3; ++j) result.inverse_inertia[i][j] = dot(row, X_WB.rows[j]);
  }
  result.arm = minus(p_WC, X_WB(heavy.centre));
  return result;
}

/// A fixed body answers nothing; its velocity is that of its own origin, where its centre of mass stands for want of
/// another.
Response fixed(const Body& body, const Triple& p_WC) {
  Response result;
  result.arm = minus(p_WC, triple(body.X_WB.p_WB));
  return result;
}

Triple velocity_at_C(const Body& body, const Response& response) {
  return plus(triple(body.velocity.v_WBcm), cross(triple(body.velocity.w_WB), response.arm));
}

}  // namespace

Triple Response::linear(const Triple& P) const { return scaled(inverse_mass, P); }
Triple Response::angular(const Triple& P) const { return times(inverse_inertia, cross(arm, P)); }

Impact impact(const Scene& scene) {
  if (!scene.contact) throw InputError("contact", "missing; expected one for a question about an impact");
  const Contact& contact = *scene.contact;
  Impact result;
  const Triple p_WC = triple(contact.p_WC);
  for (std::size_t b = 0; b < 2; ++b) {
    const Body& body = scene.bodies[b];
    if (std::holds_alternative<Fixed>(body.mass)) {
      result.bodies[b] = fixed(body, p_WC);
      continue;
    }
    const auto* given = std::get_if<MassProperties>(&body.mass);
    const Heavy weight = given ? heavy(*given) : heavy(body.shape, mpq_class(std::get<Density>(body.mass).value));
    result.pi = result.pi || weight.pi;
    result.bodies[b] = response(body, weight, p_WC, "bodies[" + std::to_string(b) + "]");
  }
  result.u0 = minus(velocity_at_C(scene.bodies[0], result.bodies[0]), velocity_at_C(scene.bodies[1], result.bodies[1]));
  for (std::size_t j = 0; j < 3; ++j) {
    Triple axis;
    axis[j] = 1;
    for (const Response& body : result.bodies) {
      const Triple column = plus(body.linear(axis), cross(body.angular(axis), body.arm));
      for (std::size_t i = 0; i < 3; ++i) result.K[i][j] += column[i];
    }
  }
  result.N = triple(contact.nhat_BA_W);
  result.law = contact.law;
  result.e = mpq_class(contact.restitution);
  if (!std::isinf(contact.friction)) result.mu = mpq_class(contact.friction);
  return result;
}

}  // namespace touchstone::reference
