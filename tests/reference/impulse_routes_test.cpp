// Two more ways to the impulse of a turning slip, each written from the equations and sharing nothing with the
// reference: the hodograph, in 80 digits, and the equations in p, in long double.
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/multiprecision/cpp_complex.hpp>
#include <cmath>
#include <optional>
#include <string>

#include "reference/impulse.h"
#include "tests/catch.h"
#include "tests/reference/impacts.h"

namespace touchstone::reference {
namespace {

using tests::Dice;

namespace mp = boost::multiprecision;
using Real = mp::number<mp::cpp_bin_float<80>, mp::et_off>;
using Complex = mp::number<mp::cpp_complex_backend<80>, mp::et_off>;

Real real(const Rational& r) {
  const std::string text = r.text();
  const auto slash = text.find('/');
  if (slash == std::string::npos) return Real(text);
  return Real(text.substr(0, slash)) / Real(text.substr(slash + 1));
}

/// The normal is z; what is not 2-D is in W's axes.
struct Equations {
  Real m11, m12, m22, k1, k2, b, mu;

  Real h(const Real& x, const Real& y) const {
    return x * (k2 - mu * (m12 * x + m22 * y)) - y * (k1 - mu * (m11 * x + m12 * y));
  }
  Real g(const Real& x, const Real& y) const {
    return x * (k1 - mu * (m11 * x + m12 * y)) + y * (k2 - mu * (m12 * x + m22 * y));
  }
};

Equations equations(const ImpulseTruth& t, double mu) {
  const auto K = [&](std::size_t i, std::size_t j) { return real(t.K_W[i][j]); };
  return {K(0, 0), K(0, 1), K(1, 1), K(0, 2), K(1, 2), K(2, 2), Real(mu)};
}

/// With z = e^{iθ}, h z² and g z² are polynomials of degree 4, and d ln s/dz = g z²/(i z h z²): partial fractions give
/// ln s = Re Σ β_i ln(z − z_i); the pole at 0 adds nothing real.
class Hodograph {
 public:
  explicit Hodograph(const Equations& e) : e_(e) {
    const Complex i(0, 1);
    const Real mean = (e.m11 + e.m22) / 2;
    const Complex k = Complex(e.k1, e.k2);
    const Complex bend = e.mu * Complex((e.m11 - e.m22) / 2, e.m12);  // of cos 2θ and sin 2θ
    // h = Re(−i k̄ z) … as (a z + ā/z)/2 with a = i k̄ and (c z² + c̄/z²)/2 with c = −i·conj(bend)
    const Complex h1 = i * conj(k);
    const Complex h2 = -i * conj(bend);
    const Complex g1 = conj(k);
    const Complex g2 = -conj(bend);
    h_ = {conj(h2) / 2, conj(h1) / 2, Complex(0), h1 / 2, h2 / 2};
    g_ = {conj(g2) / 2, conj(g1) / 2, Complex(-e.mu * mean), g1 / 2, g2 / 2};
    find_roots();
  }

  /// ln(s(b)/s(a)), for a and b less than a half turn apart as seen from each root.
  Real log_ratio(const Complex& a, const Complex& b) const {
    Real sum = 0;
    for (std::size_t i = 0; i < 4; ++i) sum += Complex(powers_[i] * log((b - roots_[i]) / (a - roots_[i]))).real();
    return sum;
  }

  struct End {
    Real p, s, D;  ///< D = ∫ s dp
  };

  /// ∫ s/h dθ by 30 points of Gauss a panel.
  End integrate(const Real& from, const Real& to, const Real& s0, int panels) const {
    End end{0, s0, 0};
    Real theta = from;
    for (int i = 0; i < panels; ++i) {
      const Real next = from + (to - from) * (i + 1) / panels;
      const Complex start = unit(theta);
      end.p += boost::math::quadrature::gauss<Real, 30>::integrate(
          [&](const Real& at) { return Real(end.s * exp(log_ratio(start, unit(at))) / e_.h(cos(at), sin(at))); }, theta,
          next);
      end.s *= exp(log_ratio(start, unit(next)));
      theta = next;
    }
    return end;
  }

  /// Until slip stops at the root of h at the angle `to`: with θ = to − (to − from) e^{−v} the integrands fall like
  /// exponentials of v.
  End until_stop(const Real& from, const Real& to, const Real& s0, int panels, const Real& length) const {
    End end{0, s0, 0};
    const Real gap = to - from;
    const auto theta = [&](const Real& v) { return Real(to - gap * exp(-v)); };
    for (int i = 0; i < panels; ++i) {
      const Real v0 = length * i / panels;
      const Real v1 = length * (i + 1) / panels;
      const Complex start = unit(theta(v0));
      const auto slip = [&](const Real& v) { return Real(end.s * exp(log_ratio(start, unit(theta(v))))); };
      const auto weight = [&](const Real& v) {
        const Real at = theta(v);
        return Real(gap * exp(-v) / e_.h(cos(at), sin(at)));
      };
      using Gauss = boost::math::quadrature::gauss<Real, 30>;
      end.D += Gauss::integrate([&](const Real& v) { return Real(slip(v) * slip(v) * weight(v)); }, v0, v1);
      end.s = slip(v1);
    }
    return end;
  }

  /// The root of h to which slip turns from the angle `from`; its exponent in s.
  struct Goal {
    Real angle, power;
  };
  std::optional<Goal> goal(const Real& from, bool leftward) const {
    const Real turn = 2 * boost::math::constants::pi<Real>();
    std::optional<Goal> nearest;
    for (std::size_t i = 0; i < 4; ++i) {
      const Real x = roots_[i].real();
      const Real y = roots_[i].imag();
      if (abs(x * x + y * y - 1) > Real("1e-60")) continue;
      Real angle = atan2(y, x);
      if (leftward && angle < from) angle += turn;
      if (!leftward && angle > from) angle -= turn;
      if (!nearest || abs(angle - from) < abs(nearest->angle - from)) nearest = Goal{angle, powers_[i].real()};
    }
    return nearest;
  }

 private:
  static Complex unit(const Real& theta) { return Complex(cos(theta), sin(theta)); }

  static Complex value(const std::array<Complex, 5>& c, const Complex& z) {
    return (((c[4] * z + c[3]) * z + c[2]) * z + c[1]) * z + c[0];
  }

  /// Durand and Kerner.
  void find_roots() {
    Complex seed(Real("0.4"), Real("0.9"));
    roots_ = {Complex(1), seed, seed * seed, seed * seed * seed};
    for (int n = 0; n < 120; ++n) {
      for (std::size_t i = 0; i < 4; ++i) {
        Complex others = h_[4];
        for (std::size_t j = 0; j < 4; ++j) {
          if (j != i) others *= roots_[i] - roots_[j];
        }
        roots_[i] -= value(h_, roots_[i]) / others;
      }
    }
    for (std::size_t i = 0; i < 4; ++i) {
      Complex slope = h_[4];
      for (std::size_t j = 0; j < 4; ++j) {
        if (j != i) slope *= roots_[i] - roots_[j];
      }
      powers_[i] = value(g_, roots_[i]) / (Complex(0, 1) * roots_[i] * slope);
    }
  }

  Equations e_;
  std::array<Complex, 5> h_, g_;
  std::array<Complex, 4> roots_, powers_;
};

struct Planar {
  Real x, y;
};

Planar tangential(const ExactVec3& u) { return {real(u[0]), real(u[1])}; }

ExactVec3 u_after(const ImpulseTruth& t) {
  ExactVec3 u = t.u0_W;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) u[i] += t.K_W[i][j] * t.P_A_W[j];
  }
  return u;
}

tests::ImpactProblem turning(Dice& dice) {
  tests::ImpactProblem problem;
  const double x = 0.1 + dice.unit();
  const double y = 0.1 + dice.unit();
  const double z = 0.1 + dice.unit();
  problem.I = tests::diagonal(y + z, x + z, x + y);
  problem.r = dice.in_cube();
  problem.w = dice.in_cube();
  problem.v = 2 * dice.in_cube();
  problem.e = dice.unit();
  problem.mu = dice.unit();
  return problem;
}

bool turns_throughout(const ImpulseTruth& t) {
  const auto& m = t.modes;
  return !m.separating && !m.straight && !m.sticks && !m.diverges && !m.recompressed && t.error > 0;
}

TEST_CASE("impulse: the hodograph, in 80 digits, ends where the series do") {
  Dice dice(51);
  int compared = 0;
  while (compared < 8) {
    const tests::ImpactProblem problem = turning(dice);
    const ImpulseTruth t = impulse(tests::scene(problem));
    if (!turns_throughout(t)) continue;
    const Equations e = equations(t, problem.mu);
    const Planar before = tangential(t.u0_W);
    const Planar after = tangential(u_after(t));
    const Real s0 = sqrt(before.x * before.x + before.y * before.y);
    const Real s1 = sqrt(after.x * after.x + after.y * after.y);
    const Real from = atan2(before.y, before.x);
    Real to = atan2(after.y, after.x);
    const Real turn = 2 * boost::math::constants::pi<Real>();
    const bool leftward = e.h(before.x / s0, before.y / s0) > 0;
    if (leftward && to < from) to += turn;
    if (!leftward && to > from) to -= turn;
    const Hodograph hodograph(e);
    // Where slip ends close to where it would turn no more, the integrand is too steep for these panels to judge.
    const Hodograph::End coarse = hodograph.integrate(from, to, s0, 24);
    const Hodograph::End fine = hodograph.integrate(from, to, s0, 36);
    if (abs(coarse.p - fine.p) > Real("1e-50")) continue;
    ++compared;
    CAPTURE(compared, problem.mu, problem.e);
    CHECK(abs(fine.s - s1) < Real("1e-45"));
    CHECK(abs(fine.p - real(t.p_f)) < Real("1e-45"));
  }
}

// Stuck when compression ends, p_c is algebra: u is 0 there. Stronge's W_r = e² |W_c| then asks for the work of
// friction, so that all of the slip's course until it stops is in p_f: W_c = u0·P_c/2 + μ D, p_f = p_c + e √(2 |W_c|
// (K⁻¹)_nn).
TEST_CASE("impulse: the hodograph, in 80 digits, until slip stops") {
  Dice dice(53);
  int compared = 0;
  while (compared < 1) {
    tests::ImpactProblem problem = turning(dice);
    problem.law = Law::stronge;
    const ImpulseTruth t = impulse(tests::scene(problem));
    if (!t.modes.slip_stops_in_compression || !t.modes.sticks || t.modes.straight) continue;
    const Equations e = equations(t, problem.mu);
    const Planar before = tangential(t.u0_W);
    const Real s0 = sqrt(before.x * before.x + before.y * before.y);
    const Real from = atan2(before.y, before.x);
    const Hodograph hodograph(e);
    const auto goal = hodograph.goal(from, e.h(before.x / s0, before.y / s0) > 0);
    REQUIRE(goal);
    const Real length = 58 / goal->power;  // s² falls to e^-116, 1e-50
    if (goal->power < 1) continue;         // the angle would fall below the digits that h has left
    const Hodograph::End coarse = hodograph.until_stop(from, goal->angle, s0, 20, length);
    const Hodograph::End fine = hodograph.until_stop(from, goal->angle, s0, 28, length);
    if (abs(coarse.D - fine.D) > Real("1e-47")) continue;
    ++compared;
    const auto K = [&](std::size_t i, std::size_t j) { return real(t.K_W[i][j]); };
    const Real c0 = K(1, 1) * K(2, 2) - K(1, 2) * K(1, 2);
    const Real c1 = K(0, 2) * K(1, 2) - K(0, 1) * K(2, 2);
    const Real c2 = K(0, 1) * K(1, 2) - K(0, 2) * K(1, 1);
    const Real det = K(0, 0) * c0 + K(0, 1) * c1 + K(0, 2) * c2;
    const Real inverse_02 = c2 / det;
    const Real inverse_12 = (K(0, 1) * K(0, 2) - K(0, 0) * K(1, 2)) / det;
    const Real inverse_22 = (K(0, 0) * K(1, 1) - K(0, 1) * K(0, 1)) / det;
    const Real inverse_00 = c0 / det;
    const Real inverse_01 = c1 / det;
    const Real inverse_11 = (K(0, 0) * K(2, 2) - K(0, 2) * K(0, 2)) / det;
    const std::array<Real, 3> u = {real(t.u0_W[0]), real(t.u0_W[1]), real(t.u0_W[2])};
    const Real p_c = -(inverse_02 * u[0] + inverse_12 * u[1] + inverse_22 * u[2]);
    const Real T0 = (inverse_00 * u[0] * u[0] + inverse_11 * u[1] * u[1] + inverse_22 * u[2] * u[2]) / 2 +
                    inverse_01 * u[0] * u[1] + inverse_02 * u[0] * u[2] + inverse_12 * u[1] * u[2];
    const Real W_c = -T0 + e.mu * fine.D;
    CAPTURE(compared, problem.mu, problem.e);
    CHECK(abs(real(t.p_c) - p_c) < Real("1e-45"));
    CHECK(abs(real(t.p_f) - (p_c + problem.e * sqrt(-2 * W_c * inverse_22))) < Real("1e-45"));
  }
}

using Long = long double;

/// The equations in p: dP_t/dp = −μ u_t/|u_t|, dP_n/dp = 1, by the classical Runge-Kutta steps. Slip must not stop.
struct Direct {
  std::array<std::array<Long, 3>, 3> K;
  std::array<Long, 3> u0;
  Long mu;

  using P = std::array<Long, 3>;

  P u(const P& impulse) const {
    P result = u0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) result[i] += K[i][j] * impulse[j];
    }
    return result;
  }

  P slope(const P& impulse) const {
    const P now = u(impulse);
    const Long s = std::sqrt(now[0] * now[0] + now[1] * now[1]);
    return {-mu * now[0] / s, -mu * now[1] / s, 1};
  }

  P step(const P& from, Long dp) const {
    const auto moved = [](P a, const P& d, Long by) {
      for (std::size_t i = 0; i < 3; ++i) a[i] += by * d[i];
      return a;
    };
    const P a = slope(from);
    const P b = slope(moved(from, a, dp / 2));
    const P c = slope(moved(from, b, dp / 2));
    const P d = slope(moved(from, c, dp));
    return moved(moved(moved(moved(from, a, dp / 6), b, dp / 3), c, dp / 3), d, dp / 6);
  }

  P until(Long p, int steps) const {
    P impulse{};
    for (int i = 0; i < steps; ++i) impulse = step(impulse, p / steps);
    return impulse;
  }
};

Direct direct_of(const ImpulseTruth& t, double mu) {
  Direct direct{};
  direct.mu = mu;
  for (std::size_t i = 0; i < 3; ++i) {
    direct.u0[i] = t.u0_W[i].nearest();
    for (std::size_t j = 0; j < 3; ++j) direct.K[i][j] = t.K_W[i][j].nearest();
  }
  return direct;
}

TEST_CASE("impulse: the equations in p, by Runge-Kutta, end where the series do") {
  Dice dice(52);
  int compared = 0;
  while (compared < 100) {
    tests::ImpactProblem problem = turning(dice);
    const ImpulseTruth t = impulse(tests::scene(problem));
    if (!turns_throughout(t)) continue;
    const Direct direct = direct_of(t, problem.mu);
    const auto end = direct.until(static_cast<Long>(t.p_f.nearest()), 4000);
    const auto half = direct.until(static_cast<Long>(t.p_f.nearest()), 2000);
    const Long own_error = std::hypot(end[0] - half[0], end[1] - half[1]);
    if (own_error > 1e-11L) continue;  // slip nearly stopped: the equation is stiff there
    ++compared;
    CAPTURE(compared, problem.mu, problem.e);
    const auto at_p_c = direct.u(direct.until(static_cast<Long>(t.p_c.nearest()), 4000));
    CHECK(std::abs(at_p_c[2]) < 1e-13L + own_error);
    for (std::size_t i = 0; i < 2; ++i) {
      CHECK(std::abs(end[i] - static_cast<Long>(t.P_A_W[i].nearest())) < 1e-13L + own_error);
    }
  }
}

// u_n rises above 0 and would fall below it again, as friction turns. On the way its work reaches what is restored.
TEST_CASE("impulse: Stronge's restitution ends where the work is restored for the first time, also before u_n falls") {
  const tests::ImpactProblem low{.I = tests::diagonal(2.125, 8.75, 7.375),
                                 .r = {-1, 2, -2},
                                 .v = {-5, 3, -0.157958984375},
                                 .law = Law::stronge,
                                 .e = 0.03125,
                                 .mu = 2.25};
  tests::ImpactProblem higher = low;
  higher.e = 0.125;
  tests::ImpactProblem steep = low;
  steep.I = tests::diagonal(1.25, 1.5, 1.75);
  steep.r = {-5, 7, -4};
  steep.v = {-4, 2, -0.09228515625};
  steep.e = 0.75;
  for (const tests::ImpactProblem& problem : {low, higher, steep}) {
    const ImpulseTruth t = impulse(tests::scene(problem));
    const Direct direct = direct_of(t, problem.mu);
    const Long dp = 1e-5L;
    Direct::P impulse{};
    Long work = 0, compression = 0, u_n = direct.u0[2];
    while (impulse[2] < 4 && !(u_n > 0 && work >= -static_cast<Long>(problem.e * problem.e) * compression)) {
      impulse = direct.step(impulse, dp);
      const Long next = direct.u(impulse)[2], gained = dp * (u_n + next) / 2;
      (u_n + next < 0 ? compression : work) += gained;
      u_n = next;
    }
    CHECK(std::abs(impulse[2] - static_cast<Long>(t.p_f.nearest())) < 1e-4L);
  }
}

}  // namespace
}  // namespace touchstone::reference
