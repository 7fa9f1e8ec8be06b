// The families of impacts reach what they are for: counted from the reference's answers and from the drawn numbers.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "oracle/truth/impact.h"
#include "oracle/truth/truth.h"
#include "tests/catch.h"
#include "tests/properties/scenes/drawn.h"

using namespace touchstone;
using tests::count;
using tests::drawn;

namespace {

constexpr int draws = 200;

}  // namespace

TEST_CASE("drawn impacts: contact.jamming compresses a second time, and slip stops in restitution") {
  const std::vector<Scene> scenes = drawn("contact.jamming", draws);
  const auto modes = [](const Scene& s) { return oracle::truth::impulse(s).modes; };
  CHECK(count(scenes, [&](const Scene& s) { return modes(s).recompressed; }) >= 25);
  CHECK(count(scenes, [&](const Scene& s) { return modes(s).painleve; }) >= 100);
  CHECK(count(scenes, [&](const Scene& s) { return modes(s).slip_stops_in_restitution; }) >= 50);
}

TEST_CASE("drawn impacts: contact.times_powers goes beyond 2^200, both ways") {
  const std::vector<Scene> scenes = drawn("contact.times_powers", draws);
  const auto speed = [](const Scene& s) {
    return std::max(s.bodies[0].velocity.v_WBcm.cwiseAbs().maxCoeff(),
                    s.bodies[1].velocity.v_WBcm.cwiseAbs().maxCoeff());
  };
  CHECK(count(scenes, [&](const Scene& s) { return speed(s) >= 0x1p200; }) >= 8);
  CHECK(count(scenes, [&](const Scene& s) { return speed(s) <= 0x1p-200; }) >= 8);
}

TEST_CASE("drawn impacts: contact.rods strikes needles along their axis, and nearly") {
  const std::vector<Scene> scenes = drawn("contact.rods", draws);
  // The sine of the angle between the arm and the normal, of a body whose least moment is below 2^-7 of the others.
  const auto sine = [](const Scene& s) {
    for (const oracle::ImpactBody& body : oracle::impact(s).bodies) {
      if (body.fixed || body.moments[0] > 0x1p-7L * body.moments[1]) continue;
      const oracle::Point n = oracle::impact(s).nhat_BA_W;
      return static_cast<double>(body.p_BcmC_W.cross(n).norm() / body.p_BcmC_W.norm());
    }
    return 1.0;
  };
  CHECK(count(scenes, [&](const Scene& s) { return sine(s) == 0; }) >= 20);
  CHECK(count(scenes, [&](const Scene& s) { return sine(s) > 0 && sine(s) < 0x1p-8; }) >= 10);
}

TEST_CASE("drawn impacts: contact.off_centre has turned bodies with the centre of mass off the origin") {
  const auto is_off = [](const Body& body) {
    const auto* given = std::get_if<MassProperties>(&body.mass);
    return given != nullptr && !given->p_BBcm.isZero(0);
  };
  const std::vector<Scene> scenes = drawn("contact.off_centre", draws);
  CHECK(count(scenes, [&](const Scene& s) { return is_off(s.bodies[0]) || is_off(s.bodies[1]); }) >= 180);
  CHECK(count(scenes, [&](const Scene& s) { return is_off(s.bodies[0]) && is_off(s.bodies[1]); }) >= 30);
  for (const Scene& scene : scenes) {  // C is where it was drawn: at most 4 + 4√3 from each centre of mass
    for (std::size_t i = 0; i < 2; ++i) {
      if (is_off(scene.bodies[i])) CHECK(oracle::impact(scene).bodies[i].p_BcmC_W.norm() < 7);
    }
  }
}
