// The I-COLLIDE system (Cohen, Lin, Manocha, Ponamgi 1995): many bodies, followed from frame to frame.
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "fast/broad_phase/strategy.h"
#include "fast/lin_canny/nearest_parts.h"

namespace touchstone::fast {

/// Two bodies whose boxes overlap, and how far apart they are.
struct NearPair {
  BodyPair bodies;  ///< bodies.a is A of the answer, bodies.b is B
  lin_canny::NearestParts nearest;
};

/// Boxes prune the pairs, closest features are cached for the pairs that are left, for as long as they are near.
///
/// A body's box is a fixed cube around the ball of its vertices, so a pose costs one product; every pair of bodies that
/// are no farther than `margin` apart is near. What pairs() says of each is as in fast/distance.h: exact verdicts,
/// enclosures that hold.
///
/// Cost of a frame: the broad phase's, O(n) expected under coherence, and O(m) for m near pairs; no memory is asked for
/// unless pairs begin, or touch or overlap (which is settled exactly).
///
/// Errors: as BroadPhase, and InputError for a shape that is no solid. Requires valid shapes and poses.
class Collider {
 public:
  explicit Collider(std::unique_ptr<BroadPhase> broad_phase, double margin = 0);

  void insert(BodyId id, const Shape& shape, const Pose& X_WB);
  void move(BodyId id, const Pose& X_WB);
  void remove(BodyId id);

  /// The broad phase, then every near pair's distance.
  void update();

  /// The two halves of update(), for those who time them: which pairs are near, then how near.
  void find_near();
  void measure_near();

  /// As of the last update; not sorted, but the same calls give the same order.
  const std::vector<NearPair>& pairs() const { return near_; }

 private:
  struct Resident {
    lin_canny::Solid solid;
    lin_canny::Station station;
    Vec3 centre;        ///< of a ball around the solid, in the body's frame
    double radius = 0;  ///< of that ball
  };

  Aabb cube(const Resident& body) const;
  void begin(BodyPair pair);
  std::vector<lin_canny::FeaturePair> places(BodyPair pair) const;
  void end(BodyPair pair);
  static std::uint64_t key(BodyPair pair) { return std::uint64_t{pair.a} << 32 | pair.b; }

  std::unique_ptr<BroadPhase> broad_phase_;
  double margin_;
  std::vector<std::unique_ptr<Resident>> bodies_;  ///< by id
  std::vector<NearPair> near_;
  std::vector<std::vector<lin_canny::FeaturePair>> memory_;  ///< beside near_: one place a pair of parts
  std::unordered_map<std::uint64_t, std::size_t> position_;  ///< in near_; looked up only, never walked
};

}  // namespace touchstone::fast
