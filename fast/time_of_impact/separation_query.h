// Two parts at one time: their distance, their separating plane, and whether they are proved to overlap.
#pragma once

#include <optional>

#include "fast/lin_canny/walk.h"
#include "fast/time_of_impact/inflation.h"
#include "fast/time_of_impact/separating_plane.h"

namespace touchstone::fast::time_of_impact {

/// Part `part_A` of a's body and part `part_B` of b's body.
struct Pair {
  const motion::BallisticMotion& a;
  const motion::BallisticMotion& b;
  std::size_t part_A, part_B;
  motion::Origin O;          ///< origin of the pair's frame
  Inflation inflation = {};  ///< of a's part

  const lin_canny::Convex& A() const { return a.model().solid.parts()[part_A]; }
  const lin_canny::Convex& B() const { return b.model().solid.parts()[part_B]; }
  Vec3 in_W(const Vec3& p, double t) const;  ///< p: a point in the pair's frame
};

/// Near a; falls with the bodies if both started at the same time and have the same acceleration.
motion::Origin origin(const motion::BallisticMotion& a, const motion::BallisticMotion& b);

/// Where the closest features give no separating plane: which others are tried.
enum class Planes {
  likely,  ///< along faces, and none that rotates
  all      ///< also along an edge of each: thousands
};

class SeparationQuery {
 public:
  /// `memory`: where the walk starts and, afterwards, where it ended. `known`: a direction that separated the two a
  /// moment ago, or 0; it is used where the features' own direction is worse, as it is when only rounding separates the
  /// two. Throws std::range_error if lengths do not fit doubles (lin_canny::Hull).
  SeparationQuery(const Pair& pair, double t, lin_canny::FeaturePair& memory, const Vec3& known,
                  Planes planes = Planes::all);

  const SeparatingPlane& plane() const { return plane_; }
  /// As SeparatingPlane::clear_until, whose three-term expansion limits rotation to about a radian; but a body that is
  /// farther away than it is long may rotate freely.
  double clear_until(const SeparatingPlane& plane, double h_max) const;
  /// At contact, where several planes separate the two: a plane along whose normal they move apart. `at_start_poses`:
  /// this is the time of both motions' starts, where the poses are known exactly; then the plane is proved to
  /// separate the cores, and else it does so within rounding.
  std::optional<SeparatingPlane> parting(bool at_start_poses) const;
  /// ≥ the speed of any point of one part relative to any point of the other (m/s).
  double greatest_speed() const;
  /// ≥ the distance (m).
  double at_most() const;
  /// Whether a point common to both is proved. `before`: an earlier query, whose closest points have moved with their
  /// bodies; one of them may be inside the other body by now.
  bool overlap(const SeparationQuery& before) const;
  /// Unit, from A to B: the direction of the shortest connection if one part has a radius, else the plane's normal.
  Vec3 across() const;
  /// The middle of the closest points, in the pair's frame.
  Vec3 middle() const;

 private:
  SeparatingPlane best_plane(const lin_canny::FeaturePair& before, const Vec3& known, Planes planes) const;
  Vec3 direction_of_features() const;
  template <class Accepts>
  bool any_turned(const Vec3& n, const Vec3& p_OC, Accepts&& accepts) const;
  SeparatingPlane longest_turned(const SeparatingPlane& plane, const Vec3& p_OC) const;
  SeparatingPlane best_turned(const Vec3& n, const Vec3& p_OC) const;
  std::optional<Vec3> turn_with_edges(const Vec3& n, const Vec3& along_A, const Vec3& along_B) const;
  std::optional<Vec3> turn_of_features(const Vec3& n) const;

  const Pair& pair_;
  double t_;
  MovingCore A_, B_;
  lin_canny::Walked walked_;
  SeparatingPlane plane_;
};

}  // namespace touchstone::fast::time_of_impact
