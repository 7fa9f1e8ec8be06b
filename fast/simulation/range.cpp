#include "fast/simulation/range.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "fast/simulation.h"
#include "fast/simulation/prediction/pair_time_of_impact.h"
#include "model/limits.h"

namespace touchstone::fast::simulation {
namespace {

constexpr double greatest = 0x1p250, least = 0x1p-250;            // of quantities that are squared twice
constexpr double greatest_sum = 0x1p1000, least_sum = 0x1p-1000;  // of quantities that are products already
constexpr double least_resolution = 0x1p-10;  // of a body's size: the rounded body still has its shape

double size_of(const BodyMotion& body) { return body.kind() == Kind::ball ? body.radius() : size(body.body().shape); }

double most(const Vec3& v) { return v.cwiseAbs().maxCoeff(); }

[[noreturn]] void refuse(const std::string& place, const char* what) {
  throw BeyondDoubles(place, std::string(what) + ": the simulation computes in doubles, whose range its square leaves");
}

void refuse_mass(const std::string& place, const BodyMotion& body) {
  const double mass = 1 / body.inverse_mass();
  const Vec3 moments = inertia(body).diagonal();
  const auto fits = [](double x) { return x > least_sum && x < greatest_sum; };
  if (!fits(mass)) refuse(place + ".mass", "is beyond 2^-1000 to 2^1000 kg");
  if (!fits(moments.minCoeff()) || !fits(moments.maxCoeff())) {
    refuse(place + ".mass", "has a moment of inertia beyond 2^-1000 to 2^1000 kg m²");
  }
  const double v = most(body.path().v), w = most(body.path().w);
  if (!(mass * v * v < greatest_sum) || !(moments.maxCoeff() * w * w < greatest_sum)) {
    refuse(place + ".velocity", "is an energy beyond 2^1000 J");
  }
}

}  // namespace

void refuse_beyond_doubles(const Scene& scene, const std::vector<BodyMotion>& bodies) {
  if (!(most(scene.gravity) < greatest)) refuse("gravity", "is not below 2^250 m/s²");
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    const std::string place = "bodies[" + std::to_string(i) + "]";
    if (!(most(body.X_WB.p_WB) < greatest)) refuse(place + ".X_WB.p", "is not below 2^250 m");
    if (!(bodies[i].radius() < greatest)) refuse(place + ".shape", "is not smaller than 2^250 m");
    if (!(size(body.shape) > least)) refuse(place + ".shape", "is not greater than 2^-250 m");
    if (!(most(body.velocity.v_WBcm) < greatest)) refuse(place + ".velocity.v_WBcm", "is not below 2^250 m/s");
    const bool points_move = bodies[i].kind() != Kind::ball;  // the spin of a ball moves no point of its shape
    if (points_move && !(most(body.velocity.w_WB) * std::max(1.0, bodies[i].radius()) < greatest)) {
      refuse(place + ".velocity.w_WB", "moves points no slower than 2^250 m/s");
    }
    if (!bodies[i].fixed()) refuse_mass(place, bodies[i]);
  }
  for (std::size_t k = 0; k < scene.motion->forces.size(); ++k) {
    const AppliedForce& force = scene.motion->forces[k];
    const double acceleration = bodies[static_cast<std::size_t>(force.body)].inverse_mass() * most(force.force_W);
    if (!(acceleration < greatest)) {
      refuse("motion.forces[" + std::to_string(k) + "].force_W", "accelerates its body by no less than 2^250 m/s²");
    }
  }
}

bool positions_resolved(const BodyMotion& a, const BodyMotion& b, double rounding) {
  return rounding < least_resolution * std::min(size_of(a), size_of(b));
}

}  // namespace touchstone::fast::simulation
