// Solutions of linear systems in twists, put back into the equations.
#include "fast/contact/sparse/twist_system.h"

#include <random>

#include "tests/catch.h"

namespace touchstone::fast::contact {
namespace {

struct Random {
  std::mt19937 numbers{1};

  double number() { return static_cast<double>(numbers()) / 0x1p31 - 1; }
  Vec3 vector() {
    const double x = number(), y = number();
    return {x, y, number()};
  }
  Mat3 matrix() {
    Mat3 all;
    for (int i = 0; i < 3; ++i) all.col(i) = vector();
    return all;
  }
};

/// H x from its definition.
TwistSystem::Vector product(const TwistSystem& system, double mass_share, const std::vector<Mat3>& stiffness,
                            const TwistSystem::Vector& x) {
  TwistSystem::Vector all = mass_share * system.momentum(x);
  for (std::size_t i = 0; i < stiffness.size(); ++i)
    system.add_impulse(i, stiffness[i] * system.relative_velocity(i, x), all);
  return all;
}

TEST_CASE("twist system: solves its equations, for any graph, with stiffnesses that are not symmetric") {
  Random random;
  for (int round = 0; round < 20; ++round) {
    const int count = 2 + round;
    std::vector<Mobility> bodies;
    for (int i = 0; i < count; ++i) {
      const Mat3 root = Mat3::Identity() + 0.25 * random.matrix();
      bodies.push_back({1.5 + random.number(), root * root.transpose()});
    }
    bodies.emplace_back();  // the floor
    std::vector<ContactRow> rows;
    std::vector<Mat3> stiffness;
    for (int k = 0; k < 3 * count; ++k) {
      ContactRow row;
      row.a = static_cast<int>(random.numbers() % static_cast<unsigned>(count));
      row.b = static_cast<int>(random.numbers() % static_cast<unsigned>(count + 1));
      if (row.a == row.b) continue;
      row.arm_A = random.vector();
      row.arm_B = random.vector();
      rows.push_back(row);
      const Mat3 root = random.matrix();
      stiffness.push_back(100 * (root * root.transpose()) + random.matrix());
    }
    TwistSystem system(rows, bodies);
    TwistSystem::Vector b = system.zero();
    REQUIRE(b.size() == 6 * count);
    for (Eigen::Index i = 0; i < b.size(); ++i) b[i] = random.number();
    system.factor(0.5, stiffness);
    const TwistSystem::Vector x = system.solve(b);
    // The condition of H is at most about 10⁵, so x is right to 10⁻¹¹ and its residual is far smaller.
    CHECK((product(system, 0.5, stiffness, x) - b).norm() < 1e-11 * b.norm());
    CHECK((system.response(system.momentum(x)) - x).norm() < 1e-11 * x.norm());
  }
}

TEST_CASE("twist system: twists of bodies that move go in and out, others stay") {
  const std::vector<Mobility> bodies = {{}, {0.5, 2 * Mat3::Identity()}};
  ContactRow row;
  row.a = 1;
  row.arm_A = Vec3(0, 0, -3);
  const std::vector<ContactRow> rows = {row};
  std::vector<Twist> twists = {{Vec3(7, 0, 0), Vec3::Zero()}, {Vec3(1, 2, 3), Vec3(0, 1, 0)}};
  const TwistSystem system(rows, bodies);
  const TwistSystem::Vector moving = system.moving(twists);
  CHECK(system.relative_velocity(0, moving) == Vec3(-2, 2, 3));  // the other body counts as at rest
  CHECK(system.greatest_speed(moving) == Approx(std::sqrt(14) + 3));
  CHECK(system.momentum(moving).head<3>() == Vec3(2, 4, 6));
  TwistSystem::Vector wrench = system.zero();
  system.add_impulse(0, Vec3(1, 0, 0), wrench);
  CHECK(wrench.tail<3>() == Vec3(0, -3, 0));
  system.store(2 * moving, twists);
  CHECK(twists[0].v == Vec3(7, 0, 0));
  CHECK(twists[1].v == Vec3(2, 4, 6));
}

}  // namespace
}  // namespace touchstone::fast::contact
