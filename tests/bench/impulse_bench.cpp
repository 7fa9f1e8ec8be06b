// Compares methods that compute an impact's impulse: CSV of nanoseconds per impulse, and the errors.
//
// Workloads are classes of impacts of a body on the fixed ground. Errors: |P − P*|_K / |u|_{K⁻¹} in units of 2^-53,
// with P* from the reference (at least 45 digits) for the same scene; all methods get K and u as the nearest doubles.
// Methods run in turn, one round each; the result is the median of the rounds' CPU time. A method that returns no
// number is left out.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "properties/random.h"
#include "reference/impulse.h"
#include "reference/validity.h"
#include "tests/bench/command_line.h"
#include "tests/bench/cpu_time.h"
#include "tests/bench/impulse/integrator.h"
#include "tests/bench/work_precision.h"

namespace touchstone::bench {
namespace {

using fast::impulse::Impact;
using fast::impulse::Outcome;

struct Asked {
  Impact impact;
  Vec3 P = Vec3::Zero();  ///< exact, then rounded
  Mat3 K = Mat3::Zero();  ///< in the impact's axes
  double scale = 0;       ///< |u|_{K⁻¹}
};

const std::vector<std::string> classes{"generic", "tiny_slip", "friction_to_10", "rods",
                                       "levers",  "spheres",   "no_slip"};

double between(properties::Random& random, double lo, double hi) { return lo + (hi - lo) * random.unit(); }
Vec3 vector(properties::Random& random) {
  return {between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)};
}

/// A body that hits the ground at the origin, with the normal along z.
Scene scene_of(const std::string& name, properties::Random& random) {
  Scene scene;
  Body body;
  Vec3 half(1, between(random, 0.5, 2), between(random, 0.5, 2));
  if (name == "rods") half = Vec3(1, 0.01, 0.01);
  body.shape = Box{half};
  if (name == "spheres") body.shape = Sphere{1};
  body.X_WB.q_WB = {between(random, -1, 1), between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)};
  body.X_WB.p_WB = name == "spheres" ? Vec3(0, 0, 1) : vector(random);
  if (name == "levers") body.X_WB.p_WB *= std::exp2(between(random, 4, 14));
  const Vec3 slip = vector(random) * (name == "tiny_slip" ? std::exp2(between(random, -40, -8)) : 1.0);
  const Vec3 u = name == "no_slip" ? Vec3(0, 0, -1) : Vec3(slip.x(), slip.y(), -between(random, 0.1, 1));
  body.velocity.w_WB = name == "no_slip" ? Vec3::Zero() : vector(random);
  body.velocity.v_WBcm = u + body.velocity.w_WB.cross(body.X_WB.p_WB);  // u − w × r, r = −p
  Body ground;
  ground.shape = Box{Vec3(1, 1, 1)};
  ground.mass = Fixed{};
  scene.bodies = {body, ground};
  Contact contact;
  contact.restitution = between(random, 0, 1);
  contact.friction = name == "friction_to_10" ? between(random, 1, 10) : between(random, 0, 1);
  scene.contact = contact;
  return scene;
}

double nearest(const reference::Rational& x) { return x.nearest(); }

/// None if the bodies separate, or if the law's answer is discontinuous near the scene.
std::optional<Asked> asked_of(const Scene& scene) {
  const reference::ImpulseTruth truth = reference::impulse(reference::completed(scene));
  if (truth.modes.separating || truth.ambiguous) return std::nullopt;
  Mat3 K;
  Vec3 u, P;
  for (int a = 0; a < 3; ++a) {
    const auto row = static_cast<std::size_t>(a);
    for (int b = 0; b < 3; ++b) K(a, b) = nearest(truth.K_W[row][static_cast<std::size_t>(b)]);
    u[a] = nearest(truth.u0_W[row]);
    P[a] = nearest(truth.P_A_W[row]);
  }
  // Tangential axes in which the tangential block of K is diagonal.
  Mat3 R = Mat3::Identity();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(K.topLeftCorner<2, 2>());
  if (K(0, 1) != 0) R.topLeftCorner<2, 2>() = eigen.eigenvectors();
  Asked asked;
  asked.K = R.transpose() * K * R;
  asked.P = R.transpose() * P;
  const Vec3 v = R.transpose() * u;
  asked.scale = std::sqrt(v.dot(asked.K.inverse() * v));
  const Contact& contact = *scene.contact;
  asked.impact = {asked.K(0, 0), asked.K(1, 1), asked.K(0, 2), asked.K(1, 2),       asked.K(2, 2),   v.x(),
                  v.y(),         v.z(),         contact.law,   contact.restitution, contact.friction};
  return asked;
}

std::vector<Asked> questions(const std::string& name, int count) {
  properties::Random random(1, name, 0);
  std::vector<Asked> all;
  while (all.size() < static_cast<std::size_t>(count)) {
    if (const auto asked = asked_of(scene_of(name, random))) all.push_back(*asked);
  }
  return all;
}

double error_of(const Outcome& out, const Asked& asked) {
  const Vec3 off = Vec3(out.P1, out.P2, out.p) - asked.P;
  return std::sqrt(std::max(off.dot(asked.K * off), 0.0)) / asked.scale / 0x1p-53;
}

void compare(const std::string& name, int count, int rounds) {
  const std::vector<Asked> all = questions(name, count);
  const std::vector<Integrator> methods = integrators();
  std::vector<std::vector<double>> ns(methods.size());
  double unused = 0;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const double before = cpu_seconds();
      for (const Asked& asked : all) unused += methods[m].solve(asked.impact, methods[m].parameter).p;
      ns[m].push_back(1e9 * (cpu_seconds() - before) / static_cast<double>(all.size()));
    }
  }
  for (std::size_t m = 0; m < methods.size(); ++m) {
    std::vector<double> errors;
    for (const Asked& asked : all)
      errors.push_back(error_of(methods[m].solve(asked.impact, methods[m].parameter), asked));
    const auto lost = std::ranges::count_if(errors, [](double error) { return std::isnan(error); });
    std::printf("%s,%s,%s,%s,", name.c_str(), methods[m].effort.c_str(), methods[m].name.c_str(),
                methods[m].name == "fast" ? "ours" : "peer");
    if (lost > 0) {
      std::printf(",,,no end within 200000 steps in %ld of %zu impacts\n", static_cast<long>(lost), all.size());
    } else {
      std::printf("%.1f,%.3g,%.3g,\n", median(ns[m]), median(errors), std::ranges::max(errors));
    }
  }
  std::fflush(stdout);
  if (unused == 1) std::puts("");  // the compiler must not see that the answers are unused
}

void run(const Options& options) { compare_each(options, compare); }

}  // namespace
}  // namespace touchstone::bench

int main(int argc, char** argv) {
  using namespace touchstone::bench;
  return run_comparison(argc, argv,
                        {"Ways to compute an impact's impulse, and the error that each buys.",
                         "impacts a class",
                         {{200}, classes, 5},
                         classes},
                        run);
}
