#include "properties/transforms/motion.h"

#include <algorithm>
#include <cmath>

#include "properties/cases/central_ball.h"
#include "properties/transforms/exact_sum.h"

namespace touchstone::properties {
namespace {

bool start_at_once(const Scene& scene) {
  const std::vector<double>& starts = scene.motion->start_times;
  return std::ranges::all_of(starts, [&](double t) { return t == starts.front(); });
}

// Multiplies by 2^k. Returns whether that can be undone.
bool scale(double& x, int k) {
  const double before = x;
  x = std::ldexp(before, k);
  return std::isfinite(x) && std::ldexp(x, -k) == before;
}
bool scale(Vec3& v, int k) {
  return std::all_of(v.data(), v.data() + 3, [k](double& x) { return scale(x, k); });
}

bool shift(double& x, double by) {
  const std::optional<double> sum = exact_sum({x, by});
  if (sum) x = *sum;
  return sum.has_value();
}

// Ignores underflow: motions of such sizes do not occur.
std::optional<double> exact_product(double a, double b) {
  const double product = a * b;
  if (!std::isfinite(product) || std::fma(a, b, -product) != 0) return std::nullopt;
  return product;
}

// One coordinate of x + v τ + g τ²/2 and v + g τ.
bool fly(double& x, double& v, double g, double tau) {
  const auto way = exact_product(v, tau), gained = exact_product(g, tau);
  const auto fall = gained ? exact_product(*gained, tau / 2) : std::nullopt;
  if (!way || !fall) return false;
  const auto place = exact_sum({x, *way, *fall}), speed = exact_sum({v, *gained});
  if (!place || !speed) return false;
  x = *place;
  v = *speed;
  return true;
}

}  // namespace

std::optional<Scene> hastened(Scene scene, int k) {
  Motion& motion = *scene.motion;
  bool exact = scale(scene.gravity, 2 * k) && scale(motion.force_bound, 2 * k);
  for (Body& body : scene.bodies) exact = exact && scale(body.velocity.v_WBcm, k) && scale(body.velocity.w_WB, k);
  for (double& time : motion.sample_times) exact = exact && scale(time, -k);
  for (double& start : motion.start_times) exact = exact && scale(start, -k);
  for (AppliedForce& applied : motion.forces) exact = exact && scale(applied.time, -k) && scale(applied.force_W, 2 * k);
  return exact ? std::optional(scene) : std::nullopt;
}

std::optional<Scene> heavier(Scene scene, int k) {
  bool exact = scale(scene.motion->force_bound, k);
  for (AppliedForce& applied : scene.motion->forces) exact = exact && scale(applied.force_W, k);
  for (Body& body : scene.bodies) {
    if (auto* density = std::get_if<Density>(&body.mass)) exact = exact && scale(density->value, k);
    auto* given = std::get_if<MassProperties>(&body.mass);
    if (given == nullptr) continue;
    exact = exact && scale(given->mass, k);
    for (double& x : given->I_BBcm_B.reshaped()) exact = exact && scale(x, k);
  }
  return exact ? std::optional(scene) : std::nullopt;
}

std::optional<Scene> later(Scene scene, double seconds) {
  Motion& motion = *scene.motion;
  motion.start_times.resize(scene.bodies.size(), 0);
  bool exact = true;
  for (double& time : motion.sample_times) exact = exact && shift(time, seconds);
  for (double& start : motion.start_times) exact = exact && shift(start, seconds);
  for (AppliedForce& applied : motion.forces) exact = exact && shift(applied.time, seconds);
  return exact ? std::optional(scene) : std::nullopt;
}

std::optional<Scene> carried(Scene scene) {
  if (!start_at_once(scene)) return std::nullopt;
  double fastest = 0;
  for (const Body& body : scene.bodies) fastest = std::max(fastest, body.velocity.v_WBcm.cwiseAbs().maxCoeff());
  if (fastest == 0) return std::nullopt;
  const Vec3 v = std::exp2(std::ceil(std::log2(fastest))) * Vec3(0.5, -1, 2);
  for (Body& body : scene.bodies) {
    const std::optional<Vec3> sum = exact_sum(body.velocity.v_WBcm, v);
    if (!sum) return std::nullopt;
    body.velocity.v_WBcm = *sum;
  }
  return scene;
}

std::optional<Scene> weightless(Scene scene) {
  if (scene.gravity.isZero(0) || !start_at_once(scene) || std::ranges::any_of(scene.bodies, is_fixed)) {
    return std::nullopt;
  }
  scene.gravity.setZero();
  return scene;
}

std::optional<Scene> spun_balls(Scene scene) {
  bool any = false;
  for (Body& body : scene.bodies) {
    if (!is_central_ball(body)) continue;
    body.velocity.w_WB = body.velocity.w_WB.isZero(0) ? Vec3(1, -2, 3) : Vec3(0, 0, 0);
    any = true;
  }
  return any ? std::optional(scene) : std::nullopt;
}

std::optional<Scene> taken_up_at(Scene scene, double time) {
  Motion& motion = *scene.motion;
  if (!motion.forces.empty()) return std::nullopt;
  motion.start_times.resize(scene.bodies.size(), 0);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    Body& body = scene.bodies[i];
    const auto tau = exact_sum({time, -motion.start_times[i]});
    if (!tau || *tau < 0 || !(body.velocity.w_WB.isZero(0) || is_central_ball(body))) return std::nullopt;
    for (Eigen::Index k = 0; k < 3; ++k) {
      const double g = is_fixed(body) ? 0 : scene.gravity[k];
      if (!fly(body.X_WB.p_WB[k], body.velocity.v_WBcm[k], g, *tau)) return std::nullopt;
    }
    motion.start_times[i] = time;
  }
  std::erase_if(motion.sample_times, [time](double t) { return t <= time; });
  return scene;
}

std::optional<Scene> backwards(const Scene& scene) {
  const std::vector<double>& starts = scene.motion->start_times;
  const double start = starts.empty() ? 0 : *std::ranges::max_element(starts), end = scene.motion->sample_times.back();
  const auto length = exact_sum({end, -start});
  std::optional<Scene> there = taken_up_at(scene, end);
  if (!there || !length) return std::nullopt;
  for (Body& body : there->bodies) body.velocity = {-body.velocity.v_WBcm, -body.velocity.w_WB};
  there->motion->start_times.clear();
  there->motion->sample_times = {*length};
  return there;
}

}  // namespace touchstone::properties
