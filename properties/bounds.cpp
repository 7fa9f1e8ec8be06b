// The clauses of docs/spec/bounds.md as executable properties.
#include <algorithm>
#include <cmath>
#include <concepts>
#include <functional>
#include <limits>

#include "oracle/judge/words.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/truth.h"
#include "properties/judging/asking.h"
#include "properties/judging/declared_boxes.h"
#include "properties/queries.h"
#include "properties/transforms/scene.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Subject;
using reference::ExactBox;
using reference::Rational;
namespace judge = oracle::judge;
namespace tolerance = oracle::tolerance;
namespace truth = oracle::truth;
namespace words = oracle::words;

// Queries the subject only if every exact box lies within the range of the subject's precision. Beyond that range no
// finite box contains the body, however careful the arithmetic.
template <std::invocable Ask>
Finding of_sayable(const Scene& scene, Subject& subject, Ask&& ask) {
  return of_scene(scene, subject, [&] {
    const bool single = subject.card().precision == oracle::Precision::binary32;
    const double most = single ? std::numeric_limits<float>::max() : std::numeric_limits<double>::max();
    const auto in_range = [most](const ExactBox& box) {
      return std::ranges::all_of(box.lo, [most](const Rational& x) { return x.enclosure().lo >= -most; }) &&
             std::ranges::all_of(box.hi, [most](const Rational& x) { return x.enclosure().hi <= most; });
    };
    return std::ranges::all_of(truth::bounds(scene), in_range)
               ? ask()
               : judge::outside("an exact box ends beyond the range of the subject's precision");
  });
}

// Fails an answer that does not have one box per body. Passes any other answer to judge_it(const Bounds&).
template <class JudgeIt>
Finding given_boxes(const Scene& scene, Subject& subject, JudgeIt&& judge_it) {
  return judge::given(subject.bounds(scene), [&](const Bounds& said) {
    if (said.size() == scene.bodies.size()) return judge_it(said);
    return judge::wrong(Defect::wrong_box, std::to_string(said.size()) + " boxes", std::to_string(scene.bodies.size()));
  });
}

template <class JudgeIt>
Finding of_boxes(const Scene& scene, Subject& subject, JudgeIt&& judge_it) {
  return of_scene(scene, subject, [&] { return given_boxes(scene, subject, judge_it); });
}

std::string text_of_box(const ExactBox& exact) {
  const auto nearest = [](const std::array<Rational, 3>& p) {
    return Vec3(p[0].nearest(), p[1].nearest(), p[2].nearest());
  };
  return words::text(Aabb{nearest(exact.lo), nearest(exact.hi)});
}

// The signed distances from the six sides of the exact box outward to those of the claimed box. A distance is negative
// where the claimed side cuts into the body.
std::array<Rational, 6> outward(const Aabb& said, const ExactBox& exact) {
  std::array<Rational, 6> gaps;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    gaps[2 * axis] = exact.lo[axis] - Rational(said.lo[i]);
    gaps[2 * axis + 1] = Rational(said.hi[i]) - exact.hi[axis];
  }
  return gaps;
}

// Agreement with the exact answer

// Judges the largest error over all bodies. `excess` reduces the six distances of one box to its error.
// `bodies`: those whose boxes the answer is compared with.
Finding worst_side(const Scene& scene, const Scene& bodies, Subject& subject, double allowed, Defect defect,
                   const std::function<Rational(const std::array<Rational, 6>&)>& excess) {
  return of_boxes(scene, subject, [&](const Bounds& said) {
    const std::vector<ExactBox>& exact = truth::bounds(bodies);
    Rational most;
    std::size_t at = 0;
    for (std::size_t i = 0; i < said.size(); ++i) {
      const Rational off = excess(outward(said[i], exact[i]));
      if (off > most) most = off, at = i;
    }
    return judge::at_most(
        most.enclosure().hi, judge::in_ulps(scene, subject.card(), allowed), defect,
        [&] { return "bodies[" + std::to_string(at) + "]: " + words::text(said[at]); },
        [&] { return text_of_box(exact[at]) + " (nearest doubles)"; });
  });
}

Finding holds_body(const Scene& scene, Subject& subject) {
  Finding finding = worst_side(scene, scene, subject, 0, Defect::wrong_box,
                               [](const std::array<Rational, 6>& gaps) { return -*std::ranges::min_element(gaps); });
  const judge::Allowance rounding =
      judge::in_ulps(scene, subject.card(), tolerance::bounds(scene, subject.card().precision));
  if (finding.outcome == oracle::Outcome::fails && finding.unit == rounding.unit_name) {
    finding.rounding = rounding.bound / rounding.unit;
  }
  return finding;
}

Finding tight(const Scene& scene, Subject& subject) {
  const oracle::Card& card = subject.card();
  return worst_side(scene, boxed(scene, card.boxes), subject,
                    tolerance::bounds(scene, card.precision) + card.broad_phase_margin, Defect::loose_box,
                    [](const std::array<Rational, 6>& gaps) { return *std::ranges::max_element(gaps); });
}

// Laws: how the answer follows a change of the scene

using Change = std::function<Aabb(const Aabb&)>;

double apart(const Aabb& a, const Aabb& b) {
  return std::max((a.lo - b.lo).cwiseAbs().maxCoeff(), (a.hi - b.hi).cwiseAbs().maxCoeff());
}

// Each box is exact to within its tolerance and the declared margin. So the second box equals the transformed first box
// to within the sum of both.
Finding boxes_change(const Scene& before, const std::optional<Scene>& moved, double times, const Change& change,
                     Subject& subject, Defect defect) {
  return of_moved(moved, subject, [&](const Scene& after) {
    return of_boxes(before, subject, [&](const Bounds& first) {
      return given_boxes(after, subject, [&](const Bounds& second) {
        const oracle::Card& card = subject.card();
        const double allowed = times * tolerance::bounds(before, card.precision) +
                               tolerance::bounds(after, card.precision) + (1 + times) * card.broad_phase_margin;
        double most = 0;
        std::size_t at = 0;
        for (std::size_t i = 0; i < second.size(); ++i) {
          const double off = apart(change(first[i]), second[i]);
          if (off > most) most = off, at = i;
        }
        return judge::at_most(
            most, judge::in_ulps(after, card, allowed), defect, [&] { return words::text(second[at]); },
            [&] { return words::text(change(first[at])) + ", transformed from the first box"; });
      });
    });
  });
}

Finding translates(const Scene& scene, Subject& subject) {
  const std::optional<Scene> moved = translated(scene);
  const Vec3 t = moved ? translation_between(scene, *moved) : Vec3::Zero();
  return boxes_change(
      scene, moved, 1,
      [t](const Aabb& box) {
        return Aabb{box.lo + t, box.hi + t};
      },
      subject, Defect::moved_with_frame);
}

Finding turns(const Scene& scene, Subject& subject) {
  return boxes_change(
      scene, turned(scene), 1,
      [](const Aabb& box) {
        return Aabb{turned(box.lo), turned(box.hi)};
      },
      subject, Defect::relabelled);
}

Finding scales(const Scene& scene, Subject& subject) {
  const auto by = [&](int k) {
    const double times = std::ldexp(1.0, k);
    return boxes_change(
        scene, scaled(scene, k), times,
        [times](const Aabb& box) {
          return Aabb{times * box.lo, times * box.hi};
        },
        subject, Defect::scaled);
  };
  const Finding larger = by(20);
  return larger.outcome == oracle::Outcome::holds ? by(-20) : larger;
}

Finding relabels(const Scene& scene, Subject& subject) {
  return boxes_change(
      scene, relabelled(scene), 1, [](const Aabb& box) { return box; }, subject, Defect::relabelled);
}

// The box of a body depends on that body only: reversing the order of the bodies changes no bit of it.
Finding alone(const Scene& scene, Subject& subject) {
  if (scene.bodies.size() < 2) return judge::outside("a scene of one body");
  return of_boxes(scene, subject, [&](const Bounds& said) {
    return given_boxes(swapped(scene), subject, [&](const Bounds& reversed) {
      for (std::size_t i = 0; i < said.size(); ++i) {
        const Aabb& other = reversed[said.size() - 1 - i];
        if (!(said[i] == other)) {
          return judge::wrong(Defect::relabelled, words::text(other) + " with the bodies in reverse",
                              words::text(said[i]));
        }
      }
      return judge::holds();
    });
  });
}

// Robustness and determinism

std::string senseless(const Bounds& said) {
  for (const Aabb& box : said) {
    if ((box.lo.array() > box.hi.array()).any()) return "lo > hi: " + words::text(box);
  }
  return "";
}

Finding lives(const Scene& scene, Subject& subject) {
  return of_sayable(scene, subject, [&] { return survives(&Subject::bounds, scene, subject, senseless); });
}

Finding again(const Scene& scene, Subject& subject) {
  return of_sayable(scene, subject, [&] { return repeats(&Subject::bounds, scene, swapped(scene), subject); });
}

}  // namespace

std::vector<Property> bounds_properties() {
  return {
      {"bounds.holds_body",
       "bounds",
       {"TS-BOUNDS-1"},
       "no point of a body is outside its box, not by one bit",
       holds_body},
      {"bounds.tight",
       "bounds",
       {"TS-BOUNDS-2"},
       "no box is wider than rounding and the declared margin explain",
       tight},
      {"bounds.translated", "bounds", {"TS-BOUNDS-3"}, "translating the world translates the boxes", translates},
      {"bounds.turned", "bounds", {"TS-BOUNDS-3"}, "permuting the world's axes permutes the boxes' axes", turns},
      {"bounds.scaled",
       "bounds",
       {"TS-BOUNDS-4"},
       "scaling all lengths by 2^20 or 2^-20 scales the boxes exactly",
       scales},
      {"bounds.relabelled", "bounds", {"TS-BOUNDS-5"}, "the order of a polytope's vertices changes nothing", relabels},
      {"bounds.alone", "bounds", {"TS-BOUNDS-6"}, "a body's box does not depend on the other bodies", alone},
      {"bounds.survives",
       "bounds",
       {"TS-BOUNDS-7"},
       "every valid scene has an answer: finite boxes with lo ≤ hi",
       lives},
      {"bounds.repeats", "bounds", {"TS-BOUNDS-8"}, "the same query has the same answer, bit for bit", again},
  };
}

}  // namespace touchstone::properties
