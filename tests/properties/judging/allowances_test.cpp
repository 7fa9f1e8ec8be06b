// What each property allows, on the scenes made by hand: a regression pin. An allowance that becomes a thousand times
// wider causes no wrong accusation, so no truthful subject and no canary would show it.
#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <utility>

#include "oracle/with_card.h"
#include "properties/property.h"
#include "tests/catch.h"
#include "tests/properties/generated_page.h"
#include "tests/properties/kills.h"
#include "tests/properties/scenes.h"

using namespace touchstone;

namespace {

/// Truthful answers of a subject that says it computes in binary32.
oracle::WithCard in_single(oracle::Subject& exact) {
  oracle::Card card = exact.card();
  card.precision = oracle::Precision::binary32;
  return {exact, std::move(card)};
}

/// Two digits: the judge's own rounding must not show.
std::string text(double x) {
  char written[32];
  std::snprintf(written, sizeof written, "%.2g", x);
  return written;
}

/// Over the hand-made scenes, for one property and unit.
struct Allowed {
  int holds = 0;
  double least = 0, most = 0;

  void add(double allowed) {
    least = holds == 0 ? allowed : std::min(least, allowed);
    most = std::max(most, allowed);
    ++holds;
  }
};

std::string cells(const properties::Property& property, oracle::Subject& subject) {
  std::map<std::string, Allowed> by_unit;
  int outside = 0;
  for (const Scene& scene : tests::scenes_of(property.query)) {
    const oracle::Finding finding = property.check(scene, subject);
    if (finding.outcome == oracle::Outcome::holds) by_unit[finding.unit].add(finding.allowed);
    if (finding.outcome == oracle::Outcome::outside) ++outside;
  }
  std::string all;
  for (const auto& [unit, allowed] : by_unit) {
    all += (all.empty() ? "" : "; ") + std::to_string(allowed.holds);
    if (allowed.most > 0) all += ": " + text(allowed.least) + " to " + text(allowed.most) + " " + unit;
  }
  return all + " | " + std::to_string(outside);
}

std::string allowances() {
  std::string page =
      "# Allowances\n\n"
      "How much error each property allows on the scenes made by hand (`tests/properties/scenes.cpp` and the files "
      "beside it):\n"
      "the number of scenes on which a truthful subject holds the property, and the least and the greatest allowance "
      "there. The\n"
      "derivations are in `oracle/tolerance/`. This page is a regression pin: a change here changes what the judge\n"
      "forgives, and needs a reason. Made by `tests/properties/judging/allowances_test.cpp`. To make it anew:\n"
      "`TOUCHSTONE_UPDATE=1 ./touchstone test -R \"allowances' page\"`.\n\n"
      "| property | double precision | outside | single precision | outside |\n|---|---|---|---|---|\n";
  const auto exact = tests::truthful();
  oracle::WithCard single = in_single(*exact);
  for (const properties::Property& property : properties::all()) {
    page += "| `" + property.id + "` | " + cells(property, *exact) + " | " + cells(property, single) + " |\n";
  }
  return page;
}

}  // namespace

TEST_CASE("the allowances' page is what the judge allows") {
  const std::string made = allowances();
  CHECK(tests::committed_page("allowances.md", made) == made);
}
