// Sequences of poses of two bodies: the workloads of the distance benchmark.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/scene.h"

namespace touchstone::bench {

/// Two polytopes, and their poses frame by frame.
struct FrameSequence {
  Polytope A;
  Polytope B;
  struct Poses {
    Pose X_WA;
    Pose X_WB;
  };
  std::vector<Poses> frames;
};

/// Polytopes of n vertices on the unit sphere, in pairs that are never closer than 0.05 unless it is said:
///   coherent          each rotates by 10 degrees per frame about its own axis, B moves by 5 % of the radius per frame
///   cold              poses are unrelated to those of the previous frame
///   coherent_100, coherent_1000, cold_100, cold_1000: the same for so many pairs, asked in turn; at most 32 pairs of
///                     shapes differ, but nothing is shared
///   once              the poses of cold, in scenes that are asked about once
///   once_overlapping  the same with the origins 0.3 times as far apart
///   once_touching     B is A mirrored at one of A's vertices
std::vector<std::string> workloads();

/// Whether its contestants get a scene in each frame, and keep nothing.
bool asks_once(const std::string& workload);

/// A sequence for each pair, all equally long; `frames` in all, but 8 at least for each. A pure function of its
/// arguments.
std::vector<FrameSequence> shoot(const std::string& workload, int vertices, std::size_t frames);

Scene scene_of(const FrameSequence& sequence, const FrameSequence::Poses& poses);

}  // namespace touchstone::bench
