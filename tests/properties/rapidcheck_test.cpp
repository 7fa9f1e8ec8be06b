// Laws over all families; a counterexample is shrunk by the minimiser's steps.
#include <rapidcheck.h>

#include "model/json.h"
#include "oracle/minimise/minimise.h"
#include "oracle/truth/truth.h"
#include "properties/scenes/rapidcheck_domain.h"
#include "properties/transforms/scene.h"
#include "tests/catch.h"

namespace touchstone::properties {
namespace {

/// Checks a law on scenes for a query. Returns the shrunk counterexample as JSON, or an empty string.
template <class Law>
std::string counterexample(const std::string& query, int runs, Law&& law) {
  rc::detail::TestParams params;
  params.seed = 20;
  params.maxSuccess = runs;
  std::string smallest;
  const auto result = rc::detail::checkTestable(
      [&] {
        const Scene scene = *scene_for(query);
        if (law(scene)) return;
        smallest = text_of(json_of(scene));
        RC_FAIL("the law does not hold");
      },
      rc::detail::TestMetadata(), params);
  return result.template is<rc::detail::SuccessResult>() ? "" : smallest;
}

TEST_CASE("Swapping the bodies changes neither verdict nor squared distance") {
  const std::string broken = counterexample("distance", 300, [](const Scene& scene) {
    const auto ab = oracle::truth::distance(scene);
    const auto ba = oracle::truth::distance(swapped(scene));
    return ab.verdict == ba.verdict && ab.core_squared == ba.core_squared;
  });
  INFO(broken);
  CHECK(broken.empty());
}

TEST_CASE("The depth is positive exactly when the bodies overlap") {
  const std::string broken = counterexample("penetration", 300, [](const Scene& scene) {
    const auto depth = oracle::truth::penetration(scene);
    return (depth.verdict == Verdict::overlapping) == (depth.depth.hi > 0) &&
           depth.verdict == oracle::truth::distance(scene).verdict;
  });
  INFO(broken);
  CHECK(broken.empty());
}

TEST_CASE("A law that touching breaks shrinks to two small solids with short coordinates") {
  const std::string broken = counterexample("distance", 300, [](const Scene& scene) {
    return scene.bodies.size() != 2 || oracle::truth::distance(scene).verdict != Verdict::touching;
  });
  REQUIRE(!broken.empty());
  INFO(broken);
  const oracle::Size size = oracle::size_of(scene_from(broken, "counterexample"));
  CHECK(size.vertices_per_body_max <= 8);
  CHECK(size.significant_bits_max <= 4);
}

}  // namespace
}  // namespace touchstone::properties
