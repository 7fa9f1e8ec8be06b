// The clauses of docs/spec/penetration.md as executable properties.
#include <algorithm>
#include <cmath>

#include "oracle/judge/words.h"
#include "oracle/tolerance/tolerance.h"
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

bool is_compound(const Body& body) { return std::holds_alternative<Compound>(body.shape); }

template <class Ask>
Finding of_convex_pair(const Scene& scene, Subject& subject, Ask&& ask) {
  return of_pair(scene, subject, [&] {
    return std::ranges::any_of(scene.bodies, is_compound)
               ? judge::outside("the depth of a union of parts is not defined here")
               : ask();
  });
}

template <class JudgeIt>
Finding of_answer(const Scene& scene, Subject& subject, JudgeIt&& judge_it) {
  return of_convex_pair(scene, subject, [&] { return judge::given(subject.penetration(scene), judge_it); });
}

/// m: by how much a depth may be off as the subject's card declares.
double declared(const Scene& scene, const oracle::Card& card) {
  return card.distance_tolerance.of(truth::penetration(scene).depth.lo);
}

// Agreement with the exact answer

Finding verdict(const Scene& scene, Subject& subject) {
  return of_answer(scene, subject, [&](const Penetration& said) {
    return said.verdict ? judge::verdict(scene, subject.card(), *said.verdict) : judge::silent("the verdict");
  });
}

Finding depth(const Scene& scene, Subject& subject) {
  return of_answer(scene, subject, [&](const Penetration& said) {
    if (!said.depth) return judge::silent("the depth");
    const double allowed = tolerance::penetration(scene, subject.card().precision) + declared(scene, subject.card());
    return judge::explained(
        judge::near(*said.depth, truth::penetration(scene).depth, judge::in_ulps(scene, subject.card(), allowed),
                    Defect::shallow, Defect::overdeep),
        scene);
  });
}

// A separating direction is defined only for bodies with a common interior.
template <class JudgeIt>
Finding of_direction(const Scene& scene, Subject& subject, JudgeIt&& judge_it) {
  return of_answer(scene, subject, [&](const Penetration& said) {
    if (truth::distance(scene).verdict != Verdict::overlapping) return judge::outside("the bodies do not overlap");
    if (!said.depth || !said.nhat_BA_W) return judge::silent("a depth with its direction");
    return judge::explained(judge_it(*said.depth, *said.nhat_BA_W), scene);
  });
}

Finding separates(const Scene& scene, Subject& subject) {
  return of_direction(scene, subject, [&](double said_depth, const Vec3& nhat_BA_W) {
    const double left = judge::depth_left(scene, said_depth * nhat_BA_W);
    const double allowed = tolerance::separation(scene, subject.card().precision) + declared(scene, subject.card());
    return judge::at_most(
        left, judge::in_ulps(scene, subject.card(), allowed), Defect::wrong_normal,
        [&] {
          return "depth " + words::text(said_depth) + " along " + words::text(nhat_BA_W) + " leaves a depth of " +
                 words::text(left);
        },
        [&] {
          return "depth " + words::text(truth::penetration(scene).depth) + ", for example along " +
                 words::text(truth::penetration(scene).nhat_BA_W);
        });
  });
}

Finding unit_direction(const Scene& scene, Subject& subject) {
  return of_direction(scene, subject, [&](double, const Vec3& nhat_BA_W) {
    const auto precision = subject.card().precision;
    return judge::at_most(
        std::abs(nhat_BA_W.stableNorm() - 1),
        {tolerance::unit_length(precision), oracle::unit_roundoff(precision), "ulps of 1", 0, 1}, Defect::wrong_normal,
        [&] { return words::text(nhat_BA_W) + " of length " + words::text(nhat_BA_W.stableNorm()); },
        [] { return std::string("a unit vector"); });
  });
}

// Laws: how the answer follows a change of the scene

Finding symmetric(const Scene& scene, Subject& subject) {
  return of_convex_pair(scene, subject,
                        [&] { return penetration_unchanged(scene, swapped(scene), 1, subject, Defect::asymmetric); });
}

Finding translates(const Scene& scene, Subject& subject) {
  return of_convex_pair(scene, subject, [&] {
    return penetration_unchanged(scene, translated(scene), 1, subject, Defect::moved_with_frame);
  });
}

Finding turns(const Scene& scene, Subject& subject) {
  return of_convex_pair(scene, subject, [&] {
    return penetration_unchanged(scene, some_turn(scene), 1, subject, Defect::moved_with_frame);
  });
}

Finding relabels(const Scene& scene, Subject& subject) {
  return of_convex_pair(
      scene, subject, [&] { return penetration_unchanged(scene, relabelled(scene), 1, subject, Defect::relabelled); });
}

Finding scales(const Scene& scene, Subject& subject) {
  return of_convex_pair(scene, subject, [&] {
    const Finding larger = penetration_unchanged(scene, scaled(scene, 20), 0x1p20, subject, Defect::scaled);
    if (larger.outcome != oracle::Outcome::holds) return larger;
    return penetration_unchanged(scene, scaled(scene, -20), 0x1p-20, subject, Defect::scaled);
  });
}

// Needs no truth: without overlap the depth is 0.
Finding consistent(const Scene& scene, Subject& subject) {
  return of_answer(scene, subject, [&](const Penetration& said) {
    if (!said.verdict || !said.depth) return judge::silent("both verdict and depth");
    if (*said.verdict == Verdict::overlapping || *said.depth == 0) return judge::holds();
    return judge::explained(
        judge::wrong_by(std::abs(*said.depth), judge::in_ulps(scene, subject.card(), 0), Defect::overdeep,
                        words::text(*said.verdict) + " with depth " + words::text(*said.depth),
                        "depth 0 unless overlapping"),
        scene);
  });
}

// Robustness and determinism

std::string senseless(const Penetration& said) {
  return said.depth && *said.depth < 0 ? "depth " + words::text(*said.depth) + " < 0" : "";
}

Finding lives(const Scene& scene, Subject& subject) {
  return of_convex_pair(scene, subject, [&] { return survives(&Subject::penetration, scene, subject, senseless); });
}

Finding again(const Scene& scene, Subject& subject) {
  return of_convex_pair(scene, subject, [&] { return repeats(&Subject::penetration, scene, swapped(scene), subject); });
}

}  // namespace

std::vector<Property> penetration_properties() {
  return {
      {"penetration.verdict", "penetration", {"TS-PENETRATION-1"}, "the verdict is exact", verdict},
      {"penetration.depth",
       "penetration",
       {"TS-PENETRATION-2"},
       "the depth is the least separating distance within rounding",
       depth},
      {"penetration.separates",
       "penetration",
       {"TS-PENETRATION-3"},
       "moving A by the depth along the direction separates the two",
       separates},
      {"penetration.unit_direction", "penetration", {"TS-PENETRATION-4"}, "the direction has length 1", unit_direction},
      {"penetration.symmetric",
       "penetration",
       {"TS-PENETRATION-5"},
       "swapping the two bodies changes neither depth nor verdict",
       symmetric},
      {"penetration.translated",
       "penetration",
       {"TS-PENETRATION-6"},
       "translating both bodies changes neither depth nor verdict",
       translates},
      {"penetration.turned",
       "penetration",
       {"TS-PENETRATION-6"},
       "rotating the world changes neither depth nor verdict",
       turns},
      {"penetration.scaled",
       "penetration",
       {"TS-PENETRATION-7"},
       "scaling all lengths by 2^20 or 2^-20 scales the depth exactly",
       scales},
      {"penetration.relabelled",
       "penetration",
       {"TS-PENETRATION-8"},
       "the order of a polytope's vertices changes nothing",
       relabels},
      {"penetration.consistent",
       "penetration",
       {"TS-PENETRATION-9"},
       "the depth is 0 unless the verdict is overlapping",
       consistent},
      {"penetration.survives",
       "penetration",
       {"TS-PENETRATION-10"},
       "every valid pair has an answer that is finite and consistent",
       lives},
      {"penetration.repeats",
       "penetration",
       {"TS-PENETRATION-11"},
       "the same query has the same answer, bit for bit",
       again},
  };
}

}  // namespace touchstone::properties
