// A collider that is asked frame after frame: which bodies are near each other, and how far apart are they?
#include <touchstone/fast/collider.h>

#include <cstdio>

using namespace touchstone;

int main() {
  const char* const names[] = {"ball", "post", "wall"};

  // Pairs of bodies that are at most 1 m apart are near; some that are farther apart are near too, since near are those
  // whose boxes overlap. A body is known by an id that the caller chooses; small ones save memory. Here it is the index
  // of its name.
  const double margin = 1;
  fast::Collider collider(margin);
  collider.insert(0, Sphere{0.5}, {Vec3(0, 0, 0), {}});
  collider.insert(1, Box{Vec3(0.25, 0.25, 0.5)}, {Vec3(3, 1, 0), {}});
  collider.insert(2, Box{Vec3(0.75, 1, 1)}, {Vec3(7.25, 0, 0), {}});

  // In each frame, set the poses of the bodies that moved, update, and read the near pairs. What the search found out
  // about a pair is remembered while the pair stays near, so that a frame costs little if the bodies move little.
  for (int frame = 0; frame <= 7; ++frame) {
    collider.move(0, {Vec3(frame, 0, 0), {}});
    collider.update();
    std::printf("ball at x = %d m\n", frame);
    for (const fast::NearPair& pair : collider.pairs()) {
      const fast::lin_canny::Proximity& found = pair.nearest.proximity;
      std::printf("  %s and %s: ", names[pair.bodies.a], names[pair.bodies.b]);
      if (found.verdict == Verdict::separated) {
        std::printf("%g m apart\n", found.distance);
      } else {
        std::printf(found.verdict == Verdict::touching ? "touching\n" : "overlapping\n");
      }
    }
  }
}
