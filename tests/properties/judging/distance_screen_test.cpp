// The screen of distances agrees with the properties that it stands for: it calls no answer right that one of them
// accuses, and none wrong that they do not.
#include "oracle/judge/distance_screen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "oracle/subject.h"
#include "oracle/subjects/touchstone/fast.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/truth.h"
#include "properties/property.h"
#include "properties/scenes/domain.h"
#include "reference/enclosed_distance.h"
#include "tests/catch.h"
#include "tests/properties/fixed_subject.h"

namespace touchstone::properties {
namespace {

using oracle::Precision;
using oracle::judge::screen;
using oracle::judge::Screened;
namespace tolerance = oracle::tolerance;
namespace truth = oracle::truth;

/// Draws of all families of pairs; many are on purpose near another verdict.
void each_scene(const std::function<void(const Scene&)>& see) {
  for (const Family* family : for_query(families(), "distance")) {
    for (std::uint64_t index = 0; index < 4; ++index) {
      const Scene scene = draw(*family, 23, index);
      INFO(family->id << " " << index);
      if (scene.bodies.size() == 2) see(scene);
    }
  }
}

/// Whether a property about one answer fails.
bool is_accused(const Scene& scene, const Answer<Distance>& answer, const oracle::Card& card) {
  tests::FixedSubject subject;
  subject.introduced = card;
  subject.said_distance = answer;
  constexpr std::array about_one_answer = {"verdict",         "value",      "witnesses_on_bodies",
                                           "witnesses_apart", "features",   "enclosure",
                                           "enclosure_tight", "consistent", "survives"};
  return std::ranges::any_of(about_one_answer, [&](const std::string& name) {
    return failed(find("distance." + name).check(scene, subject));
  });
}

TEST_CASE("An enclosure in long doubles holds the exact distance, and its verdict is exact") {
  int decided = 0;
  int all = 0;
  each_scene([&](const Scene& scene) {
    ++all;
    const std::optional<reference::EnclosedDistance> found = reference::EnclosedPair(scene).distance();
    if (!found) return;
    ++decided;
    const reference::DistanceTruth& exact = truth::distance(scene);
    CHECK(found->verdict == exact.verdict);
    CHECK(found->distance.lo <= exact.distance.hi);  // both are rounded outward
    CHECK(found->distance.hi >= exact.distance.lo);
  });
  CHECK(decided > all / 4);  // most drawn pairs touch, or nearly
}

TEST_CASE("Right answers are called right") {
  const auto fast = oracle::subjects::make_fast();
  int right = 0;
  int all = 0;
  each_scene([&](const Scene& scene) {
    const Screened result = screen(scene, fast->distance(scene), fast->card()).result;
    CHECK(result != Screened::wrong);
    ++all;
    right += result == Screened::right ? 1 : 0;
  });
  CHECK(right > all * 9 / 10);
}

/// Screens the answers of `fast` after a change that returns whether it changed something. Returns how many were found
/// wrong by a property.
template <class Change>
int compared(Change&& change) {
  const auto fast = oracle::subjects::make_fast();
  int accused = 0;
  each_scene([&](const Scene& scene) {
    Answer<Distance> answer = fast->distance(scene);
    if (!change(scene, std::get<Distance>(answer))) return;
    const Screened result = screen(scene, answer, fast->card()).result;
    const bool is_wrong = is_accused(scene, answer, fast->card());
    CHECK((result != Screened::right || !is_wrong));
    CHECK((result != Screened::wrong || is_wrong));
    accused += is_wrong ? 1 : 0;
  });
  return accused;
}

TEST_CASE("No wrong distance is called right, by however little it is beyond what is allowed") {
  for (const double side : {-1, 1}) {
    for (const double factor : {1 - 0x1p-5, 1 - 0x1p-30, 1.0, 1 + 0x1p-30, 1 + 0x1p-5}) {
      const int accused = compared([&](const Scene& scene, Distance& said) {
        const Interval exact = truth::distance(scene).distance;
        const double off = factor * tolerance::distance(scene, Precision::binary64);
        said.distance = side > 0 ? exact.hi + off : exact.lo - off;
        return said.verdict == Verdict::separated && *said.distance > 0;
      });
      if (factor < 1 - 0x1p-10) CHECK(accused == 0);  // some ulps of the distance within
      if (factor > 1 + 0x1p-10) CHECK(accused > 0);
    }
  }
}

TEST_CASE("No enclosure without the exact distance is called right") {
  CHECK(compared([](const Scene& scene, Distance& said) {
          said.enclosure->hi = std::nextafter(truth::distance(scene).distance.lo, 0);
          return said.enclosure->hi >= said.enclosure->lo && said.enclosure->hi > 0;
        }) > 0);
  CHECK(compared([](const Scene& scene, Distance& said) {
          said.enclosure->lo = std::nextafter(truth::distance(scene).distance.hi, INFINITY);
          return true;
        }) > 0);
  CHECK(compared([](const Scene& scene, Distance& said) {
          said.enclosure->hi += 3 * tolerance::distance(scene, Precision::binary64);
          return true;
        }) > 0);
}

TEST_CASE("No wrong verdict is called right") {
  for (const Verdict verdict : {Verdict::separated, Verdict::touching, Verdict::overlapping}) {
    CHECK(compared([&](const Scene&, Distance& said) {
            const bool is_other = said.verdict != verdict;
            said.verdict = verdict;
            return is_other;
          }) > 0);
  }
}

TEST_CASE("No wrong witness and no wrong feature is called right") {
  CHECK(compared([](const Scene& scene, Distance& said) {
          if (said.verdict != Verdict::separated) return false;
          const Vec3 away = (*said.p_WCb - *said.p_WCa).stableNormalized();
          const double off = 4 * tolerance::witness(scene, Precision::binary64);
          *said.p_WCa += off * away;
          *said.p_WCb += off * away;
          return true;
        }) > 0);
  CHECK(compared([](const Scene& scene, Distance& said) {
          const auto* polytope = std::get_if<Polytope>(&scene.bodies[0].shape);
          if (polytope == nullptr || !said.feature_A || said.feature_A->vertices.size() != 1) return false;
          int& vertex = said.feature_A->vertices[0];
          vertex = (vertex + 1) % static_cast<int>(polytope->vertices.size());
          return true;
        }) > 0);
  CHECK(compared([](const Scene&, Distance& said) {
          if (!said.feature_A) return false;
          said.feature_A->vertices = {1000};
          return true;
        }) > 0);
}

TEST_CASE("An answer that is not finite, or lacks a part, is left to the properties") {
  const auto fast = oracle::subjects::make_fast();
  each_scene([&](const Scene& scene) {
    Distance said = std::get<Distance>(fast->distance(scene));
    Distance lacking = said;
    lacking.enclosure.reset();
    CHECK(screen(scene, lacking, fast->card()).result == Screened::open);
    said.p_WCa = Vec3::Constant(NAN);
    CHECK(screen(scene, said, fast->card()).result == Screened::open);
    CHECK(screen(scene, Abstains{"no"}, fast->card()).result == Screened::open);
  });
}

}  // namespace
}  // namespace touchstone::properties
