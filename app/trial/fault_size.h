// How large a fault is, so that the scene shown for it is one that a person believes.
#pragma once

#include "model/scene.h"
#include "oracle/finding.h"
#include "oracle/subject.h"

namespace touchstone::app {

/// The error of a failing answer, beside what is allowed and beside the scene.
struct FaultSize {
  double over_allowance = 0;  ///< error / allowed, which counts as at least one unit
  double over_scene = 0;      ///< error / the scene's own length, speed or other size: what the unit is a part of
};

/// Of a failing finding about this scene, of a subject that computes with this precision. Findings without a magnitude
/// have the size 0. An error in a unit without a size in the scene (J, N s) is only compared with what is allowed.
FaultSize fault_size(const oracle::Finding& finding, const Scene& scene, oracle::Precision precision);

/// May the scene stand for the fault? Not where the allowance is as large as what is compared, or infinite: where all
/// bodies are at rest, an ulp of their speeds is next to nothing, and an error of any size is 2^1000 of them.
bool is_measurable(const oracle::Finding& finding, oracle::Precision precision);

/// Is the fault still as large as the one that was found?
bool as_large(const FaultSize& now, const FaultSize& found);

}  // namespace touchstone::app
