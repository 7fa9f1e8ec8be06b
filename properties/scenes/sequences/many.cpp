// Sequences of dozens to hundreds of bodies, of which few change their cell in a frame: what a broad phase keeps from
// frame to frame is then mended, not built anew. And solids of many vertices that turn a little in each frame.
//
// fast keeps a grid from 17 bodies on, and climbs to extremal vertices from 24 on; the families of sequences.cpp have
// at most 10 bodies and no polytope.
#include <algorithm>
#include <cmath>
#include <functional>

#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"

namespace touchstone::properties {
namespace {

/// 18 to 60; with probability 1/32, up to 300.
int many(Random& random) { return random.one_in(32) ? random.between(61, 300) : random.between(18, 60); }

/// The greatest integer whose cube is not above n. The cube root of a C library may differ in its last bit.
int cube_root(int n) {
  int root = 0;
  while ((root + 1) * (root + 1) * (root + 1) <= n) ++root;
  return root;
}

/// Lattice coordinates at which about one in four cells is taken.
int lattice_limit(int bodies) { return cube_root(bodies / 2); }

using Step = std::function<Pose(Random&, const Pose&)>;

/// All bodies are inserted in the first frame. In each later frame `moving` of them move, chosen at random, and with
/// probability 1/4 one is removed, or inserted again where it was.
Scene few_move(Random& random, Scene scene, const std::vector<Pose>& first, int moving, int frames, const Step& step) {
  const int n = static_cast<int>(first.size());
  std::vector<Pose> now = first;
  std::vector<bool> there(first.size(), true);
  SequenceFrame all;
  for (int i = 0; i < n; ++i) all.push_back({i, first[static_cast<std::size_t>(i)]});
  scene.frames.push_back(std::move(all));
  for (int f = 1; f < frames; ++f) {
    std::vector<bool> named(first.size(), false);
    SequenceFrame frame;
    for (int k = 0; k < moving; ++k) {
      const int body = random.below(n);
      const auto i = static_cast<std::size_t>(body);
      const bool changes_presence = random.one_in(4 * moving);
      if (named[i]) continue;
      named[i] = true;
      if (there[i] && changes_presence) {
        there[i] = false;
        frame.push_back({body, {}});
      } else {
        if (there[i]) now[i] = step(random, now[i]);
        there[i] = true;
        frame.push_back({body, now[i]});
      }
    }
    scene.frames.push_back(std::move(frame));
  }
  return scene;
}

std::vector<Pose> on_lattice(Random& random, int n, double spacing) {
  const int limit = lattice_limit(n);
  std::vector<Pose> first;
  for (int i = 0; i < n; ++i) first.push_back({spacing * small_vector(random, limit), {}});
  return first;
}

/// A step along one axis or none of length `by`.
Pose along_an_axis(Random& random, const Pose& X_WB, double by) {
  Pose next = X_WB;
  const int axis = random.below(3);
  next.p_WB[axis] += by * random.whole(-1, 1);
  return next;
}

/// Unit cells of a lattice, which touch exactly; an eighth of them at most moves by half a cell, so that pairs begin
/// and end by touching.
Scene many_on_lattice(Random& random) {
  const int n = many(random);
  Scene scene;
  for (int i = 0; i < n; ++i) scene.bodies.push_back(at_rest(Box{Vec3::Constant(0.5)}));
  const std::vector<Pose> first = on_lattice(random, n, 1);
  const int moving = std::max(1, n / random.pick({8, 16, 32}));
  return few_move(random, std::move(scene), first, moving, random.between(8, 20),
                  [](Random& r, const Pose& X_WB) { return along_an_axis(r, X_WB, 0.5); });
}

/// Back to where it was two frames before: what a frame undoes is found again.
Scene back_and_forth(Random& random) {
  const int n = many(random);
  Scene scene;
  for (int i = 0; i < n; ++i) {
    const double half = random.pick({0.25, 0.5, 1.0});
    scene.bodies.push_back(random.one_in(4) ? at_rest(Sphere{half}) : at_rest(Box{Vec3::Constant(half)}));
  }
  const std::vector<Pose> first = on_lattice(random, n, 2);
  SequenceFrame all;
  for (int i = 0; i < n; ++i) all.push_back({i, first[static_cast<std::size_t>(i)]});
  scene.frames.push_back(std::move(all));
  const int swinging = std::max(1, n / 12), begin = random.below(n), axis = random.below(3);
  const double by = random.pick({0.25, 1.0, 2.0});
  for (int f = random.between(8, 20); f > 0; --f) {
    SequenceFrame frame;
    for (int k = 0; k < swinging; ++k) {
      const int body = (begin + k) % n;
      Pose X_WB = first[static_cast<std::size_t>(body)];
      if (f % 2 == 0) X_WB.p_WB[axis] += by;
      frame.push_back({body, X_WB});
    }
    scene.frames.push_back(std::move(frame));
  }
  return scene;
}

/// Sizes from 2^-6 to 2^6, and rods that are 2^8 times as long as thick: on every level of a hierarchy, and across more
/// cells than a table has. Anything may move, or turn, so that a box becomes longer than any before.
Scene many_sizes(Random& random) {
  const int n = many(random);
  Scene scene;
  for (int i = 0; i < n; ++i) {
    const double half = dyadic(random, 1, 1, -6, random.one_in(4) ? 6 : 0);
    Vec3 halves = Vec3::Constant(half);
    if (random.one_in(6)) halves[random.below(3)] = 256 * half;
    scene.bodies.push_back(at_rest(Box{halves}));
  }
  std::vector<Pose> first;
  for (int i = 0; i < n; ++i) first.push_back({0.25 * small_vector(random, 32), {}});
  return few_move(random, std::move(scene), first, std::max(1, n / 12), random.between(8, 20),
                  [](Random& r, const Pose& X_WB) {
                    const double by = r.pick({0x1p-6, 0.25, 4.0});
                    const Vec3 p = X_WB.p_WB + by * small_vector(r, 2);
                    return Pose{p, r.one_in(2) ? X_WB.q_WB : axes_quaternion(r)};
                  });
}

/// One rod among small boxes lies down along x or y, so that its box is longer than any was when the cells were sorted;
/// a box comes to its end, touches it, and goes back; the rod stands up again.
Scene turning_rod(Random& random) {
  const int n = many(random);
  const double half = random.pick({0.75, 1.0, 1.25});
  Scene scene;
  scene.bodies.push_back(at_rest(Box{Vec3(0.125, 0.125, half)}));
  for (int i = 1; i < n; ++i) scene.bodies.push_back(at_rest(Box{Vec3::Constant(0.25)}));
  std::vector<Pose> first = on_lattice(random, n, 1);
  first.front().p_WB.setZero();  // so that both ends stay among the boxes: beyond them cells are laid out again
  SequenceFrame all;
  for (int i = 0; i < n; ++i) all.push_back({i, first[static_cast<std::size_t>(i)]});
  scene.frames.push_back(std::move(all));
  for (int round = random.between(2, 5); round > 0; --round) {
    const int axis = random.below(2), box = random.between(1, n - 1);
    Pose lying = first.front(), there = {lying.p_WB, {}};
    lying.q_WB = axis == 0 ? Quaternion{1, 0, 1, 0} : Quaternion{1, 1, 0, 0};  // z to x, or to −y
    there.p_WB[axis] += random.sign() * (half + 0.25);
    scene.frames.push_back({{0, lying}});
    scene.frames.push_back({{box, there}});
    scene.frames.push_back({{box, first[static_cast<std::size_t>(box)]}});
    scene.frames.push_back({{0, first.front()}});
  }
  return scene;
}

/// A few bodies at first, and again as many in every frame; then half of them go in every frame.
Scene growing(Random& random) {
  const int n = many(random);
  Scene scene;
  for (int i = 0; i < n; ++i) scene.bodies.push_back(at_rest(Box{Vec3::Constant(random.pick({0.25, 0.5, 1.0}))}));
  const std::vector<Pose> at = on_lattice(random, n, 1);
  int there = 0;
  for (int next = random.between(1, 4); there < n; next = 2 * there) {
    SequenceFrame frame;
    for (; there < std::min(next, n); ++there) frame.push_back({there, at[static_cast<std::size_t>(there)]});
    scene.frames.push_back(std::move(frame));
  }
  while (there > 1) {
    SequenceFrame frame;
    for (const int left = there / 2; there > left; --there) frame.push_back({there - 1, {}});
    scene.frames.push_back(std::move(frame));
  }
  return scene;
}

/// Two or three bodies at a time go far beyond all others, into the same place or beside each other, and come back.
Scene leaving(Random& random) {
  const int n = many(random);
  Scene scene;
  for (int i = 0; i < n; ++i) scene.bodies.push_back(at_rest(Box{Vec3::Constant(0.5)}));
  const std::vector<Pose> first = on_lattice(random, n, 1);
  SequenceFrame all;
  for (int i = 0; i < n; ++i) all.push_back({i, first[static_cast<std::size_t>(i)]});
  scene.frames.push_back(std::move(all));
  for (int round = random.between(2, 5); round > 0; --round) {
    const int leaver = random.below(n), together = random.between(2, 3);
    Vec3 there = small_vector(random, 2);
    const double side = random.sign(), far = side * std::ldexp(1.0, random.between(2, 12));
    there[random.below(3)] = far;
    for (const bool leaves : {true, false}) {
      SequenceFrame frame;
      for (int k = 0; k < together; ++k) {
        const int body = (leaver + k) % n;
        const Vec3 beside = leaves ? small_vector(random, 1) : Vec3::Zero();
        frame.push_back({body, leaves ? Pose{there + beside, {}} : first[static_cast<std::size_t>(body)]});
        if (random.one_in(2)) {
          scene.frames.push_back(std::move(frame));
          frame.clear();
        }
      }
      if (!frame.empty()) scene.frames.push_back(std::move(frame));
    }
  }
  return scene;
}

/// A prism of many corners that is hardly tilted, and a plate that comes down on it: its lower side is between the
/// top's highest corner and the top's middle, or just above.
Scene tilted(Random& random) {
  struct Circle {
    int square, radius;  // its highest corner is at (0, radius)
  };
  const Circle circle = random.pick<Circle>({{25, 5}, {625, 25}, {4225, 65}});
  const int k = random.between(4, 36);
  const double w = std::ldexp(1.0, k), rise = circle.radius * std::ldexp(1.0, 1 - k);
  Scene scene;
  scene.bodies.push_back(at_rest(prism(lattice_circle(circle.square), -1, 1)));
  scene.bodies.push_back(at_rest(Box{Vec3{random.whole(1, 80), random.whole(1, 80), 1}}));
  const double sign = random.sign();
  const bool about_x = random.one_in(2);
  const auto prism_at = [&](double x) { return Pose{{x, 0, 0}, {w, about_x ? sign : 0, about_x ? 0 : sign, 0}}; };
  scene.frames.push_back({{0, prism_at(0)}, {1, Pose{{0, 0, 4}, {}}}});
  for (int f = random.between(2, 6); f > 0; --f) {
    const double part = random.pick({0.25, 0.5, 0.75, 1.25});
    scene.frames.push_back({{1, Pose{{random.whole(-9, 9), random.whole(-9, 9), 2 + part * rise}, {}}}});
    if (random.one_in(2)) scene.frames.back().push_back({0, prism_at(random.whole(-1, 1))});
  }
  return scene;
}

/// All bodies move, each with a velocity of its own, by a 64th to half of its size in a frame; every number is a random
/// double.
Scene streaming(Random& random) {
  const int n = many(random);
  const auto number = [&random] { return 2 * random.unit() - 1; };
  const double fastest = random.pick({0x1p-6, 0x1p-4, 0.5});
  const double room = cube_root(n);
  Scene scene;
  std::vector<Vec3> p, v;
  for (int i = 0; i < n; ++i) {
    scene.bodies.push_back(at_rest(Box{Vec3{0.25 + random.unit() / 2, 0.25 + random.unit() / 2, 0.5}}));
    p.push_back(room * Vec3{number(), number(), number()});
    v.push_back(fastest * Vec3{number(), number(), number()});
  }
  for (int f = random.between(6, 16); f > 0; --f) {
    SequenceFrame frame;
    for (int i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      frame.push_back({i, Pose{p[k], {}}});
      p[k] += v[k];
    }
    scene.frames.push_back(std::move(frame));
  }
  return scene;
}

Polytope prism_of_many_corners(Random& random) {
  const Polygon circle = lattice_circle(random.pick({25, 65, 325}));
  const double lo = -random.whole(1, 4);
  const double hi = random.whole(1, 4);
  return prism(circle, lo, hi);
}

Shape many_corners(Random& random) {
  if (!random.one_in(3)) return prism_of_many_corners(random);
  Compound compound;
  for (int k = random.between(1, 3); k > 0; --k) {
    const Vec3 p = small_vector(random, 8);
    const Polytope prism = prism_of_many_corners(random);
    compound.parts.push_back({Pose{p, small_quaternion(random)}, prism});
  }
  return compound;
}

/// Prisms of 24 to 48 corners, and compounds of them, that turn by a fixed rational angle in each frame, or lie with
/// many corners exactly at one height.
Scene turning_round_solids(Random& random) {
  Scene scene;
  std::vector<Pose> now;
  for (int i = random.between(2, 5); i > 0; --i) {
    scene.bodies.push_back(at_rest(many_corners(random)));
    const Vec3 p = 8 * small_vector(random, 2);
    now.push_back({p, random.one_in(3) ? axes_quaternion(random) : small_quaternion(random)});
  }
  const double w = random.pick({1.0, 4.0, 16.0});
  const Vec3 turn = small_vector(random, 1);
  const Quaternion by{w, turn.x(), turn.y(), turn.z()};
  for (int f = random.between(3, 6); f > 0; --f) {  // the quaternions stay floats
    SequenceFrame frame;
    for (std::size_t i = 0; i < now.size(); ++i) {
      frame.push_back({static_cast<int>(i), now[i]});
      now[i] = {now[i].p_WB + small_vector(random, 1), times(by, now[i].q_WB)};
    }
    scene.frames.push_back(std::move(frame));
  }
  return scene;
}

}  // namespace

std::vector<Family> long_sequence_families() {
  const std::vector<std::string> queries = {"broad_phase"};
  return {
      {"films.many", "18 to 300 cells of a lattice, of which few move by half a cell", queries, true, many_on_lattice},
      {"films.back_and_forth", "18 to 300 bodies, of which few move to and fro", queries, true, back_and_forth},
      {"films.many_sizes", "18 to 300 boxes of sizes 2^-6 to 2^6, and long rods that turn", queries, true, many_sizes},
      {"films.turning_rod", "a rod that lies down among 18 to 300 boxes, and boxes that come to its ends", queries,
       true, turning_rod},
      {"films.growing", "bodies that double in number, then halve", queries, true, growing},
      {"films.leaving", "18 to 300 boxes, of which two or three meet far outside", queries, true, leaving},
      {"films.tilted", "a prism of many corners tilted by 2^-3 to 2^-35, and a plate on its highest one", queries,
       false, tilted},
      {"films.streaming", "18 to 300 boxes that all move, every number a random double", queries, false, streaming},
      {"films.round_solids", "prisms of 24 to 48 corners, and compounds of them, that turn", queries, true,
       turning_round_solids},
  };
}

}  // namespace touchstone::properties
