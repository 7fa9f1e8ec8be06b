#include "properties/judging/missed_pairs.h"

#include <utility>

#include "oracle/judge/judge.h"
#include "oracle/tolerance/tolerance.h"

namespace touchstone::properties {

double rounding_of_a_pair(const Scene& scene, oracle::Precision precision) {
  return 2 * oracle::tolerance::bounds(scene, precision);
}

oracle::Finding missed_pairs(const Scene& scene, const oracle::Card& card, double deepest, std::string observed) {
  const oracle::judge::Allowance none = oracle::judge::in_ulps(scene, card, 0);
  oracle::Finding finding = oracle::judge::wrong_by(deepest, none, oracle::Defect::missed, std::move(observed),
                                                    "every pair whose closed boxes intersect");
  finding.margin = Interval{deepest, deepest};
  finding.rounding = rounding_of_a_pair(scene, card.precision) / none.unit;
  return finding;
}

}  // namespace touchstone::properties
