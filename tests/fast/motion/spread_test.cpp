#include "fast/motion/spread.h"

#include <cmath>

#include "fast/motion/inertia.h"
#include "reference/mass.h"
#include "reference/validity.h"
#include "tests/catch.h"

namespace touchstone::fast::motion {
namespace {

using exact::Dyadic;
using reference::Rational;

using Matrix = std::array<std::array<Rational, 3>, 3>;

/// m 2^exponent, also beyond the range of doubles.
template <class Number>
Number scaled(double m, long exponent) {
  Number x = m;
  for (; exponent > 1000; exponent -= 1000) x = x * Number(0x1p1000);
  for (; exponent < -1000; exponent += 1000) x = x * Number(0x1p-1000);
  return x * Number(std::ldexp(1.0, static_cast<int>(exponent)));
}

Rational rational(Dyadic x) {
  Rational sum;
  while (x.sign() != 0) {
    const Dyadic::Scientific part = x.scientific();
    sum += scaled<Rational>(part.m, part.exponent);
    x = x - scaled<Dyadic>(part.m, part.exponent);
  }
  return sum;
}

/// arctan(1/n) by its series, to 2^-300.
Rational arctan_of_one_over(double n) {
  Rational power = Rational(1) / n, sum;
  for (double k = 0; power > Rational(0x1p-300); ++k) {
    const Rational term = power / (2 * k + 1);
    sum += std::fmod(k, 2) == 0 ? term : -term;
    power /= n * n;
  }
  return sum;
}

/// Machin's formula.
Rational pi() { return Rational(16) * arctan_of_one_over(5) - Rational(4) * arctan_of_one_over(239); }

/// V C = V ∫ x xᵀ dV − (∫ x dV)(∫ x dV)ᵀ by the exact reference, whose products of inertia are −∫ x y dV.
Matrix truth(const Shape& shape) {
  const reference::SolidTruth solid = reference::solid(shape);
  const Rational pi_ = pi();
  const auto value = [&](const reference::SolidTruth::Value& v) { return v.rational + v.pi_multiple * pi_; };
  std::array<Rational, 6> I;
  for (std::size_t i = 0; i < 6; ++i) I[i] = value(solid.second_moments[i]);
  const Rational half = (I[0] + I[1] + I[2]) / 2;
  const Matrix S{{{half - I[0], -I[3], -I[4]}, {-I[3], half - I[1], -I[5]}, {-I[4], -I[5], half - I[2]}}};
  Matrix C;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      C[i][j] = value(solid.volume) * S[i][j] - value(solid.first_moments[i]) * value(solid.first_moments[j]);
    }
  }
  return C;
}

Rational trace(const Matrix& M) { return M[0][0] + M[1][1] + M[2][2]; }

/// The greatest error of an entry, as a share of the trace.
Rational error_of(const ScaledC& found, const Matrix& exact) {
  Matrix C;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) C[i][j] = rational(found.C[i][j]);
  }
  Rational most;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Rational off = C[i][j] / trace(C) - exact[i][j] / trace(exact);
      most = std::max(most, off < Rational() ? -off : off);
    }
  }
  return most;
}

Shape completed(const Compound& compound) {
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].shape = compound;
  scene.bodies[1].shape = Sphere{1};
  return reference::completed(std::move(scene)).bodies[0].shape;
}

const Polytope wedge{{{0, 0, 0}, {1, 0, 0}, {0, 3, 0}, {0, 0, 0.25}}, {}};
const Quaternion quarter{1, 0, 0, 1}, askew{1, 2, -3, 0.5};

TEST_CASE("the moments of balls alone, and of parts whose |q|² is a power of two, are exact") {
  for (const Compound& compound :
       {Compound{{{{{-3, 0, 0}, askew}, Sphere{0.1}}, {{{1, 2, 7}, {}}, Sphere{0.7}}}},
        Compound{{{{{5, 0, 0.1}, quarter}, Box{{1, 2, 3}}}, {{{-0.3, 0, 0}, {0.5, 0.5, 0.5, 0.5}}, wedge}}}}) {
    const Shape shape = completed(compound);
    const ScaledC found = scaled_spread(std::get<Compound>(shape));
    CHECK(found.error == 0);
    CHECK(error_of(found, truth(shape)) == Rational());
  }
}

TEST_CASE("other moments are as near as they say, and that is near") {
  for (const double far : {0.0, 0x1p20, 0x1p50}) {
    for (const Compound& compound :
         {Compound{{{{{far - 3, 0, 0}, askew}, Box{{0.1, 2, 3}}}, {{{far + 1, 2, 7}, {}}, Sphere{0.7}}}},
          Compound{{{{{far, 0, 0}, {}}, Box{{0.1, 2, 3}}}, {{{far + 3, 0, 0}, {}}, Sphere{0.7}}}},
          Compound{{{{{far, -far, 0.1}, askew}, wedge}, {{{-far, far, 0}, {1e-9, 1, 1, 1}}, Box{{1, 1, 0x1p-20}}}}}}) {
      const Shape shape = completed(compound);
      const ScaledC found = scaled_spread(std::get<Compound>(shape));
      CHECK(found.error > 0);
      CHECK(error_of(found, truth(shape)) <= Rational(found.error));
      CHECK(found.error < 0x1p-190 * (1 + far * far));
    }
  }
}

TEST_CASE("a quaternion that is rescaled may lose a component, and then nothing is exact") {
  const Compound rescaled{{{{{0, 0, 0}, {0x1p500, 0x1p-700, 0, 0}}, Box{{1, 2, 3}}}}};
  const ScaledC found = scaled_spread(rescaled);
  CHECK(found.error > 0);
  CHECK(found.error < 0x1p-185);
}

TEST_CASE("where a compound lies changes no moment") {
  const auto at = [](double far) {
    return scaled_spread(Compound{{{{{far, 0, 0}, askew}, Box{{1, 2, 3}}}, {{{far, far, 0}, {}}, Sphere{1}}}});
  };
  CHECK(scaled_spread(Compound{{{{{0x1p900, 0, 0}, askew}, Box{{1, 2, 3}}}}}).error < 0x1p-185);
  CHECK(at(0x1p10).error < 0x1p-185);
}

TEST_CASE("equal moments of a dumbbell are known to be equal, and nearly equal ones as well as others") {
  const auto inertia_of = [](const Compound& compound) {
    Body body;
    body.shape = completed(compound);
    body.mass = Density{3};
    return inertia(body);
  };
  const Inertia even = inertia_of({{{{{-4, 0, 0}, {}}, Sphere{0.1}}, {{{3, 0, 0}, {}}, Sphere{0.3}}}});
  CHECK(even.is_aligned);
  CHECK(even.c.x() == 0);
  const Inertia slender =
      inertia_of({{{{{-4000, 0, 0}, askew}, Box{{0.1, 0.1, 0.1}}}, {{{4000, 0, 0}, {}}, Box{{0.1, 0.125, 0.1}}}}});
  CHECK(slender.c_error < 0x1p-45);
}

}  // namespace
}  // namespace touchstone::fast::motion
