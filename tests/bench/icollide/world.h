// The I-COLLIDE experiment (Cohen, Lin, Manocha & Ponamgi 1995): random polytopes that move, rotate and rebound in a
// box.
#pragma once

#include <cstdint>
#include <vector>

#include "model/scene.h"

namespace touchstone::bench {

/// The paper's defaults; one parameter is varied at a time.
struct Parameters {
  int bodies = 1000;
  int faces = 36;         ///< triangles: 2 vertices − 4
  double density = 0.01;  ///< volume of the polytopes over volume of the box
  double turn = 10;       ///< degrees per frame
  double stretch = 1;     ///< length over width
  double step = 0.1;      ///< radii per frame
};

/// A pure function of the parameters and the seed.
class World {
 public:
  World(const Parameters& parameters, std::uint64_t seed);

  const std::vector<Body>& bodies() const { return bodies_; }

  /// Advances by one frame: every body moves and rotates, and reverses at a wall.
  void advance();

  /// How a colliding pair responds in the paper.
  void exchange_velocities(std::size_t a, std::size_t b);

 private:
  double room_ = 0;  ///< half the box's side, m
  double turn_ = 0;  ///< rad per frame
  int frame_ = 0;
  std::vector<Body> bodies_;
  std::vector<Vec3> velocity_;  ///< m per frame
  std::vector<Vec3> axis_;
};

}  // namespace touchstone::bench
