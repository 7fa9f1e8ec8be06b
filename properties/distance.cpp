// The clauses of docs/spec/distance.md as executable properties.
#include <algorithm>
#include <cmath>

#include "oracle/judge/words.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/feature_gap.h"
#include "oracle/truth/truth.h"
#include "properties/judging/asking.h"
#include "properties/judging/pair_laws.h"
#include "properties/queries.h"
#include "properties/transforms/scene.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Subject;
namespace judge = oracle::judge;
namespace tolerance = oracle::tolerance;
namespace truth = oracle::truth;
namespace words = oracle::words;

template <class JudgeIt>
Finding of_answer(const Scene& scene, Subject& subject, JudgeIt&& judge_it) {
  return of_pair(scene, subject, [&] { return judge::given(subject.distance(scene), judge_it); });
}

/// m: rounding, and what the subject's card declares.
double allowed_error(const Scene& scene, const oracle::Card& card) {
  return tolerance::distance(scene, card.precision) + card.distance_tolerance.of(truth::distance(scene).distance.lo);
}

// Agreement with the exact answer

Finding verdict(const Scene& scene, Subject& subject) {
  return of_answer(scene, subject, [&](const Distance& said) {
    return said.verdict ? judge::verdict(scene, subject.card(), *said.verdict) : judge::silent("the verdict");
  });
}

Finding value(const Scene& scene, Subject& subject) {
  return of_answer(scene, subject, [&](const Distance& said) {
    if (!said.distance) return judge::silent("the distance");
    const double allowed = allowed_error(scene, subject.card());
    return judge::explained(
        judge::near(*said.distance, truth::distance(scene).distance, judge::in_ulps(scene, subject.card(), allowed),
                    Defect::too_near, Defect::too_far),
        scene);
  });
}

Finding enclosure(const Scene& scene, Subject& subject) {
  return of_answer(scene, subject, [&](const Distance& said) {
    if (!said.enclosure) return judge::silent("an enclosure");
    const Interval exact = truth::distance(scene).distance;
    const double short_by = std::max({said.enclosure->lo - exact.lo, exact.hi - said.enclosure->hi, 0.0});
    return judge::explained(judge::at_most(
                                short_by, judge::in_ulps(scene, subject.card(), 0), Defect::broken_enclosure,
                                [&] { return words::text(*said.enclosure); },
                                [&] { return "an interval that contains " + words::text(exact); }),
                            scene);
  });
}

// The interval [0, ∞) contains every distance, so the width is bounded too. A subject as accurate as
// tolerance::distance can enclose the exact distance by that much on either side.
Finding enclosure_tight(const Scene& scene, Subject& subject) {
  return of_answer(scene, subject, [&](const Distance& said) {
    if (!said.enclosure) return judge::silent("an enclosure");
    const Interval exact = truth::distance(scene).distance;
    const double allowed = exact.hi - exact.lo + 2 * tolerance::distance(scene, subject.card().precision);
    return judge::explained(judge::at_most(
                                said.enclosure->hi - said.enclosure->lo, judge::in_ulps(scene, subject.card(), allowed),
                                Defect::loose_enclosure, [&] { return words::text(*said.enclosure); },
                                [&] { return "an interval hardly wider than " + words::text(exact); }),
                            scene);
  });
}

// Overlapping bodies have no closest pair of points, so witness points have no meaning there.
template <class JudgeIt>
Finding of_witnesses(const Scene& scene, Subject& subject, JudgeIt&& judge_it) {
  return of_answer(scene, subject, [&](const Distance& said) {
    if (truth::distance(scene).verdict == Verdict::overlapping)
      return judge::outside("overlapping bodies have no witnesses");
    if (!said.p_WCa || !said.p_WCb) return judge::silent("witness points");
    return judge::explained(judge_it(*said.p_WCa, *said.p_WCb), scene);
  });
}

Finding witnesses_on_bodies(const Scene& scene, Subject& subject) {
  return of_witnesses(scene, subject, [&](const Vec3& p_WCa, const Vec3& p_WCb) {
    const double off_A = judge::off_body(scene.bodies[0], p_WCa), off_B = judge::off_body(scene.bodies[1], p_WCb);
    const double allowed =
        tolerance::witness(scene, subject.card().precision) + subject.card().distance_tolerance.margin;
    return judge::at_most(
        std::max(off_A, off_B), judge::in_ulps(scene, subject.card(), allowed), Defect::wrong_witness,
        [&] {
          return words::text(p_WCa) + ", " + words::text(off_A) + " off A; " + words::text(p_WCb) + ", " +
                 words::text(off_B) + " off B";
        },
        [] { return std::string("a point of each body"); });
  });
}

Finding witnesses_apart(const Scene& scene, Subject& subject) {
  return of_witnesses(scene, subject, [&](const Vec3& p_WCa, const Vec3& p_WCb) {
    const double allowed = allowed_error(scene, subject.card());
    return judge::near((p_WCa - p_WCb).stableNorm(), truth::distance(scene).distance,
                       judge::in_ulps(scene, subject.card(), allowed), Defect::wrong_witness, Defect::wrong_witness);
  });
}

bool holds_all(const Feature& claimed, const Feature& exact) {
  return claimed.part == exact.part && std::ranges::all_of(exact.vertices, [&](int i) {
           return std::ranges::find(claimed.vertices, i) != claimed.vertices.end();
         });
}

/// m: by how much the body's part is thicker than its core.
double core_radius(const Body& body, int part) {
  const auto* compound = std::get_if<Compound>(&body.shape);
  const auto* ball = compound == nullptr ? std::get_if<Sphere>(&body.shape)
                                         : std::get_if<Sphere>(&compound->parts[static_cast<std::size_t>(part)].shape);
  return ball == nullptr ? 0 : ball->radius;
}

// Parts of different radii may be equally near: the gap of their cores is larger by the difference of the radii.
Finding features(const Scene& scene, Subject& subject) {
  return of_answer(scene, subject, [&](const Distance& said) {
    const reference::DistanceTruth& exact = truth::distance(scene);
    if (exact.verdict == Verdict::overlapping) return judge::outside("overlapping bodies have no closest features");
    if (!said.feature_A || !said.feature_B) return judge::silent("closest features");
    const bool names_all = holds_all(*said.feature_A, exact.feature_A) && holds_all(*said.feature_B, exact.feature_B);
    if (names_all && said.feature_A->vertices.size() < 3 && said.feature_B->vertices.size() < 3) return judge::holds();
    const auto observed = [&] { return words::text(*said.feature_A) + " and " + words::text(*said.feature_B); };
    const auto expected = [&] {
      return "a pair among " + words::text(exact.feature_A) + " and " + words::text(exact.feature_B);
    };
    const auto gap = oracle::feature_gap(scene.bodies[0], *said.feature_A, scene.bodies[1], *said.feature_B);
    if (!gap) return judge::wrong(Defect::wrong_feature, observed() + ", which do not exist", expected());
    const auto radii = [&](const Feature& a, const Feature& b) {
      return core_radius(scene.bodies[0], a.part) + core_radius(scene.bodies[1], b.part);
    };
    const double thicker = radii(*said.feature_A, *said.feature_B) - radii(exact.feature_A, exact.feature_B);
    const double farther = names_all ? 0 : *gap - exact.core_squared.sqrt_enclosure().lo - thicker;
    const double off_face = std::max(oracle::off_one_face(scene.bodies[0], *said.feature_A),
                                     oracle::off_one_face(scene.bodies[1], *said.feature_B));
    const double allowed = tolerance::distance(scene, subject.card().precision);
    return judge::explained(judge::at_most(std::max(farther, off_face), judge::in_ulps(scene, subject.card(), allowed),
                                           Defect::wrong_feature, observed, expected),
                            scene);
  });
}

// Laws: how the answer follows a change of the scene

Finding symmetric(const Scene& scene, Subject& subject) {
  return of_pair(scene, subject,
                 [&] { return distance_unchanged(scene, swapped(scene), 1, subject, Defect::asymmetric); });
}

Finding translates(const Scene& scene, Subject& subject) {
  return of_pair(scene, subject,
                 [&] { return distance_unchanged(scene, translated(scene), 1, subject, Defect::moved_with_frame); });
}

Finding turns(const Scene& scene, Subject& subject) {
  return of_pair(scene, subject,
                 [&] { return distance_unchanged(scene, some_turn(scene), 1, subject, Defect::moved_with_frame); });
}

Finding relabels(const Scene& scene, Subject& subject) {
  return of_pair(scene, subject,
                 [&] { return distance_unchanged(scene, relabelled(scene), 1, subject, Defect::relabelled); });
}

Finding scales(const Scene& scene, Subject& subject) {
  return of_pair(scene, subject, [&] {
    const Finding larger = distance_unchanged(scene, scaled(scene, 20), 0x1p20, subject, Defect::scaled);
    if (larger.outcome != oracle::Outcome::holds) return larger;
    return distance_unchanged(scene, scaled(scene, -20), 0x1p-20, subject, Defect::scaled);
  });
}

// Needs no truth: the distance is positive exactly if the verdict is separated. (A subject with only two verdicts
// cannot report touching; it may answer "separated" with distance 0.)
Finding consistent(const Scene& scene, Subject& subject) {
  return of_answer(scene, subject, [&](const Distance& said) {
    if (!said.verdict || !said.distance) return judge::silent("both verdict and distance");
    const bool apart = *said.verdict == Verdict::separated, may_touch = !judge::is_held_to_touching(subject.card());
    if (apart == (*said.distance > 0) || (apart && may_touch && *said.distance == 0)) return judge::holds();
    return judge::explained(judge::wrong_by(std::abs(*said.distance), judge::in_ulps(scene, subject.card(), 0),
                                            apart ? Defect::too_near : Defect::too_far,
                                            words::text(*said.verdict) + " at distance " + words::text(*said.distance),
                                            "a distance > 0 exactly when separated"),
                            scene);
  });
}

// Robustness and determinism

std::string senseless(const Distance& said) {
  if (said.distance && *said.distance < 0) return "distance " + words::text(*said.distance) + " < 0";
  if (said.enclosure && said.enclosure->lo > said.enclosure->hi)
    return "empty enclosure " + words::text(*said.enclosure);
  return "";
}

Finding lives(const Scene& scene, Subject& subject) {
  return of_pair(scene, subject, [&] { return survives(&Subject::distance, scene, subject, senseless); });
}

Finding again(const Scene& scene, Subject& subject) {
  return of_pair(scene, subject, [&] { return repeats(&Subject::distance, scene, swapped(scene), subject); });
}

}  // namespace

std::vector<Property> distance_properties() {
  return {
      {"distance.verdict", "distance", {"TS-DISTANCE-1"}, "the verdict is exact", verdict},
      {"distance.value", "distance", {"TS-DISTANCE-2"}, "the distance is exact within rounding", value},
      {"distance.witnesses_on_bodies",
       "distance",
       {"TS-DISTANCE-3"},
       "each witness point is on its body",
       witnesses_on_bodies},
      {"distance.witnesses_apart",
       "distance",
       {"TS-DISTANCE-3"},
       "the witness points are as far apart as the bodies",
       witnesses_apart},
      {"distance.features",
       "distance",
       {"TS-DISTANCE-4"},
       "the closest features contain a closest pair of points",
       features},
      {"distance.symmetric",
       "distance",
       {"TS-DISTANCE-6"},
       "swapping the two bodies changes neither the distance nor the verdict",
       symmetric},
      {"distance.translated",
       "distance",
       {"TS-DISTANCE-7"},
       "translating both bodies changes neither the distance nor the verdict",
       translates},
      {"distance.turned",
       "distance",
       {"TS-DISTANCE-7"},
       "rotating the world changes neither the distance nor the verdict",
       turns},
      {"distance.scaled",
       "distance",
       {"TS-DISTANCE-8"},
       "scaling all lengths by 2^20 or 2^-20 scales the distance exactly",
       scales},
      {"distance.relabelled",
       "distance",
       {"TS-DISTANCE-9"},
       "the order of a polytope's vertices changes nothing",
       relabels},
      {"distance.enclosure", "distance", {"TS-DISTANCE-5"}, "the enclosure contains the exact distance", enclosure},
      {"distance.enclosure_tight",
       "distance",
       {"TS-DISTANCE-13"},
       "the enclosure is no wider than rounding explains",
       enclosure_tight},
      {"distance.consistent",
       "distance",
       {"TS-DISTANCE-10"},
       "the distance is positive exactly when the verdict is separated",
       consistent},
      {"distance.survives",
       "distance",
       {"TS-DISTANCE-11"},
       "every valid pair has an answer that is finite and consistent",
       lives},
      {"distance.repeats", "distance", {"TS-DISTANCE-12"}, "the same query has the same answer, bit for bit", again},
  };
}

}  // namespace touchstone::properties
