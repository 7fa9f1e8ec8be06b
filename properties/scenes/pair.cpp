#include "properties/scenes/pair.h"

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

namespace touchstone::properties {
namespace {

const IntMat3 upside_down = Eigen::Vector3i(1, 1, -1).asDiagonal();

Polytope unsheared_summit(Random& random, Kind kind) {
  const double lo = -random.whole(1, 4);
  if (kind == Kind::vertex) return pyramid(some_polygon(random), lo, 0);
  if (kind == Kind::edge) {
    const auto outwards = [&random] { return random.whole(1, 4); };
    const Vec3 base_lo{-outwards(), -outwards(), lo};
    const Vec3 base_hi{outwards(), outwards(), lo};
    const double x0 = -outwards();
    return roof(x0, outwards(), 0, base_lo, base_hi);
  }
  const Polygon polygon = some_polygon(random);
  const int bottom = random.between(1, 3);
  return frustum(polygon, bottom, lo, random.between(1, 3), 0);
}

}  // namespace

Kind some_kind(Random& random) { return random.pick({Kind::vertex, Kind::edge, Kind::face}); }

Polytope summit(Random& random, Kind kind) {
  const Polytope solid = unsheared_summit(random, kind);
  return mapped(solid, some_shear(random));
}

Polytope depression(Random& random, Kind kind) { return mapped(summit(random, kind), upside_down); }

Body at_rest(Shape shape, const Pose& X_WB) {
  Body body;
  body.shape = std::move(shape);
  body.X_WB = X_WB;
  return body;
}

Scene pair(Random& random, Body A, Body B) {
  if (random.one_in(2)) std::swap(A, B);
  Scene scene;
  scene.bodies.push_back(std::move(A));
  scene.bodies.push_back(std::move(B));
  return scene;
}

Quaternion times(const Quaternion& q, const Quaternion& r) {
  return {q.w * r.w - q.x * r.x - q.y * r.y - q.z * r.z, q.w * r.x + q.x * r.w + q.y * r.z - q.z * r.y,
          q.w * r.y - q.x * r.z + q.y * r.w + q.z * r.x, q.w * r.z + q.x * r.y - q.y * r.x + q.z * r.w};
}

Quaternion small_quaternion(Random& random) {
  Quaternion q{0, 0, 0, 0};
  while (q == Quaternion{0, 0, 0, 0}) {
    q = {random.whole(-3, 3), random.whole(-3, 3), random.whole(-3, 3), random.whole(-3, 3)};
  }
  return q;
}

Quaternion axes_quaternion(Random& random) {
  const auto s = [&random] { return static_cast<double>(random.sign()); };
  const double a = s(), b = s(), c = s();
  switch (random.below(4)) {
    case 0:  // by 0° or 180° about an axis
      return random.pick<Quaternion>({{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}});
    case 1:  // by 90° about an axis
      return random.pick<Quaternion>({{1, a, 0, 0}, {1, 0, a, 0}, {1, 0, 0, a}});
    case 2:  // by 180° about the diagonal of a face
      return random.pick<Quaternion>({{0, 1, a, 0}, {0, 1, 0, a}, {0, 0, 1, a}});
    default:  // by 120° about a diagonal of the cube
      return {1, a, b, c};
  }
}

Quaternion twist(Random& random) { return {random.whole(1, 4), 0, 0, random.whole(-4, 4)}; }

Vec3 turned_by_axes(const Quaternion& q, const Vec3& p) {
  const double norm = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
  const auto entry = [norm](double m) { return m / norm; };
  Mat3 R;
  R << entry(q.w * q.w + q.x * q.x - q.y * q.y - q.z * q.z), entry(2 * (q.x * q.y - q.w * q.z)),
      entry(2 * (q.x * q.z + q.w * q.y)), entry(2 * (q.x * q.y + q.w * q.z)),
      entry(q.w * q.w - q.x * q.x + q.y * q.y - q.z * q.z), entry(2 * (q.y * q.z - q.w * q.x)),
      entry(2 * (q.x * q.z - q.w * q.y)), entry(2 * (q.y * q.z + q.w * q.x)),
      entry(q.w * q.w - q.x * q.x - q.y * q.y + q.z * q.z);
  return R * p;
}

Vec3 turned_by(const Quaternion& q, const Vec3& p) {
  const Vec3 v{q.x, q.y, q.z};
  const double norm = q.w * q.w + v.squaredNorm();
  const Vec3 times_norm = (q.w * q.w - v.squaredNorm()) * p + 2 * v.dot(p) * v + 2 * q.w * v.cross(p);
  return times_norm / norm;
}

Scene across(Random& random, Polytope below, Polytope above, double gap, const Pose& X, const Quaternion& twist_below,
             const Quaternion& twist_above) {
  above = shifted(std::move(above), {0, 0, gap});
  return pair(random, at_rest(std::move(below), {X.p_WB, times(X.q_WB, twist_below)}),
              at_rest(std::move(above), {X.p_WB, times(X.q_WB, twist_above)}));
}

Scene across_by_pose(Random& random, Polytope below, Polytope above, double gap, const Quaternion& q) {
  return pair(random, at_rest(std::move(below), {Vec3::Zero(), q}),
              at_rest(std::move(above), {turned_by_axes(q, {0, 0, gap}), q}));
}

Scene contact(Random& random, double gap, const Pose& X) {
  Polytope below = summit(random, some_kind(random));
  Polytope above = depression(random, some_kind(random));
  const Quaternion twist_below = random.one_in(2) ? Quaternion{} : twist(random);
  const Quaternion twist_above = random.one_in(2) ? Quaternion{} : twist(random);
  return across(random, std::move(below), std::move(above), gap, X, twist_below, twist_above);
}

double dyadic(Random& random, int lo, int hi, int least, int greatest) {
  const int whole = random.between(lo, hi);
  return std::ldexp(whole, random.between(least, greatest));
}

Vec3 small_vector(Random& random, int limit) {
  return {random.whole(-limit, limit), random.whole(-limit, limit), random.whole(-limit, limit)};
}

Vec3 any_vector(Random& random, double limit) {
  return {limit * (2 * random.unit() - 1), limit * (2 * random.unit() - 1), limit * (2 * random.unit() - 1)};
}

double dyadic_gap(Random& random, int least, int greatest) {
  if (random.one_in(4)) return 0;
  const int sign = random.sign();
  return std::ldexp(sign, -random.between(least, greatest));
}

}  // namespace touchstone::properties
