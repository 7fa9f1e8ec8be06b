// The I-COLLIDE system (Cohen, Lin, Manocha, Ponamgi 1995): the distances of many bodies, from frame to frame.
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "fast/broad_phase/strategy.h"
#include "fast/lin_canny/nearest_parts.h"

namespace touchstone::fast {

/// Two bodies whose boxes overlap, and their distance.
struct NearPair {
  BodyPair bodies;  ///< bodies.a is A of the result, bodies.b is B
  lin_canny::NearestParts nearest;
};

/// Boxes prune the pairs. For each remaining pair the closest features are cached while its boxes overlap.
///
/// A body's box is a fixed-size cube around its bounding ball, so setting a pose costs one product. Every pair of
/// bodies at most `margin` (m) apart is near. The results in pairs() obey fast/distance.h: exact verdicts and valid
/// enclosures.
///
/// Cost of a frame: that of the broad phase, O(n) expected under coherence, and O(m) for m near pairs. Memory is
/// allocated only when pairs begin, or for pairs that touch or overlap (which are resolved exactly).
///
/// Errors: as BroadPhase, and InputError for a shape that is not a solid. Requires valid shapes and poses.
class Collider {
 public:
  /// With `wrapped_grid`, the default broad phase for many bodies (fast/broad_phase/strategies.h).
  explicit Collider(double margin = 0);
  explicit Collider(std::unique_ptr<BroadPhase> broad_phase, double margin = 0);

  void insert(BodyId id, const Shape& shape, const Pose& X_WB);
  void move(BodyId id, const Pose& X_WB);
  void remove(BodyId id);

  /// Runs the broad phase, then computes the distance of every near pair.
  void update();

  /// The two halves of update(), for callers that time them: first the near pairs, then their distances.
  void find_near();
  void measure_near();

  /// As of the last update; not sorted, but the same calls give the same order.
  const std::vector<NearPair>& pairs() const { return near_; }

 private:
  struct Resident {
    lin_canny::Solid solid;
    lin_canny::CachedPose cached_pose;
    Vec3 centre;        ///< of the bounding ball, in the body's frame
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
  std::vector<std::vector<lin_canny::FeaturePair>> memory_;  ///< parallel to near_; one entry per pair of parts
  std::unordered_map<std::uint64_t, std::size_t> position_;  ///< index in near_; only looked up, never iterated
};

}  // namespace touchstone::fast
