// Pairs of bodies followed through time: what the distance benchmark asks.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/scene.h"

namespace touchstone::bench {

/// Two polytopes of n vertices on the unit sphere, never nearer than 0.05, and their poses frame by frame.
///   coherent  each turns by 10 degrees a frame about an axis of its own, B wanders by 5 % of the radius a frame
///   cold      poses that have nothing to do with those of the frame before
struct Film {
  Polytope A;
  Polytope B;
  struct Poses {
    Pose X_WA;
    Pose X_WB;
  };
  std::vector<Poses> frames;
};

std::vector<std::string> workloads();
Film shoot(const std::string& workload, int vertices, std::size_t frames);

Scene scene_of(const Film& film, const Film::Poses& poses);

}  // namespace touchstone::bench
