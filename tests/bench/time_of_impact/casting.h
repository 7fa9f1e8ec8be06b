// What the engines that cast shapes share.
#pragma once

#include <memory>
#include <variant>

#include "oracle/subjects/common/cast.h"
#include "tests/bench/time_of_impact/contestant.h"

namespace touchstone::bench {

/// `Pair` is made from a scene and casts along one way of it.
template <class Pair>
Ask casting(const Scene& scene) {
  return [scene, pair = std::make_shared<Pair>(scene)] {
    const auto cast = [&](const oracle::subjects::Way& way) { return pair->cast(way); };
    return std::get<TimeOfImpact>(oracle::subjects::cast_along(scene, true, cast));
  };
}

}  // namespace touchstone::bench
