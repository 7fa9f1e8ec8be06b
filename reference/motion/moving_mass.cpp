#include "reference/motion/moving_mass.h"

#include <mpfr.h>

#include <variant>

#include "model/input_error.h"
#include "reference/exact/linear.h"
#include "reference/exact/rational.h"
#include "reference/mass.h"

namespace touchstone::reference {
namespace {

/// A rational that replaces π. π is transcendental: a polynomial with rational coefficients vanishes at it only if it
/// vanishes everywhere. So what is exactly 0 with π is exactly 0 with the rational too, and what is not 0 stays so
/// unless it is within some 2^-300 of 0.
mpq_class pi_stand_in() {
  mpq_class pi;
  mpfr_t rounded;
  mpfr_init2(rounded, 320);
  mpfr_const_pi(rounded, MPFR_RNDN);
  mpfr_get_q(pi.get_mpq_t(), rounded);
  mpfr_clear(rounded);
  return pi;
}

MovingMass mass_as_given(const MassProperties& given) {
  const Mat3& I = given.I_BBcm_B;
  return {mpq_class(given.mass), triple(given.p_BBcm), {triple(I.row(0)), triple(I.row(1)), triple(I.row(2))}};
}

/// From moments about B's origin: c = S/V, and by Steiner's theorem I_c = I_o − V (|c|² 1 − c cᵀ).
MovingMass mass_of_density(const Shape& shape, const mpq_class& density) {
  static const mpq_class pi = pi_stand_in();
  const SolidTruth truth = solid(shape);
  const auto value = [&](const SolidTruth::Value& v) {
    return mpq_class(value_of(v.rational) + value_of(v.pi_multiple) * pi);
  };
  MovingMass result;
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

}  // namespace

MovingMass moving_mass(const Body& body, const std::string& place) {
  const auto* given = std::get_if<MassProperties>(&body.mass);
  MovingMass result =
      given ? mass_as_given(*given) : mass_of_density(body.shape, mpq_class(std::get<Density>(body.mass).value));
  if (!positive_definite(result.inertia)) {
    throw InputError(place + ".mass.I_BBcm_B",
                     "positive definite within rounding, but not exactly: no motion is defined");
  }
  return result;
}

}  // namespace touchstone::reference
