#include "oracle/judge/distance_screen.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "oracle/judge/judge.h"
#include "oracle/tolerance/precision.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/truth.h"
#include "oracle/truth/world_points.h"
#include "reference/enclosed_distance.h"

namespace touchstone::oracle::judge {
namespace {

/// What is known of the truth.
struct Known {
  Verdict verdict;
  Interval distance;
};

struct Allowed {
  double distance;
  double witness;
};

bool all_stated(const Distance& said) { return said.verdict && said.distance && said.enclosure; }

Screened both(Screened a, Screened b) {
  if (a == Screened::wrong || b == Screened::wrong) return Screened::wrong;
  return a == Screened::right ? b : a;
}

// Properties compare differences in ulps. Where a rounding may bring one to the other side, nothing is proved. (A sum
// of a distance and an allowance would round by far more.)
constexpr double surely_less = 1 - 0x1p-40;
constexpr double surely_more = 1 + 0x1p-40;

/// Whether `value` is within `allowed` of a number in `truth`.
Screened within(double value, const Interval& truth, double allowed) {
  if (std::max(value - truth.lo, truth.hi - value) <= allowed * surely_less) return Screened::right;
  if (std::max(value - truth.hi, truth.lo - value) > allowed * surely_more) return Screened::wrong;
  return Screened::open;
}

Screened holds_truth(const Interval& said, const Interval& truth, double allowed) {
  if (said.lo > truth.hi || said.hi < truth.lo) return Screened::wrong;
  const double width = said.hi - said.lo;
  if (width > truth.hi - truth.lo + 2 * allowed * surely_more) return Screened::wrong;
  const bool is_tight = width <= 2 * allowed * surely_less;
  return said.lo <= truth.lo && said.hi >= truth.hi && is_tight ? Screened::right : Screened::open;
}

/// Upper bounds alone: they prove no answer wrong.
Screened proves(bool is_proved) { return is_proved ? Screened::right : Screened::open; }

Screened witnesses_and_features(const Distance& said, const Known& truth, const reference::EnclosedPair& pair,
                                const Allowed& allowed) {
  if (!said.p_WCa || !said.p_WCb || !said.feature_A || !said.feature_B) return Screened::open;
  // Here and in the property the length is computed with few roundings; 32u of it is more than both.
  const double rounding_of_length = 0x1p-48 * truth.distance.hi;
  const Point way = said.p_WCa->cast<Real>() - said.p_WCb->cast<Real>();
  Screened result = within(static_cast<double>(way.norm()), truth.distance, allowed.distance - rounding_of_length);
  if (result == Screened::wrong) result = Screened::open;
  result = both(result, proves(pair.off_feature_A(*said.p_WCa, *said.feature_A) <= allowed.witness * surely_less &&
                               pair.off_feature_B(*said.p_WCb, *said.feature_B) <= allowed.witness * surely_less));
  const double apart = pair.features_apart(*said.feature_A, *said.feature_B);
  return both(result, proves(apart - truth.distance.lo <= allowed.distance * surely_less));
}

Screened compare(const Distance& said, const Known& truth, const reference::EnclosedPair& pair, const Allowed& allowed,
                 const Card& card) {
  const bool is_apart = truth.verdict == Verdict::separated;
  if (*said.verdict != truth.verdict || is_apart != (*said.distance > 0)) {
    return is_held_to_touching(card) ? Screened::wrong : Screened::open;
  }
  Screened result = within(*said.distance, truth.distance, allowed.distance);
  result = both(result, holds_truth(*said.enclosure, truth.distance, allowed.distance));
  if (truth.verdict == Verdict::overlapping) return result;
  return both(result, witnesses_and_features(said, truth, pair, allowed));
}

}  // namespace

DistanceScreening screen(const Scene& scene, const Answer<Distance>& answer, const Card& card) {
  DistanceScreening screening;
  const auto* said = std::get_if<Distance>(&answer);
  if (said == nullptr || !all_stated(*said) || !finite(*said) || scene.bodies.size() != 2) return screening;
  const Precision precision = precision_for(card, "distance", scene);
  if (!exact_in(scene, precision)) return screening;
  const Allowed allowed{tolerance::distance(scene, precision), tolerance::witness(scene, precision)};
  const reference::EnclosedPair pair(scene);

  const auto compare_with = [&](const Known& truth) {
    screening.verdict = truth.verdict;
    screening.margin = truth.distance.hi / tolerance::scale(scene);
    screening.error =
        std::max(*said->distance - truth.distance.lo, truth.distance.hi - *said->distance) / allowed.distance;
    screening.width = (said->enclosure->hi - said->enclosure->lo) / allowed.distance;
    screening.result = compare(*said, truth, pair, allowed, card);
  };
  if (const std::optional<reference::EnclosedDistance> known = pair.distance())
    compare_with({known->verdict, known->distance});
  if (screening.result == Screened::open) {
    screening.by_exact_truth = true;
    const reference::DistanceTruth& exact = truth::distance(scene);
    compare_with({exact.verdict, exact.distance});
  }
  const bool grants_more = !(card.distance_tolerance == DistanceTolerance{});
  if (screening.result == Screened::wrong && grants_more) screening.result = Screened::open;
  return screening;
}

}  // namespace touchstone::oracle::judge
