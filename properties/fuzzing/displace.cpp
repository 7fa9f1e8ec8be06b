#include "properties/fuzzing/displace.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "oracle/tolerance/tolerance.h"
#include "properties/fuzzing/usual.h"
#include "properties/scenes/pair.h"

namespace touchstone::properties::fuzzing {
namespace {

bool is_possible(const Pose& X_WB) {
  const auto& [w, x, y, z] = X_WB.q_WB;
  return is_usual(X_WB.p_WB.x()) && is_usual(X_WB.p_WB.y()) && is_usual(X_WB.p_WB.z()) && is_usual(w) && is_usual(x) &&
         is_usual(y) && is_usual(z) && (w != 0 || x != 0 || y != 0 || z != 0);
}

double by_an_ulp(double number, Random& random) {
  return std::nextafter(number, random.sign() * std::numeric_limits<double>::infinity());
}

double plain(double number, Random& random) {
  switch (random.below(3)) {
    case 0:
      return 0;
    case 1:
      return std::nearbyint(number);
    default:
      return static_cast<double>(static_cast<float>(number));
  }
}

void move(Body& body, const Body& other, Random& random) {
  const int axis = random.below(3);
  double& x = body.X_WB.p_WB[axis];
  switch (random.below(5)) {
    case 0:
      x = by_an_ulp(x, random);
      break;
    case 1:
      x = other.X_WB.p_WB[axis];
      break;
    case 2:
      x = plain(x, random);
      break;
    default:
      x += random.sign() * oracle::tolerance::radius(body) * std::exp2(-random.between(0, 53));
  }
}

void turn(Body& body, const Body& other, Random& random) {
  Quaternion& q = body.X_WB.q_WB;
  double* const components[] = {&q.w, &q.x, &q.y, &q.z};
  double& c = *components[random.below(4)];
  switch (random.below(5)) {
    case 0:
      c = by_an_ulp(c, random);
      break;
    case 1:
      c = plain(c, random);
      break;
    case 2:
      q = random.one_in(2) ? other.X_WB.q_WB : times(other.X_WB.q_WB, axes_quaternion(random));
      break;
    case 3:
      q = times(q, axes_quaternion(random));
      break;
    default:
      c += random.sign() * std::exp2(-random.between(1, 53)) *
           std::max({std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)});
  }
}

}  // namespace

void displace(Scene& scene, Random& random) {
  const auto some = [&] { return random.index(scene.bodies.size()); };
  if (random.one_in(16)) {
    const int axis = random.below(3);
    const double by = random.sign() * std::exp2(random.between(-8, 40));
    for (Body& body : scene.bodies) body.X_WB.p_WB[axis] += by;
    return;
  }
  Body& body = scene.bodies[some()];
  const Pose before = body.X_WB;
  const Body& other = scene.bodies[some()];
  if (random.one_in(3)) {
    turn(body, other, random);
  } else {
    move(body, other, random);
  }
  if (!is_possible(body.X_WB)) body.X_WB = before;
}

}  // namespace touchstone::properties::fuzzing
