// Pairs with a raster, placed so that pixels are hard to decide: centres on edges, borders on grid lines, ends of
// words.
//
// Coordinates are small multiples of half a pixel, or of much less: the query is exact, and most answers depend on a
// sign.
#include <cmath>

#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"

namespace touchstone::properties {
namespace {

/// A raster of pixels of size 1 around the origin, with its corner at multiples of 1/2.
Raster small_raster(Random& random) {
  Raster raster;
  raster.columns = random.between(4, 16);
  raster.rows = random.between(4, 14);
  raster.x = 0.5 * (random.between(-3, 3) - raster.columns);
  raster.y = 0.5 * (random.between(-3, 3) - raster.rows);
  if (random.one_in(2)) {
    raster.shift_x = random.between(-3, 3);
    raster.shift_y = random.between(-3, 3);
  }
  return raster;
}

Scene under(const Raster& raster, Scene scene) {
  scene.raster = raster;
  return scene;
}

Vec3 halves(Random& random, int limit) {
  const Vec3 p = small_vector(random, 2 * limit);
  return 0.5 * p;
}

double half_extent(Random& random) {
  const int least = random.one_in(4) ? 8 : 1;
  return 0.5 * random.between(least, 2 * least + 6);
}

Box lattice_box(Random& random) {
  const double x = half_extent(random);
  const double y = half_extent(random);
  return {Vec3(x, y, half_extent(random))};
}

Body some_lattice_box(Random& random) {
  const Box box = lattice_box(random);
  return at_rest(box, {halves(random, 4), {}});
}

/// Every side through pixel centres or along grid lines, every corner on a centre or a lattice point.
Scene lattice_boxes(Random& random) {
  const Raster raster = small_raster(random);
  const Body A = some_lattice_box(random);
  const Body B = some_lattice_box(random);
  return under(raster, pair(random, A, B));
}

Body some_lattice_polytope(Random& random) {
  Polytope polytope = random.one_in(2) ? prism(some_polygon(random), -1, 1) : bipyramid(some_polygon(random), -2, 1);
  polytope = mapped(std::move(polytope), some_axes(random));
  return at_rest(std::move(polytope), {halves(random, 3), {}});
}

/// Oblique edges through pixel centres and lattice points.
Scene lattice_polytopes(Random& random) {
  const Raster raster = small_raster(random);
  const Body A = some_lattice_polytope(random);
  const Body B = some_lattice_polytope(random);
  return under(raster, pair(random, A, B));
}

Body some_ball(Random& random) {
  const double radius = 0.5 * random.pick({1.0, 2.0, 3.0, 5.0, 10.0, 13.0});
  return at_rest(Sphere{radius}, {halves(random, 4), {}});
}

/// Circles through lattice points: 3-4-5 and 5-12-13 in half pixels.
Scene lattice_balls(Random& random) {
  const Raster raster = small_raster(random);
  const Body A = some_ball(random);
  const Body B = random.one_in(2) ? some_ball(random) : some_lattice_box(random);
  return under(raster, pair(random, A, B));
}

/// Rotated bodies thinner than a pixel: most centres miss them.
Scene slivers(Random& random) {
  const Raster raster = small_raster(random);
  const auto sliver = [](Random& r) {
    const double thin = dyadic(r, 1, 3, -12, -3);
    const double length = half_extent(r);
    const Box box{Vec3(length, thin, half_extent(r))};
    const Vec3 p = halves(r, 3);
    return at_rest(box, {p, small_quaternion(r)});
  };
  const Body A = sliver(random);
  const Body B = random.one_in(2) ? sliver(random) : some_lattice_box(random);
  return under(raster, pair(random, A, B));
}

/// Any rotation and any position: no ties.
Scene turned_pairs(Random& random) {
  Raster raster = small_raster(random);
  raster.pixel = dyadic(random, 1, 3, -3, 0);
  raster.x *= raster.pixel;
  raster.y *= raster.pixel;
  Scene scene = some_pair(random);
  const Vec3 middle = scene.bodies[0].X_WB.p_WB;
  raster.x += std::round(8 * middle.x()) / 8;
  raster.y += std::round(8 * middle.y()) / 8;
  return under(raster, std::move(scene));
}

/// Bodies that extend beyond the raster, or lie beside it.
Scene off_the_raster(Random& random) {
  Raster raster = small_raster(random);
  raster.columns = random.between(1, 5);
  raster.rows = random.between(1, 5);
  raster.x += random.whole(-9, 9);
  const Body A = some_lattice_polytope(random);
  const Body B = random.one_in(2) ? some_ball(random) : some_lattice_box(random);
  return under(raster, pair(random, A, B));
}

/// Bodies smaller than a pixel, on a centre, on a grid line or on neither.
Scene below_a_pixel(Random& random) {
  Raster raster = small_raster(random);
  if (random.one_in(3)) raster.columns = raster.rows = 1;
  const auto speck = [](Random& r) {
    const double size = dyadic(r, 1, 1, -9, -2);
    const Shape shape = r.one_in(2) ? Shape(Sphere{size}) : Shape(Box{Vec3::Constant(size)});
    const Vec3 lattice_point = halves(r, 2);
    const Vec3 p = lattice_point + small_vector(r, 1) * size;
    return at_rest(shape, {p, {}});
  };
  const Body A = speck(random);
  const Body B = speck(random);
  return under(raster, pair(random, A, B));
}

/// Rows of one word more or less, shifted by about a whole number of words.
Scene word_borders(Random& random) {
  Raster raster;
  raster.columns = random.pick({63, 64, 65, 66, 127, 128, 129, 130});
  raster.rows = random.between(2, 5);
  raster.shift_x = random.pick({0, 1, -1, 2, 63, -63, 64, -64, 65, -65});
  raster.shift_y = random.between(-1, 1);
  const auto bar = [](Random& r) {
    const double half = 0.5 * r.between(20, 120);
    const Box box{Vec3(half, half_extent(r), 1)};
    const double x = 0.5 * r.between(0, 150);
    const double y = 0.5 * r.between(0, 6);
    return at_rest(box, {Vec3(x, y, 0.5 * r.between(-1, 1)), {}});
  };
  const Body A = bar(random);
  const Body B = bar(random);
  return under(raster, pair(random, A, B));
}

/// More than 2,048 columns, or just not. One body covers all pixels, up to the raster's border or beyond; the other one
/// does too, or is a bar or a ball in front of it, touching it or behind.
Scene wide(Random& random) {
  Raster raster;
  raster.columns = random.pick({2047, 2048, 2049, 2112, 2113, 2500, 4097});
  raster.rows = random.between(1, 2);
  raster.shift_x = random.pick({0, 0, 1, -1, 64, -65, 2047, -2048, 2049});
  const Vec3 middle{0.5 * raster.columns, 0.5 * raster.rows, 0};
  const auto cover = [&](Random& r) {
    const double beyond = r.pick({0.0, 0.0, 0.5, 8.0});
    return at_rest(Box{middle + Vec3(beyond, beyond, 1)}, {middle, {}});
  };
  const Body A = cover(random);
  Body B = random.one_in(3) ? cover(random) : random.one_in(2) ? some_ball(random) : some_lattice_box(random);
  const Vec3 along{0.5 * random.between(0, 2 * raster.columns), 0, 0.5 * random.between(-6, 6)};
  B.X_WB.p_WB += random.one_in(2) ? along : Vec3(0, 0, along.z());
  return under(raster, pair(random, A, B));
}

/// Another family's scene, so far away that doubles have few bits left for fractions of a pixel.
Scene far_away(Random& random) {
  Scene scene = random.one_in(2) ? lattice_boxes(random) : lattice_polytopes(random);
  const double x = random.sign() * std::ldexp(1.0, random.between(30, 50));
  const double y = random.sign() * std::ldexp(1.0, random.between(30, 50));
  for (Body& body : scene.bodies) body.X_WB.p_WB += Vec3(x, y, 0);
  scene.raster->x += x;
  scene.raster->y += y;
  return scene;
}

/// Pixels near and below the rounding of the bodies' coordinates, around a corner: doubles can decide little.
Scene tiny_pixels(Random& random) {
  Raster raster = small_raster(random);
  raster.pixel = std::ldexp(1.0, random.between(-58, -44));
  const Body A = at_rest(Box{Vec3::Constant(3)}, {Vec3(-3, -3, 0), {}});  // its corner is at 0
  const Body B =
      at_rest(tetrahedron({0, 0, 0}, {-2, 5, 1}, {4, 1, -1}, {1, 1, 4}), {Vec3::Zero(), small_quaternion(random)});
  raster.x *= raster.pixel;
  raster.y *= raster.pixel;
  return under(raster, pair(random, A, B));
}

/// Shifts beyond the raster, up to the largest that files may contain.
Scene big_shifts(Random& random) {
  Scene scene = lattice_boxes(random);
  constexpr int most = 1'000'000'000;  // limit of every integer in a file
  scene.raster->shift_x =
      random.pick({0, -most, 1 - most, most, most - 1, scene.raster->columns, -scene.raster->columns});
  scene.raster->shift_y = random.pick({0, 0, 0, -most, most, scene.raster->rows, -scene.raster->rows});
  return scene;
}

/// One above the other, touching, 2^-k apart, or overlapping: the depth decides.
Scene stacked(Random& random) {
  const Raster raster = small_raster(random);
  const Polytope below = prism(some_polygon(random), -2, 0);
  const Polytope above = prism(some_polygon(random), 0, 1);
  return under(raster, across_by_pose(random, below, above, dyadic_gap(random, 1, 40), {}));
}

/// Steep plates side by side: above one square each covers all depths, but the two need not overlap.
Scene steep_plates(Random& random) {
  const Raster raster = small_raster(random);
  const Box plate{Vec3(4, 0.0625 * random.between(1, 4), 4)};
  const double apart = 0.125 * random.between(1, 12);
  const Quaternion q{8, random.whole(-1, 1), 0, random.whole(-2, 2)};
  const Body A = at_rest(plate, {Vec3::Zero(), q});
  return under(raster, pair(random, A, at_rest(plate, {Vec3(0, apart, 0), q})));
}

/// A vertical line at a lattice point `apart` from a ball's axis enters and leaves the ball at ±`height`: exact.
struct Chord {
  Vec3 apart;
  double radius, height;
};

Chord some_chord(Random& random) {
  const Chord chord = random.pick<Chord>({{{0, 0, 0}, 5, 5},
                                          {{3, 0, 0}, 5, 4},
                                          {{4, 0, 0}, 5, 3},
                                          {{3, 4, 0}, 13, 12},
                                          {{5, 0, 0}, 13, 12},
                                          {{8, 0, 0}, 17, 15},
                                          {{1, 2, 0}, 3, 2},
                                          {{2, 0, 0}, 2, 0},
                                          {{6, 8, 0}, 26, 24}});
  const double x = random.sign(), y = random.sign();
  const Vec3 mirrored{x * chord.apart.x(), y * chord.apart.y(), 0};
  return {random.one_in(2) ? mirrored : Vec3(mirrored.y(), mirrored.x(), 0), chord.radius, chord.height};
}

/// Above one pixel's centre the chords of two balls touch exactly, or overlap or miss by next to nothing.
Scene balls_meet(Random& random) {
  const Raster raster = small_raster(random);
  const Chord a = some_chord(random), b = some_chord(random);
  const Vec3 centre{raster.x + random.between(0, raster.columns - 1) + 0.5,
                    raster.y + random.between(0, raster.rows - 1) + 0.5, 0};
  const double end_of_a = random.sign() * a.height, end_of_b = random.sign() * b.height;
  const Vec3 up{0, 0, end_of_a - end_of_b + (random.one_in(2) ? 0 : dyadic_gap(random, 1, 40))};
  return under(raster, pair(random, at_rest(Sphere{a.radius}, {centre + a.apart, {}}),
                            at_rest(Sphere{b.radius}, {centre + b.apart + up, {}})));
}

/// Two convex parts each: masks with notches, several depth intervals.
Scene compounds(Random& random) {
  const Raster raster = small_raster(random);
  const auto bracket = [](Random& r) {
    const Vec3 p = halves(r, 3);
    const Vec3 second = halves(r, 2);
    const double radius = 0.5 * r.between(1, 4);
    const ConvexShape shape = r.one_in(2) ? ConvexShape(Sphere{radius}) : ConvexShape(lattice_box(r));
    const Box first = lattice_box(r);
    const Quaternion turned = r.one_in(2) ? axes_quaternion(r) : Quaternion{};
    return at_rest(Compound{{{Pose{}, first}, {Pose{second, turned}, shape}}}, {p, axes_quaternion(r)});
  };
  const Body A = bracket(random);
  const Body B = random.one_in(2) ? bracket(random) : some_ball(random);
  return under(raster, pair(random, A, B));
}

}  // namespace

std::vector<Family> pixel_families() {
  const std::vector<std::string> queries = {"pixel"};
  return {
      {"pixels.lattice_boxes", "boxes with every side through centres or along lines", queries, true, lattice_boxes},
      {"pixels.lattice_polytopes", "polytopes with corners on centres and lattice points", queries, true,
       lattice_polytopes},
      {"pixels.lattice_balls", "balls whose circles pass through lattice points", queries, true, lattice_balls},
      {"pixels.slivers", "turned bodies thinner than a pixel", queries, true, slivers},
      {"pixels.turned", "pairs of other families under a raster", queries, false, turned_pairs},
      {"pixels.off_the_raster", "bodies that stick out of a small raster, or are beside it", queries, true,
       off_the_raster},
      {"pixels.below_a_pixel", "bodies smaller than a pixel, on centres and lines", queries, true, below_a_pixel},
      {"pixels.word_borders", "63 to 130 columns, shifted by about 64", queries, true, word_borders},
      {"pixels.wide", "1 or 2 rows of 2047 to 4097 columns, all covered", queries, true, wide},
      {"pixels.far_away", "lattice scenes 2^30 to 2^50 from the origin", queries, false, far_away},
      {"pixels.tiny", "pixels of 2^-58 to 2^-44 at a corner of bodies of size 1", queries, true, tiny_pixels},
      {"pixels.big_shifts", "shifts beyond the raster, to ±10^9", queries, true, big_shifts},
      {"pixels.stacked", "prisms one above the other, a gap of ±2^-1 to ±2^-40 or 0 between", queries, false, stacked},
      {"pixels.steep_plates", "plates that stand side by side, steep against the view", queries, true, steep_plates},
      {"pixels.balls_meet", "balls that touch exactly above a pixel's centre, or nearly", queries, false, balls_meet},
      {"pixels.compounds", "two convex parts each, some turned", queries, true, compounds},
  };
}

}  // namespace touchstone::properties
