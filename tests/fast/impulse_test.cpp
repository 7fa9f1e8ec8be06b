// Scenes: the impulse against the exact one, in the energy norm; momentum; invalid queries.
#include "fast/impulse.h"

#include <cmath>
#include <limits>

#include "model/infinity.h"
#include "model/input_error.h"
#include "properties/random.h"
#include "reference/impulse.h"
#include "reference/validity.h"
#include "tests/catch.h"

namespace touchstone::fast {
namespace {

double between(properties::Random& random, double lo, double hi) { return lo + (hi - lo) * random.unit(); }

Vec3 some_vector(properties::Random& random, double size) {
  return {between(random, -size, size), between(random, -size, size), between(random, -size, size)};
}

Body some_body(properties::Random& random, const Vec3& p_WC, double slenderness) {
  Body body;
  body.shape = Box{Vec3(1, std::exp2(between(random, -slenderness, slenderness)), std::exp2(between(random, -1, 1)))};
  body.X_WB.q_WB = {between(random, -1, 1), between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)};
  body.X_WB.p_WB = p_WC + some_vector(random, 1);
  body.velocity = {some_vector(random, 1), some_vector(random, 1)};
  body.mass = Density{std::exp2(between(random, -4, 4))};
  return body;
}

Scene some_impact(properties::Random& random, Law law, double slenderness, double friction) {
  Scene scene;
  Contact contact;
  contact.p_WC = some_vector(random, 4);
  contact.nhat_BA_W = some_vector(random, 1).normalized();
  contact.law = law;
  contact.restitution = between(random, 0, 1);
  contact.friction = between(random, 0, friction);
  scene.bodies = {some_body(random, contact.p_WC, slenderness), some_body(random, contact.p_WC, slenderness)};
  if (random.one_in(3)) scene.bodies[1].mass = Fixed{};
  scene.contact = contact;
  return scene;
}

Vec3 nearest(const reference::ExactVec3& v) { return {v[0].nearest(), v[1].nearest(), v[2].nearest()}; }

/// |P − P*|_K.
double error_of(const Vec3& P, const reference::ImpulseTruth& truth) {
  const auto off = [&](std::size_t k) { return reference::Rational(P[static_cast<Eigen::Index>(k)]) - truth.P_A_W[k]; };
  const reference::ExactVec3 d{off(0), off(1), off(2)};
  reference::Rational square;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) square = square + d[i] * truth.K_W[i][j] * d[j];
  }
  return std::sqrt(std::max(square.nearest(), 0.0));
}

void agrees(int count, double slenderness, double friction) {
  properties::Random random(7);
  double worst = 0;
  int curved = 0, approached = 0;
  for (int k = 0; k < count; ++k) {
    const Law law = k % 4 == 2 ? Law::stronge : k % 4 == 3 ? Law::newton : Law::poisson;
    const Scene scene = reference::completed(some_impact(random, law, slenderness, friction));
    const Impacted said = impact(scene);
    const reference::ImpulseTruth truth = reference::impulse(scene);
    CAPTURE(k, said.P_A_W.transpose(), nearest(truth.P_A_W).transpose(), said.outcome.regime.curved);
    REQUIRE(said.outcome.regime.approached == !truth.modes.separating);
    if (truth.ambiguous || truth.modes.separating) continue;
    const double error = error_of(said.P_A_W, truth);
    REQUIRE(error <= said.error);
    worst = std::max(worst, error / said.error);
    ++approached;
    curved += said.outcome.regime.curved;
  }
  WARN("worst share of the claimed error: " << worst << "; " << approached << " approached, " << curved << " curved");
  CHECK(4 * curved > approached);
}

TEST_CASE("impulses of boxes are the exact ones within the claimed error") { agrees(200, 1, 1); }
TEST_CASE("impulses of rods and plates with much friction are the exact ones within the claimed error") {
  agrees(200, 8, 5);
}

// A ball that slides is stopped by any approach, however slow, and goes on if it only just separates.
TEST_CASE("an impulse is ambiguous where rounding decides whether infinite friction acts") {
  const auto down = [](double speed) {
    Scene scene;
    scene.bodies.resize(2);
    scene.bodies[0].shape = Sphere{1};
    scene.bodies[0].X_WB.p_WB = {0, 0, 1};
    scene.bodies[0].velocity.v_WBcm = {1, 0, -speed};
    scene.bodies[1].shape = Box{Vec3(4, 4, 1)};
    scene.bodies[1].X_WB.p_WB = {0, 0, -1};
    scene.bodies[1].mass = Fixed{};
    scene.contact = Contact{.p_WC = Vec3::Zero(), .nhat_BA_W = Vec3::UnitZ()};
    scene.contact->friction = infinity;
    return scene;
  };
  for (const double hidden : {0x1p-50, -0x1p-50}) {
    CHECK(impulse_of(down(hidden)).ambiguous.has_value());
    CHECK(reference::impulse(down(hidden)).ambiguous.has_value());
  }
  CHECK_FALSE(impulse_of(down(1)).ambiguous.has_value());
  CHECK_FALSE(reference::impulse(down(1)).ambiguous.has_value());
}

TEST_CASE("momentum: what A gains B loses, but for rounding the velocities") {
  properties::Random random(3);
  for (int k = 0; k < 1000; ++k) {
    const Scene scene = some_impact(random, Law::poisson, 2, 1);
    const Impacted said = impact(scene);
    if (std::holds_alternative<Fixed>(scene.bodies[1].mass)) {
      CHECK(said.after[1] == scene.bodies[1].velocity);
    } else if (said.outcome.regime.approached) {
      const auto mass_of = [&](std::size_t b) {
        const Vec3& h = std::get<Box>(scene.bodies[b].shape).half_extents;
        return 8 * h.prod() * std::get<Density>(scene.bodies[b].mass).value;
      };
      Vec3 change = Vec3::Zero();
      for (const std::size_t b : {0, 1}) {
        change += mass_of(b) * (said.after[b].v_WBcm - scene.bodies[b].velocity.v_WBcm);
      }
      const double momenta = mass_of(0) * 4 + mass_of(1) * 4 + said.P_A_W.norm();
      CHECK(change.norm() <= 16 * 0x1p-53 * momenta);
    }
  }
}

TEST_CASE("Newton's law on a long lever: what is claimed counts the energy that it gains") {
  Scene scene;
  Body lever, ground;
  lever.shape = Box{Vec3(1, 1, 1)};
  lever.X_WB.p_WB = Vec3(-0x1p18, -0x1p17, -0x1p17);
  lever.velocity.v_WBcm = {-2, 1, 3};  // across the lever: K⁻¹ is ill-conditioned there
  lever.mass = MassProperties{2, Vec3::Zero(), 5 * Mat3::Identity()};
  ground.shape = Box{Vec3(16, 16, 16)};
  scene.bodies = {lever, ground};
  scene.contact = Contact{Vec3::Zero(), Vec3(0, -1, 0), Law::newton, 0.75, std::numeric_limits<double>::infinity()};
  const Impacted said = impact(scene);
  const reference::ImpulseTruth truth = reference::impulse(scene);
  CHECK(truth.error == 0);
  CHECK(error_of(said.P_A_W, truth) <= said.error);
  CHECK(said.error <= 1e-2 * said.P_A_W.norm());
}

TEST_CASE("Stronge's law with next to no restitution") {
  properties::Random random(11);
  for (const double e : {0x1p-8, 0x1p-14, 0x1p-20, 0x1p-30, 0x1p-60}) {
    for (int k = 0; k < 20; ++k) {
      Scene scene = some_impact(random, Law::stronge, 1, 1);
      scene.contact->restitution = e;
      scene = reference::completed(scene);
      const Impacted said = impact(scene);
      CAPTURE(e, k);
      CHECK(error_of(said.P_A_W, reference::impulse(scene)) <= said.error);
    }
  }
}

TEST_CASE("a scene without a contact has no impulse") { CHECK_THROWS_AS(impact(Scene{}), InputError); }

}  // namespace
}  // namespace touchstone::fast
