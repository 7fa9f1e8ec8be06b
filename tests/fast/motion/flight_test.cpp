#include "fast/motion/flight.h"

#include <cmath>

#include "fast/lin_canny/rotation.h"
#include "fast/motion/sine.h"
#include "reference/flight.h"
#include "reference/validity.h"
#include "tests/catch.h"
#include "tests/fast/motion/random_flight.h"

namespace touchstone::fast::motion {
namespace {

using tests::RandomFlight;

double beyond(double x, const Interval& truth) { return std::max({0.0, truth.lo - x, x - truth.hi}); }

/// How far a stand is from the truth (m, of the points at one metre), and how far it says it may be.
struct Compared {
  double off = 0, claimed = 0, w_off = 0, w_claimed = 0;
};

Compared compare(const Scene& scene, double t) {
  const Flyer flyer(scene.bodies[0]);
  const Vec3 a = flyer.is_fixed ? Vec3(Vec3::Zero()) : scene.gravity;
  const Flight flight(flyer, 0, scene.bodies[0].X_WB, scene.bodies[0].velocity, a);
  const Stand now = flight.stand(t);
  const reference::FlightTruth truth = reference::flown(scene, 0, t);
  Compared c;
  Mat3 R_off;
  Vec3 p_off, w_off;
  const Vec3 p_WB = now.centre.p_WOBcm - now.R_WB * flyer.p_BBcm;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto e = static_cast<Eigen::Index>(i);
    for (std::size_t j = 0; j < 3; ++j) {
      R_off(e, static_cast<Eigen::Index>(j)) = beyond(now.R_WB(e, static_cast<Eigen::Index>(j)), truth.R_WB[i][j]);
    }
    p_off[e] = beyond(p_WB[e], truth.p_WB[i]);
    w_off[e] = beyond(now.w_WB[e], truth.w_WB[i]);
  }
  c.off = R_off.norm() + p_off.norm();
  c.claimed = now.turn_error * (1 + flyer.p_BBcm.norm()) + now.centre.error;
  c.w_off = w_off.norm();
  c.w_claimed = now.w_error;
  return c;
}

TEST_CASE("sine and cosine are as near as they say") {
  tests::Bits bits(1);
  for (int i = 0; i < 20'000; ++i) {
    const double x = std::ldexp(static_cast<double>(bits.next() >> 11), -53 + bits.below(48));
    const SineCosine found = sine_cosine(x);
    const double allowed = (4 + 2 * x) * u;  // one u for the library's own
    REQUIRE(std::abs(found.sine - std::sin(x)) <= allowed);
    REQUIRE(std::abs(found.cosine - std::cos(x)) <= allowed);
  }
}

TEST_CASE("flights stand where the reference says, within what they claim") {
  RandomFlight random(2);
  double worst = 0;
  for (int i = 0; i < 60; ++i) {
    const Scene scene = reference::completed(random.alone(i % 6));
    for (const double t : {0.0, 0.03125, 0.5, 1.0}) {
      const Compared c = compare(scene, t);
      CAPTURE(i, t, c.off, c.claimed, c.w_off, c.w_claimed);
      REQUIRE(c.off <= c.claimed);
      REQUIRE(c.w_off <= c.w_claimed + 0x1p-1000);
      if (i % 6 < 4) worst = std::max(worst, c.claimed);
    }
  }
  CHECK(worst < 1e-11);
}

}  // namespace
}  // namespace touchstone::fast::motion
