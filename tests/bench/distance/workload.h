// Sequences of poses of two bodies: the workloads of the distance benchmark.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/scene.h"

namespace touchstone::bench {

/// Two polytopes of n vertices on the unit sphere, never closer than 0.05, and their poses frame by frame.
///   coherent  each rotates by 10 degrees per frame about its own axis, B moves by 5 % of the radius per frame
///   cold      poses are unrelated to those of the previous frame
struct FrameSequence {
  Polytope A;
  Polytope B;
  struct Poses {
    Pose X_WA;
    Pose X_WB;
  };
  std::vector<Poses> frames;
};

std::vector<std::string> workloads();
FrameSequence shoot(const std::string& workload, int vertices, std::size_t frames);

Scene scene_of(const FrameSequence& sequence, const FrameSequence::Poses& poses);

}  // namespace touchstone::bench
