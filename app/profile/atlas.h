// Where a subject fails: the outcomes of one query by the sizes of the scenes.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "oracle/domain.h"
#include "oracle/finding.h"

namespace touchstone::app {

/// A completed scene of a query.
struct SizedScene {
  const Scene& scene;
  const std::string& query;
  oracle::SceneSizes sizes;
};

/// A size of scenes, in classes.
struct AtlasAxis {
  std::string name;           ///< "aspect"
  std::string unit;           ///< "m"; "1" of a ratio
  std::string says;           ///< what is measured
  std::vector<double> edges;  ///< ascending; class k holds the values above edge k − 1 and up to edge k
  std::optional<double> (*value)(const SizedScene&);           ///< none: the axis means nothing for this scene
  std::optional<Interval> (*declared)(const oracle::Domain&);  ///< the range on a subject's card; null: no card has one
};

/// gap, length, thickness, reach, aspect, vertices, mass ratio, slip, friction, speed, spin.
const std::vector<AtlasAxis>& atlas_axes();

/// An axis and a class on it, both counted from 0.
using AtlasPlace = std::pair<int, int>;

/// Where the scene is, on each axis that means something for the query. Requires a completed scene.
std::vector<AtlasPlace> places_of(const Scene& scene, const std::string& query);

/// What all properties together found about one subject's answers on one scene.
struct SceneOutcome {
  bool answered = false;
  bool failed = false;
  bool broken = false;  ///< failed, since there was no answer
  double excess = 0;    ///< the largest error over what is allowed (oracle/finding.h)

  void add(const oracle::Finding& finding);
};

/// Of the scenes at one place.
struct AtlasCell {
  long scenes = 0;  ///< with an answer, or a break
  long failing = 0;
  long broken = 0;  ///< of the failing ones
  double excess = 0;

  void merge(const AtlasCell& later);
};

/// By place, the scenes inside and outside the domain that a card declares alike.
using Atlas = std::map<AtlasPlace, AtlasCell>;

void add(Atlas& atlas, const std::vector<AtlasPlace>& places, const SceneOutcome& outcome);
void merge(Atlas& atlas, const Atlas& later);

/// Is a class of an axis inside the range that a card declares?
enum class DomainSide { inside, across, outside };
DomainSide side_of(const AtlasAxis& axis, int k, const oracle::Domain& domain);

/// The bounds of class k: 0 below the first edge, infinity above the last one.
Interval class_bounds(const AtlasAxis& axis, int k);

}  // namespace touchstone::app
