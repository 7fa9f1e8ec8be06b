// Where an engine stops being right: the domain that a precision suggests, and the widest one in which each property
// holds, measured along one size at a time.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "oracle/subject.h"
#include "properties/property.h"

namespace touchstone::app {

/// For a card that declares none. Where a coordinate S and a thickness t are within it, the 250 ulps of S that a
/// distance is allowed (docs/spec/README.md) are at most 2⁻¹⁰ of t: S/t ≤ 2⁻¹⁰/(250 u): 2⁶ or 2³⁵; half of these powers
/// are above 1 m and half below. Speeds stay within reach for 1 s; ratios of masses, and angles in 1 s, lose no more
/// than all but ten bits: 2⁻¹⁰/u.
oracle::Domain default_domain(oracle::Precision precision);

/// A size that grows by powers of two from that of the plain scenes.
struct Axis {
  std::string name;
  int start = 0;            ///< exponent of the plain scenes
  int least = 0, most = 0;  ///< exponents that are asked
  bool of_motion = false;   ///< only of impacts and motions
  std::function<std::optional<Scene>(const Scene&, int exponent)> at;
};

const std::vector<Axis>& axes();

/// From 2^least to 2^most one property holds on all plain scenes, changed along one axis, that are in its domain.
struct HeldRange {
  const properties::Property* property = nullptr;
  const Axis* axis = nullptr;
  int least = 1, most = 0;                        ///< least > most: it fails on the plain scenes
  bool fails_below = false, fails_above = false;  ///< else no further scene was in its domain, or none was asked
};

/// Asks the queries that the subject's card claims and that are in `queries`; all that it claims if that is empty.
/// Plain scenes are those on paper. Properties that are outside on all of them, or never answered, have no range. Each
/// exponent is asked until a property fails. `asked` is called before each exponent.
std::vector<HeldRange> widest_domain(oracle::Subject& subject, const std::vector<std::string>& queries,
                                     const std::function<void(const std::string& query)>& asked);

}  // namespace touchstone::app
