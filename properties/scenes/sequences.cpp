// Sequences: bodies are added, moved and removed, in order to test what is kept from frame to frame.
#include <cmath>
#include <functional>
#include <utility>

#include "properties/scenes/families.h"
#include "properties/scenes/pair.h"

namespace touchstone::properties {
namespace {

/// The random choices for each body in each frame. A number n means "with probability 1/n".
struct Script {
  int fewest = 2;
  int most = 10;
  int rests = 3;  ///< a body that is present keeps its pose
  int goes = 8;   ///< a body that is present is removed
  int comes = 2;  ///< a body that is absent is added
  int still = 8;  ///< the frame is empty
  std::function<Shape(Random&)> shape;
  std::function<Pose(Random&)> enter;
  std::function<Pose(Random&, const Pose&)> step;
};

SequenceFrame frame(Random& random, const Script& script, std::vector<std::optional<Pose>>& now) {
  SequenceFrame frame;
  for (std::size_t i = 0; i < now.size(); ++i) {
    std::optional<Pose>& X_WB = now[i];
    if (X_WB ? random.one_in(script.rests) : !random.one_in(script.comes)) continue;
    if (!X_WB) {
      X_WB = script.enter(random);
    } else if (random.one_in(script.goes)) {
      X_WB.reset();
    } else {
      X_WB = script.step(random, *X_WB);
    }
    frame.push_back({static_cast<int>(i), X_WB});
  }
  return frame;
}

Scene sequence(Random& random, const Script& script) {
  Scene scene;
  for (int i = random.between(script.fewest, script.most); i > 0; --i) {
    scene.bodies.push_back(at_rest(script.shape(random)));
  }
  std::vector<std::optional<Pose>> now(scene.bodies.size());
  for (int f = random.between(2, 10); f > 0; --f) {
    const bool still = random.one_in(script.still);
    scene.frames.push_back(still ? SequenceFrame{} : frame(random, script, now));
  }
  return scene;
}

Shape box_of_whole_size(Random& random) {
  return Box{Vec3{random.whole(1, 3), random.whole(1, 3), random.whole(1, 3)}};
}

Shape box_or_sphere(Random& random) {
  if (random.one_in(3)) return Sphere{random.whole(1, 3)};
  return box_of_whole_size(random);
}

std::function<Pose(Random&)> within(int limit) {
  return [limit](Random& random) { return Pose{small_vector(random, limit), {}}; };
}

Pose step_on_lattice(Random& random, const Pose& X_WB) { return {X_WB.p_WB + small_vector(random, 1), X_WB.q_WB}; }

/// Steps as long as one box: pairs begin and end by touching.
Scene random_walk(Random& random) {
  return sequence(random, {.shape = box_or_sphere, .enter = within(5), .step = step_on_lattice});
}

/// Every body can be anywhere in every frame: no order persists.
Scene teleport(Random& random) {
  const auto anywhere = within(6);
  return sequence(
      random, {.rests = 6, .shape = box_of_whole_size, .enter = anywhere, .step = [anywhere](Random& r, const Pose&) {
                 return anywhere(r);
               }});
}

/// Unit cells of a lattice: end points tie on all axes, and neighbours touch exactly.
Scene lattice_ties(Random& random) {
  const double half = dyadic(random, 1, 1, -2, 2);
  const auto cell = [half](Random& r) { return Pose{2 * half * small_vector(r, 1), {}}; };
  return sequence(random, {.shape = [half](Random&) -> Shape { return Box{Vec3::Constant(half)}; },
                           .enter = cell,
                           .step = [cell](Random& r, const Pose&) { return cell(r); }});
}

/// Sizes from 2^-6 to 2^6 around one place: large boxes contain small ones, on every level of a hierarchy.
Scene nested_sizes(Random& random) {
  return sequence(random, {.shape = [](Random& r) -> Shape { return Box{Vec3::Constant(dyadic(r, 1, 1, -6, 6))}; },
                           .enter = within(3),
                           .step =
                               [](Random& r, const Pose& X_WB) {
                                 return Pose{X_WB.p_WB + 0x1p-5 * small_vector(r, 1 << 6), {}};
                               }});
}

/// Tight clusters far apart, and bodies that move to another cluster.
Scene clusters(Random& random) {
  const auto some = [](Random& r) {
    const Vec3 centre = 512 * small_vector(r, 1);
    return Pose{centre + small_vector(r, 2), {}};
  };
  return sequence(random, {.shape = box_or_sphere, .enter = some, .step = [some](Random& r, const Pose& X_WB) {
                             return r.one_in(4) ? some(r) : step_on_lattice(r, X_WB);
                           }});
}

/// Bodies are removed as often as they move, several in one frame, and are added again, elsewhere or in the same place.
Scene come_and_go(Random& random) {
  return sequence(
      random,
      {.rests = 4, .goes = 2, .shape = box_of_whole_size, .enter = within(3), .step = [](Random&, const Pose& X_WB) {
         return X_WB;
       }});
}

/// Mostly nothing happens, and a body that is moved is often put at the same place.
Scene hardly_moving(Random& random) {
  return sequence(random,
                  {.rests = 2,
                   .goes = 12,
                   .comes = 1,
                   .still = 2,
                   .shape = box_of_whole_size,
                   .enter = within(3),
                   .step = [](Random& r, const Pose& X_WB) { return r.one_in(2) ? X_WB : step_on_lattice(r, X_WB); }});
}

/// No body, one, or two.
Scene hardly_any(Random& random) {
  return sequence(
      random,
      {.fewest = 0, .most = 2, .goes = 3, .shape = box_of_whole_size, .enter = within(2), .step = step_on_lattice});
}

/// All along one axis, so that two of the three sorted lists consist of ties.
Scene along_a_line(Random& random) {
  const int axis = random.below(3);
  const auto on_line = [axis](Random& r) {
    Pose X_WB;
    X_WB.p_WB[axis] = r.whole(-8, 8);
    return X_WB;
  };
  return sequence(random, {.shape = [](Random&) -> Shape { return Box{Vec3::Ones()}; },
                           .enter = on_line,
                           .step = [on_line](Random& r, const Pose&) { return on_line(r); }});
}

/// Bodies that rotate: boxes grow and shrink in place.
Scene turning(Random& random) {
  const auto some = [](Random& r) {
    const Vec3 p = small_vector(r, 5);
    return Pose{p, small_quaternion(r)};
  };
  return sequence(random, {.shape = box_or_sphere, .enter = some, .step = [](Random& r, const Pose& X_WB) {
                             return Pose{X_WB.p_WB, small_quaternion(r)};
                           }});
}

/// Equal boxes that turn by 90° or 180° about their lowest corner: lower ends stay to the bit, upper ends do not.
Scene falling_over(Random& random) {
  const Vec3 half{random.whole(1, 2), random.whole(1, 4), random.whole(1, 4)};
  const auto lying = [half](Random& r, const Vec3& corner) {
    const Quaternion q = axes_quaternion(r);
    return Pose{corner + turned_by_axes(q, half).cwiseAbs(), q};
  };
  const auto somewhere = [lying](Random& r) { return lying(r, small_vector(r, 4)); };
  const auto fall = [half, lying](Random& r, const Pose& X_WB) {
    return lying(r, X_WB.p_WB - turned_by_axes(X_WB.q_WB, half).cwiseAbs());
  };
  return sequence(
      random, {.rests = 2, .shape = [half](Random&) -> Shape { return Box{half}; }, .enter = somewhere, .step = fall});
}

/// Small steps of random doubles: no ties, and everything is rounded.
Scene drifting(Random& random) {
  const auto number = [](Random& r) { return 2 * r.unit() - 1; };
  const auto vector = [number](Random& r) { return Vec3{number(r), number(r), number(r)}; };
  return sequence(random, {.shape = [](Random& r) -> Shape {
                             return Box{Vec3{r.unit() + 0x1p-9, r.unit() + 0x1p-9, r.unit() + 0x1p-9}};
                           },
                           .enter =
                               [vector](Random& r) {
                                 return Pose{2 * vector(r), {}};
                               },
                           .step =
                               [vector](Random& r, const Pose& X_WB) {
                                 return Pose{X_WB.p_WB + 0.25 * vector(r), {}};
                               }});
}

}  // namespace

std::vector<Family> sequence_families() {
  const std::vector<std::string> queries = {"broad_phase"};
  return {
      {"films.random_walk", "2 to 10 boxes and spheres that step on a lattice", queries, true, random_walk},
      {"films.teleport", "boxes that are somewhere else in every frame", queries, true, teleport},
      {"films.lattice_ties", "cells of a small lattice: end points tie, neighbours touch", queries, true, lattice_ties},
      {"films.nested_sizes", "boxes of sizes 2^-6 to 2^6 around one place", queries, true, nested_sizes},
      {"films.clusters", "clusters 512 m apart, bodies change between them", queries, true, clusters},
      {"films.come_and_go", "bodies are removed, several in a frame, and placed again", queries, true, come_and_go},
      {"films.hardly_moving", "empty frames, and bodies placed where they are already", queries, true, hardly_moving},
      {"films.hardly_any", "no body, one, or two", queries, true, hardly_any},
      {"films.line", "equal boxes along one axis", queries, true, along_a_line},
      {"films.turning", "boxes and spheres that turn in place", queries, true, turning},
      {"films.falling_over", "equal boxes that turn by 90° about their lowest corner", queries, true, falling_over},
      {"films.drifting", "boxes in small steps, every number a random double", queries, false, drifting},
  };
}

}  // namespace touchstone::properties
