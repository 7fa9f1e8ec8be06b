// Two parts at one time: how near, across which slab, and whether they surely share a point.
#pragma once

#include <optional>

#include "fast/lin_canny/walk.h"
#include "fast/time_of_impact/slab.h"
#include "fast/time_of_impact/swelling.h"

namespace touchstone::fast::meeting {

/// Of part `part_A` of a's body and part `part_B` of b's.
struct Pair {
  const motion::Flight& a;
  const motion::Flight& b;
  std::size_t part_A, part_B;
  motion::Origin O;        ///< the pair frame's origin
  Swelling swelling = {};  ///< of a's part

  Vec3 in_W(const Vec3& p, double t) const;  ///< of a point in the pair's frame
};

/// Near a, and falling if both fall alike from one time on.
motion::Origin origin(const motion::Flight& a, const motion::Flight& b);

class Look {
 public:
  /// `memory`: where the walk starts and, afterwards, where it ended. `known`: a direction that was good a moment ago,
  /// or 0; it is taken where the features' own is worse, as it is when rounding is all that parts the two. Throws
  /// std::range_error where lengths do not fit doubles (lin_canny::Hull).
  Look(const Pair& pair, double t, lin_canny::FeaturePair& memory, const Vec3& known);

  const Slab& slab() const { return slab_; }
  /// As Slab::clear_until, which three terms of a turn limit to about a radian; a body that is farther away than it is
  /// long may turn as it likes.
  double clear_until(const Slab& slab, double h_max) const;
  /// At contact, where several planes keep the two apart: one across which they part.
  std::optional<Slab> parting() const;
  /// ≥ the speed of any point of one, seen from any of the other (m/s).
  double greatest_speed() const;
  /// ≥ the distance (m).
  double at_most() const;
  /// A point that both surely have: proved, not likely. `before`: an earlier look, whose closest points have gone along
  /// with their bodies; one of them may be inside the other by now.
  bool overlap(const Look& before) const;
  /// Unit, from A to B: of the shortest way where one has a radius, else the slab's.
  Vec3 across() const;
  /// Midway between the closest points, in the pair's frame.
  Vec3 middle() const;

 private:
  Slab best_slab(const lin_canny::FeaturePair& before, const Vec3& known) const;
  Vec3 turn_of_features(const Vec3& n) const;

  const Pair& pair_;
  double t_;
  Side A_, B_;
  lin_canny::Walked walked_;
  Slab slab_;
};

}  // namespace touchstone::fast::meeting
