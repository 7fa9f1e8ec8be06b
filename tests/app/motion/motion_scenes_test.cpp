// The scenes in motion, and what is known of them.
#include "app/motion/motion_scenes.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>

#include "model/json.h"
#include "model/limits.h"
#include "reference/broad_phase.h"
#include "reference/distance.h"
#include "reference/validity.h"
#include "tests/catch.h"

using namespace touchstone;
using app::motion_scenes;
using app::MotionScene;

namespace {

const MotionScene& named(const std::string& name) {
  for (const MotionScene& motion : motion_scenes()) {
    if (motion.scene.name == name) return motion;
  }
  throw std::out_of_range(name);
}

std::vector<State> start_of(const Scene& scene) {
  std::vector<State> states;
  for (const Body& body : scene.bodies) states.push_back({body.X_WB, body.velocity});
  return states;
}

/// No body moves.
Trajectory frozen(const Scene& scene) {
  Trajectory answer;
  answer.states.assign(scene.motion->sample_times.size(), start_of(scene));
  return answer;
}

/// The error if the origin of body 0 is at x(t).
double error_of(const std::string& name, const std::function<Vec3(double)>& x) {
  const MotionScene& motion = named(name);
  Trajectory answer = frozen(motion.scene);
  for (std::size_t k = 0; k < answer.states.size(); ++k) {
    answer.states[k][0].X_WB.p_WB = x(motion.scene.motion->sample_times[k]);
  }
  return motion.error(answer);
}

/// Overlap of two fixed bodies is ignored, since it has no effect.
bool overlap(Scene scene, int i, int j) {
  const Body a = scene.bodies[static_cast<std::size_t>(i)], b = scene.bodies[static_cast<std::size_t>(j)];
  if (std::holds_alternative<Fixed>(a.mass) && std::holds_alternative<Fixed>(b.mass)) return false;
  scene.bodies = {a, b};
  return reference::distance(scene).verdict == Verdict::overlapping;
}

}  // namespace

TEST_CASE("motion scenes: each is valid, complete and starts without overlap") {
  REQUIRE(motion_scenes().size() >= 30);
  for (const MotionScene& motion : motion_scenes()) {
    CAPTURE(motion.scene.name);
    REQUIRE_NOTHROW(validate(motion.scene));
    CHECK(reference::completed(motion.scene) == motion.scene);
    for (const auto& [i, j] : reference::broad_phase(motion.scene)) CHECK_FALSE(overlap(motion.scene, i, j));
  }
}

// For a new scene, create an empty file of its name there, and run this test with TOUCHSTONE_UPDATE=1.
TEST_CASE("motion scenes: the files below docs/scenes/motion are these") {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(TOUCHSTONE_SOURCE "/docs/scenes/motion")) {
    if (entry.is_regular_file()) files[entry.path().stem().string()] = entry.path().string();
  }
  CHECK(files.size() == motion_scenes().size());
  for (const MotionScene& motion : motion_scenes()) {
    CAPTURE(motion.scene.name);
    REQUIRE(files.contains(motion.scene.name));
    const std::string& path = files[motion.scene.name];
    if (std::getenv("TOUCHSTONE_UPDATE") != nullptr) write_text(path, text_of(json_of(motion.scene)));
    CHECK(read_scene(path) == motion.scene);
  }
}

TEST_CASE("motion scenes: a scene is known whatever its looks, and no other scene is") {
  Scene scene = named("turntable").scene;
  scene.motion->sample_times = {0.5};
  REQUIRE(app::known_motion(scene) != nullptr);
  CHECK(app::known_motion(scene)->scene.name == "turntable");
  scene.gravity.z() = -9;
  CHECK(app::known_motion(scene) == nullptr);
}

TEST_CASE("motion scenes: what stands still is right about what rests, and wrong about all that moves") {
  for (const MotionScene& motion : motion_scenes()) {
    CAPTURE(motion.scene.name, motion.truth);
    const double error = motion.error(frozen(motion.scene));
    if (motion.truth.starts_with("stays") || motion.truth.find("stays where") != std::string::npos ||
        motion.truth.find("energy") != std::string::npos || motion.truth.starts_with("free turn")) {
      CHECK(error == 0);
    } else {
      CHECK(error > 0.01);
    }
  }
}

TEST_CASE("motion scenes: no look, or NaN, is no right answer") {
  for (const MotionScene& motion : motion_scenes()) {
    CAPTURE(motion.scene.name);
    CHECK(std::isnan(motion.error(Trajectory{})));
    Trajectory answer = frozen(motion.scene);
    for (State& state : answer.states.back()) {
      state.X_WB.p_WB.x() = NAN;
      state.velocity.v_WBcm.x() = NAN;
      state.velocity.w_WB.setConstant(NAN);
    }
    CHECK(std::isnan(motion.error(answer)));
  }
}

// The truths once more, computed by hand or in another way.

TEST_CASE("motion scenes: a bouncing ball") {
  // h = 5/4, g = 10: the ball lands after 1/2 s at 5 m/s, flies for 1/2, 1/4, … s, and is at rest after 1.5 s.
  const auto z = [](double t) {
    if (t <= 0.5) return 1.75 - 5 * t * t;
    double v = 2.5, since = 0.5;
    for (; v > 1e-9 && t > since + v / 5; v /= 2) since += v / 5;
    return v > 1e-9 ? 0.5 + (t - since) * (v - 5 * (t - since)) : 0.5;
  };
  CHECK(error_of("bouncing_ball", [&](double t) { return Vec3(0, 0, z(t)); }) < 1e-15);
  CHECK(error_of("bouncing_ball", [&](double t) { return Vec3(0, 0, z(t) + 1e-6); }) == Approx(0.8e-6).epsilon(1e-6));
}

TEST_CASE("motion scenes: sliding, then rolling") {
  // μ = 1/4: v = 7 − 2.5 t until t = 0.8, when it is 5.
  const auto x = [](double t) { return t < 0.8 ? 7 * t - 1.25 * t * t : 4.8 + 5 * (t - 0.8); };
  CHECK(error_of("slide_to_roll", [&](double t) { return Vec3(x(t), 0, 0.5); }) < 1e-14);
}

TEST_CASE("motion scenes: turntables, by small steps of the law of motion") {
  for (const std::string name : {"turntable", "turntable_tilted"}) {
    const Scene& scene = named(name).scene;
    const auto path = [&](double until) {
      // v' = (4/7) ẑ × v + (5/7) g_t; velocity Verlet's midpoint with steps of about 2⁻¹⁴ s.
      const int steps = static_cast<int>(until * 16384);
      const double h = until / steps;
      Vec3 p = scene.bodies[0].X_WB.p_WB, v = scene.bodies[0].velocity.v_WBcm;
      const auto bent = [&](const Vec3& u) {
        return Vec3(-4.0 / 7 * u.y() + 5.0 / 7 * scene.gravity.x(), 4.0 / 7 * u.x(), 0);
      };
      for (int k = 0; k < steps; ++k) {
        const Vec3 half = v + h / 2 * bent(v);
        p += h * half;
        v += h * bent(half);
      }
      return p;
    };
    CHECK(error_of(name, path) < 1e-7);
  }
}

TEST_CASE("motion scenes: a rattleback, by the force at its foot: it does not slip, keeps its energy and turns back") {
  const MotionScene& motion = named("rattleback");
  const Body& body = motion.scene.bodies[0];
  const auto& given = std::get<MassProperties>(body.mass);
  const auto from_contact = [&](const Mat3& R) {
    const Vec3 d = -R.transpose() * Vec3::UnitZ(), on_arc = Vec3(0, 0, 1) + Vec3(d.x(), 0, d.z()).normalized();
    return Vec3(R * (given.p_BBcm - on_arc - 0.5 * d));
  };
  struct Rate {
    Mat3 R;
    Vec3 w, force;
  };
  const auto rate = [&](const Mat3& R, const Vec3& w) {
    const auto turned = [&](double t) { return Mat3(Eigen::AngleAxisd(t * w.norm(), w.normalized()) * R); };
    const Vec3 c = from_contact(R), c_rate = (from_contact(turned(0x1p-16)) - from_contact(turned(-0x1p-16))) * 0x1p15;
    const Mat3 I = R * given.I_BBcm_B * R.transpose();
    const Vec3 known = w.cross(c_rate) - motion.scene.gravity;
    const Mat3 about_contact = I + c.squaredNorm() * Mat3::Identity() - c * c.transpose();
    const Vec3 bent = about_contact.inverse() * (-w.cross(I * w) - c.cross(known));
    Mat3 R_rate;
    for (int i = 0; i < 3; ++i) R_rate.col(i) = w.cross(R.col(i));
    return Rate{R_rate, bent, known + bent.cross(c)};
  };
  const auto energy = [&](const Mat3& R, const Vec3& w) {
    const Vec3 c = from_contact(R), w_B = R.transpose() * w;
    return w.cross(c).squaredNorm() / 2 + w_B.dot(given.I_BBcm_B * w_B) / 2 - motion.scene.gravity.dot(c);
  };
  Mat3 R = Mat3::Identity();
  Vec3 w = body.velocity.w_WB;
  CHECK((body.velocity.v_WBcm - w.cross(from_contact(R))).norm() == 0);
  const double first = energy(R, w), h = 0x1p-9;
  Trajectory answer = frozen(motion.scene);
  for (std::vector<State>& states : answer.states) {
    for (int k = 0; k < 64; ++k) {
      const Rate r1 = rate(R, w), r2 = rate(R + h / 2 * r1.R, w + h / 2 * r1.w);
      const Rate r3 = rate(R + h / 2 * r2.R, w + h / 2 * r2.w), r4 = rate(R + h * r3.R, w + h * r3.w);
      CHECK(r1.force.head<2>().norm() < body.material.friction * r1.force.z());
      R += h / 6 * (r1.R + 2 * r2.R + 2 * r3.R + r4.R);
      w += h / 6 * (r1.w + 2 * r2.w + 2 * r3.w + r4.w);
    }
    CHECK(energy(R, w) == Approx(first).epsilon(1e-8));
    states[0].velocity.w_WB = w;
  }
  CHECK(motion.error(answer) < 1e-6);
  CHECK(w.z() < -1);
}

TEST_CASE("motion scenes: 3141 impacts of masses 1 : 10⁶, one by one") {
  const MotionScene& motion = named("pi_billiard");
  // Gaps x (small ball to the wall) and y (big ball to the wall, without both balls' widths).
  long double x = 1, y = 2.5L, v = 0, V = -1, now = 0;
  int impacts = 0;
  Trajectory answer = frozen(motion.scene);
  for (std::size_t k = 0; k < answer.states.size();) {
    const long double wall = v < 0 ? -x / v : INFINITY, meet = v > V ? (y - x) / (v - V) : INFINITY;
    const long double sample = motion.scene.motion->sample_times[k] - now;
    const long double step = std::min({wall, meet, sample});
    x += step * v, y += step * V, now += step;
    if (step == sample) {
      answer.states[k][0].X_WB.p_WB.x() = static_cast<double>(x + 0.5L);
      answer.states[k][1].X_WB.p_WB.x() = static_cast<double>(y + 1.5L);
      ++k;
    } else if (step == wall) {
      v = -v, ++impacts;
    } else {
      const long double centre = (v + 1e6L * V) / (1e6L + 1);
      v = 2 * centre - v, V = 2 * centre - V, ++impacts;
    }
  }
  CHECK(impacts == 3141);
  CHECK(motion.error(answer) < 1e-10);
}
