#include "properties/scenes/extreme.h"

#include <cmath>
#include <limits>
#include <utility>

#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"
#include "properties/transforms/scene.h"

namespace touchstone::properties {
namespace {

constexpr double least = std::numeric_limits<double>::denorm_min();
constexpr double greatest = std::numeric_limits<double>::max();

Scene times_2_500(Random& random) {
  const Scene scene = some_pair(random);
  return *scaled(scene, random.sign() * 500);
}

/// Every length is a few times the least double.
Scene denormal(Random& random) {
  const auto length = [&random] { return least * random.whole(1, 9); };
  const Vec3 half{length(), length(), length()};
  const Vec3 p{length(), -length(), length()};
  const Vec3 other_half{length(), length(), length()};
  Body other = at_rest(Box{other_half}, {p, small_quaternion(random)});
  if (random.one_in(2)) other.shape = Sphere{length()};
  return pair(random, at_rest(Box{half}), std::move(other));
}

/// Extents and positions near the greatest double, so that even sums overflow.
Scene huge(Random& random) {
  const auto length = [&random] {
    const double mantissa = random.unit() + 0.25;
    return std::ldexp(mantissa, random.between(1000, 1022));
  };
  const Vec3 half{length(), length(), length()};
  const Vec3 p{length(), -length(), 0};
  const Vec3 other_half{length(), length(), length()};
  Body other = at_rest(Box{other_half}, {p, small_quaternion(random)});
  if (random.one_in(2)) other.shape = Sphere{random.one_in(4) ? greatest : length()};
  return pair(random, at_rest(Box{half}, {-p, {}}), std::move(other));
}

/// A tiny body beside a huge one: 2^±500 in one scene.
Scene speck_and_giant(Random& random) {
  const double giant = dyadic(random, 1, 7, 400, 500);
  const double speck = dyadic(random, 1, 7, -500, -400);
  const Vec3 p{giant, speck * random.whole(-2, 2), 0};
  return pair(random, at_rest(Box{Vec3::Constant(giant)}),
              at_rest(Box{Vec3::Constant(speck)}, {p, small_quaternion(random)}));
}

Scene quaternions(Random& random) {
  Scene scene = some_pair(random);
  const double s = random.pick({least, 0x1p-1022, 0x1p-600, 0x1p600, 0x1p1000});
  for (Body& body : scene.bodies) {
    Quaternion q = small_quaternion(random);
    body.X_WB.q_WB = {s * q.w, s * q.x, s * q.y, s * q.z};
  }
  return scene;
}

Scene one_tiny_component(Random& random) {
  Scene scene = some_pair(random);
  for (Body& body : scene.bodies)
    body.X_WB.q_WB = {1, random.pick({0.0, least, 0x1p-600}), 0x1p-300, random.pick({-0.0, -least})};
  return scene;
}

/// Barely any volume: a tetrahedron as thin as the spacing of doubles, in any direction.
Scene hair_thin(Random& random) {
  const double thin = random.pick({0x1p-52, 0x1p-200, 0x1p-1022, least});
  const auto flake = [&random, thin] {
    const Vec3 b{random.whole(1, 9), 0, 0};
    const Vec3 c{random.whole(-9, 9), random.whole(1, 9), 0};
    const Vec3 d{random.whole(-9, 9), 1, thin};
    return mapped(tetrahedron(Vec3::Zero(), b, c, d), some_axes(random));
  };
  Polytope A = flake();
  const Pose X{small_vector(random, 2), small_quaternion(random)};
  return pair(random, at_rest(std::move(A)), at_rest(flake(), X));
}

/// Vertices one ulp apart: an edge that disappears in any rounding.
Scene nearly_equal_vertices(Random& random) {
  const double a = random.whole(1, 8);
  const double b = std::nextafter(a, 9);
  Polytope wedge = roof(-a, a, b, Vec3{-b, -a, a}, Vec3{b, a, a});
  wedge.vertices[4].x() = std::nextafter(0.0, -1);
  wedge.vertices[5].x() = std::nextafter(0.0, 1);
  const Pose X{small_vector(random, 9), small_quaternion(random)};
  return pair(random, at_rest(wedge), at_rest(wedge, X));
}

Scene very_far(Random& random) {
  const double far = random.pick({0x1p54, 0x1p100, 0x1p500, 0x1p1000});
  const Quaternion q = small_quaternion(random);
  const Pose X{far * small_vector(random, 3), q};
  return contact(random, dyadic_gap(random, 0, 30), X);
}

Scene negative_zeros(Random& random) {
  Scene scene = some_pair(random);
  for (Body& body : scene.bodies) {
    for (int i = 0; i < 3; ++i) {
      if (body.X_WB.p_WB[i] == 0) body.X_WB.p_WB[i] = -0.0;
    }
    Quaternion& q = body.X_WB.q_WB;
    if (q == Quaternion{}) q = {-1, -0.0, 0, -0.0};
  }
  return scene;
}

/// Nearly a ball: many faces, each almost coplanar with its neighbours.
Scene many_corners(Random& random) {
  const Polytope solid = bipyramid(lattice_circle(random.pick({5525, 27625, 71825})), -1, 1);
  const Pose X{Vec3{random.whole(-1, 1), 0, random.whole(0, 2)}, small_quaternion(random)};
  return pair(random, at_rest(solid), at_rest(solid, X));
}

Scene crowded_place(Random& random) {
  const double half = random.pick({least, 1.0, 0x1p1000});
  const Vec3 place = random.pick({0.0, 0x1p900}) * Vec3::Ones();
  const Body body = at_rest(Box{Vec3::Constant(half)}, {place, {}});
  Scene scene;
  scene.bodies.assign(static_cast<std::size_t>(random.between(2, 60)), body);
  return scene;
}

/// Bodies that go from one end of the doubles to the other, next to bodies that are there already.
Scene far_sequence(Random& random) {
  Scene sequence;
  const double half = random.pick({least, 0x1p-900, 1.0, 0x1p900});
  sequence.bodies.assign(static_cast<std::size_t>(random.between(2, 8)), at_rest(Box{Vec3::Constant(half)}));
  for (int f = random.between(2, 8); f > 0; --f) {
    SequenceFrame& frame = sequence.frames.emplace_back();
    for (std::size_t i = 0; i < sequence.bodies.size(); ++i) {
      const double far = random.pick({0.0, least, 0x1p-900, 1.0, 1e300, 0x1p1020});
      const Pose X_WB{far * small_vector(random, 1), {}};
      if (!random.one_in(4)) frame.push_back({static_cast<int>(i), X_WB});
    }
  }
  return sequence;
}

/// Sizes and speeds from 2^-20 to 2^20, needles of 2^20:1, spins up to 2^14 rad/s; the motion lasts a few rotations at
/// most.
Body wild(Random& random, double size) {
  const Vec3 needle{size, std::ldexp(size, -random.between(0, 20)), std::ldexp(size, -random.between(0, 20))};
  Body body = at_rest(random.one_in(3) ? Shape(Sphere{size}) : Shape(Box{needle}));
  body.X_WB.q_WB = small_quaternion(random);
  body.material = {random.pick({0.0, 0.5, 1.0}), random.pick({0.0, 1.0, 10.0})};
  if (random.one_in(8)) body.mass = Fixed{};
  return body;
}

/// Several such bodies in a row; the first moves towards the others.
Scene wild_run(Random& random, int count) {
  Scene scene;
  const double spin = std::ldexp(1, random.between(-4, 14)), end = std::ldexp(1, random.between(1, 3)) / spin;
  double reach = 0;
  for (int n = 0; n < count; ++n) {
    const double size = dyadic(random, 1, 7, -20, 20);
    Body body = wild(random, size);
    reach += 2 * size;  // no point is farther than √3 · size from the centre
    body.X_WB.p_WB = {reach, 0, 0};
    body.velocity.w_WB = spin / 4 * small_vector(random, 2);
    scene.bodies.push_back(std::move(body));
    reach += 2 * size;
  }
  scene.bodies.front().velocity.v_WBcm = {reach / end, 0, 0};
  if (random.one_in(2)) scene.gravity = {0, 0, -reach / (end * end)};
  scene.motion.emplace();
  scene.motion->sample_times = {end / 2, end};
  return scene;
}

Scene wild_motion(Random& random) { return wild_run(random, 2); }
Scene wild_crowd(Random& random) { return wild_run(random, random.between(2, 4)); }

}  // namespace

const std::vector<Family>& extremes() {
  static const std::vector<Family> all = {
      {"extreme.times_2_500", "a small pair times 2^500 or 2^-500", convex_pair_queries, false, times_2_500},
      {"extreme.denormal", "every length a few times the least double", convex_pair_queries, false, denormal},
      {"extreme.huge", "lengths near the greatest double", convex_pair_queries, false, huge},
      {"extreme.speck_and_giant", "2^-500 beside 2^500", convex_pair_queries, false, speck_and_giant},
      {"extreme.quaternions", "quaternions from the least double to 2^1000 long", convex_pair_queries, false,
       quaternions},
      {"extreme.tiny_component", "quaternions with denormal components", convex_pair_queries, false,
       one_tiny_component},
      {"extreme.hair_thin", "tetrahedra 2^-52 to 2^-1074 thin", convex_pair_queries, false, hair_thin},
      {"extreme.nearly_equal_vertices", "vertices a few ulps apart", convex_pair_queries, false, nearly_equal_vertices},
      {"extreme.very_far", "2^54 to 2^1000 from the origin", convex_pair_queries, false, very_far},
      {"extreme.negative_zeros", "-0 wherever 0 could be, q = -1", convex_pair_queries, false, negative_zeros},
      {"extreme.many_corners", "bipyramids over 72 to 144 cocircular corners", convex_pair_queries, true, many_corners},
      {"extreme.crowded_place",
       "2 to 60 bodies in one place, of no, one or all size",
       {"bounds", "broad_phase"},
       false,
       crowded_place},
      {"extreme.far_film",
       "bodies at 0, the least double, 1e300 and beyond, in another place each frame",
       {"broad_phase"},
       false,
       far_sequence},
      {"extreme.wild_flight",
       "sizes from 2^-20 to 2^20, needles, spins to 2^14 rad/s",
       {"time_of_impact"},
       false,
       wild_motion},
      {"extreme.wild_run", "up to four such bodies, one at the others", {"simulation"}, false, wild_crowd},
  };
  return all;
}

}  // namespace touchstone::properties
