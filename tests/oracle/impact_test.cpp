// Compares the judge's own K and u, in long double, with the exact values of the reference.
#include "oracle/truth/impact.h"

#include <cmath>

#include "oracle/subject.h"
#include "oracle/tolerance/impulse.h"
#include "oracle/truth/truth.h"
#include "tests/catch.h"

namespace touchstone::oracle {
namespace {

Scene skewed() {
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].shape = Box{Vec3(1, 2, 3)};
  scene.bodies[0].X_WB = {{0.1, 0.2, 0.3}, {3, 1, -2, 1}};
  scene.bodies[0].velocity = {{1, -2, 0.5}, {0.25, 3, -1}};
  scene.bodies[1].shape = Sphere{1};
  MassProperties given;
  given.mass = 0.7;
  given.p_BBcm = {0.3, -0.2, 0.1};
  given.I_BBcm_B << 5, 1, 0.5, 1, 6, 0.25, 0.5, 0.25, 7;
  scene.bodies[1].mass = given;
  scene.bodies[1].X_WB = {{-1, 0.5, -2}, {1, -1, 2, 0.5}};
  scene.bodies[1].velocity = {{-1, 0, 2}, {1, 1, -1}};
  scene.contact = Contact{{0.5, 0.25, -1}, {0.6, 0, 0.8}, Law::poisson, 0.5, 0.25};
  return truth::completed(scene);
}

Real value(const reference::Rational& x) {  // two doubles: 106 bits
  const double high = x.nearest();
  return static_cast<Real>(high) + static_cast<Real>((x - reference::Rational(high)).nearest());
}

TEST_CASE("Impact: K and u are the reference's to 2^-58") {
  Scene scene = skewed();
  for (int i = 0; i < 2; ++i) {
    const Impact it = impact(scene);
    const reference::ImpulseTruth& truth = truth::impulse(scene);
    for (Eigen::Index r = 0; r < 3; ++r) {
      const auto row = static_cast<std::size_t>(r);
      CHECK(std::abs(it.u[r] - value(truth.u0_W[row])) <= 0x1p-58L * it.u.norm());
      for (Eigen::Index c = 0; c < 3; ++c) {
        CHECK(std::abs(it.K(r, c) - value(truth.K_W[row][static_cast<std::size_t>(c)])) <= 0x1p-58L * it.K.norm());
      }
    }
    scene.bodies[0].mass = Fixed{};
  }
}

TEST_CASE("Impact: norms and parts") {
  const Impact it = impact(skewed());
  CHECK(static_cast<double>(it.nhat_BA_W.norm()) == Approx(1));
  CHECK(static_cast<double>(it.u_t().dot(it.nhat_BA_W)) == Approx(0).margin(1e-17));
  CHECK(static_cast<double>(it.energy_norm(it.K * it.nhat_BA_W)) == Approx(static_cast<double>(std::sqrt(it.K_nn()))));
  CHECK(it.condition() >= 1);
  CHECK(it.condition() <= 60);
}

// Moments of 6e11 : 1, so K has one eigenvalue that is 3e11 times the others. N(K x)² = xᵀ K x, whatever x is.
TEST_CASE("Impact: norms and impulses keep their digits in the stiff direction of a needle") {
  Scene scene = skewed();
  scene.bodies[0].mass = Fixed{};
  MassProperties needle;
  needle.mass = 0x1p-30;
  needle.p_BBcm = {0x1p-9, 0, 0};
  needle.I_BBcm_B = Vec3(0x9p-50, 0x9p-50, 0x9p-89).asDiagonal();
  scene.bodies[1].mass = needle;
  scene.bodies[1].X_WB = {{0, 0, 0}, {16, -1, 0, 0}};
  scene.contact->p_WC = {0, 0x1p-9, 0};
  const Impact it = impact(scene);
  REQUIRE(it.condition() > 0x1p36L);
  REQUIRE(it.condition() < 0x1p43L);
  for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, -2, 3)}) {
    const Point x = direction.cast<Real>(), du = it.K * x;
    const Real N = it.energy_norm(du), exact = x.dot(du);
    CHECK(std::abs(N * N - exact) <= 0x1p-20L * exact);
    CHECK(it.energy_norm(it.K * (it.impulse_for(du) - x)) <= 0x1p-20L * N);
  }
  CHECK((it.K_inverse() * it.K - Matrix::Identity()).norm() < 1);
}

TEST_CASE("tolerance::impulse: 0 only for nothing, more for fewer bits, and in the solver's measure") {
  const Scene scene = skewed();
  const Impact it = impact(scene);
  const std::array<Velocity, 2> after = {scene.bodies[0].velocity, scene.bodies[1].velocity};
  const double exact = tolerance::impulse(scene, it, after, Precision::exact);
  const double doubles = tolerance::impulse(scene, it, after, Precision::binary64);
  const double floats = tolerance::impulse(scene, it, after, Precision::binary32);
  CHECK(exact > 0);
  CHECK(doubles > 100 * exact);
  CHECK(floats == Approx(0x1p29 * doubles).epsilon(1e-6));
  const double N = static_cast<double>(it.energy_norm(it.u));
  CHECK(doubles > 256 * 0x1p-53 * N);
  CHECK(doubles < 0x1p20 * 0x1p-53 * N);
}

TEST_CASE("tolerance::impact_in_range: squares of floats vanish long before those of doubles") {
  Scene scene = skewed();
  for (Body& body : scene.bodies) body.velocity.v_WBcm *= 0x1p-60, body.velocity.w_WB *= 0x1p-60;
  CHECK(tolerance::impact_in_range(impact(scene), Precision::binary64));
  CHECK_FALSE(tolerance::impact_in_range(impact(scene), Precision::binary32));
}

}  // namespace
}  // namespace touchstone::oracle
