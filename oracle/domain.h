// What a subject's maker vouches for, as data on its card: the scenes, and how accurate distances are there.
#pragma once

#include <optional>
#include <string>

#include "model/scene.h"

namespace touchstone::oracle {

/// Limits that are absent limit nothing. A scene is inside if all its bodies (of a compound: all parts) are within all
/// limits.
struct Domain {
  std::optional<Interval> lengths;        ///< m: a body is no thinner than lo, and no longer than hi
  std::optional<Interval> fixed_lengths;  ///< m: the same for a body that is fixed; absent: as `lengths`
  std::optional<double> reach;            ///< m: greatest absolute coordinate, plus the radius about the body's origin
  std::optional<double> aspect;           ///< 1: length over thickness of a body
  std::optional<int> vertices;            ///< of a polytope
  std::optional<double> mass_ratio;       ///< 1: of the greatest and the least mass of two bodies that are not fixed
  std::optional<double> speed;            ///< m/s: of a centre of mass at the start
  std::optional<double> angular_speed;    ///< rad/s, likewise
  /// m/s: where bodies move at the start and nothing falls, the fastest point of them is at least as fast.
  std::optional<double> lowest_speed;

  bool operator==(const Domain&) const = default;
};

/// By how much a distance or a depth may be off beyond rounding.
struct DistanceTolerance {
  double absolute = 0;  ///< m
  double relative = 0;  ///< 1
  double slop = 0;      ///< m: an overlap that the engine leaves alone, or takes off its depths
  double margin = 0;  ///< m: by which each body is larger, or rounded (a convex radius); witness points are as far off

  double of(double length) const { return absolute + relative * length + slop + 2 * margin; }
  bool operator==(const DistanceTolerance&) const = default;
};

/// By how much two bodies may be apart, or overlap, at a reported time of impact beyond rounding. A cast that ends once
/// the two are close enough declares here how close.
struct ContactTolerance {
  double absolute = 0;  ///< m
  double size = 0;      ///< 1: of the thickness of the thinnest body
  double way = 0;       ///< 1: of the longest way of a point until the motion ends

  bool operator==(const ContactTolerance&) const = default;
};

/// What a domain limits, in the same units. `lengths`: of the thinnest body, and of the longest one.
struct SceneSizes {
  Interval lengths;
  double reach = 0;
  double aspect = 0;
  int vertices = 0;
  double speed = 0;
  double angular_speed = 0;
};

/// The thickness of a polytope is its least height over one of its faces, that of a sphere its diameter, that of a box
/// its shortest side. The length is the greatest distance from the first vertex, the diameter, or the diagonal. Errors:
/// of doubles.
SceneSizes sizes_of(const Scene& scene);

/// Of the bodies that are not fixed; 1 if there is none. It takes their exact masses, so it is not one of the sizes.
double mass_ratio(const Scene& scene);

/// The limit that the scene exceeds, in words with numbers; none if it is inside. A scene within 2⁻⁴⁰ of a limit may be
/// on either side.
std::optional<std::string> beyond(const Domain& domain, const Scene& scene);

}  // namespace touchstone::oracle
