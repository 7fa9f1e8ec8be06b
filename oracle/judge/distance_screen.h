// A quick judge of one answer about a distance. It proves the truth, and compares the answer with it; the laws about
// several answers are not its matter.
#pragma once

#include "model/answers.h"
#include "model/scene.h"
#include "oracle/subject.h"

namespace touchstone::oracle::judge {

enum class Screened {
  right,  ///< proved: all properties about one answer hold (properties/distance.cpp)
  wrong,  ///< proved: one of them fails
  open    ///< neither
};

struct DistanceScreening {
  Screened result = Screened::open;
  bool by_exact_truth = false;  ///< long doubles did not decide
  Verdict verdict = Verdict::separated;
  double margin = 0;  ///< the true distance over the scene's scale
  double error = 0;   ///< the greatest possible error of the stated distance, over what is allowed
  double width = 0;   ///< of the stated enclosure, over what is allowed
};

/// The truth comes from reference/enclosed_distance.h; if it does not decide about the answer, from
/// reference/distance.h with its certificate. The answer is used as a hint alone: which points and features it states.
/// So no answer can make itself right.
///
/// `right` is said of complete answers: verdict, distance, enclosure, and unless the bodies overlap witnesses and
/// features. The allowed errors are those of the properties for the card's precision. Where the card declares more, no
/// answer is called wrong. Requires a completed scene.
DistanceScreening screen(const Scene& scene, const Answer<Distance>& answer, const Card& card);

}  // namespace touchstone::oracle::judge
