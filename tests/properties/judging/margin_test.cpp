// No false accusation: an engine whose bodies are rounded by a convex radius, as it declares, holds every property.
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "oracle/subject.h"
#include "oracle/subjects/touchstone/fast.h"
#include "properties/property.h"
#include "properties/scenes/domain.h"
#include "tests/catch.h"

namespace touchstone::properties {
namespace {

using oracle::Card;
using oracle::Subject;

constexpr std::uint64_t scenes_of_a_family = 6;
constexpr double margin = 0x1p-6;  // m

/// Its distance is less by twice the margin, its depth greater by as much, and its witness points are on the rounded
/// bodies.
class RoundedBodies : public Subject {
 public:
  RoundedBodies() {
    card_.name = "rounded bodies";
    card_.answers = {"distance", "penetration"};
    card_.distance_tolerance.margin = margin;
    card_.domain.lengths = {0.5, 64};
    card_.domain.reach = 1000;
  }

  const Card& card() const override { return card_; }

  Answer<Distance> distance(const Scene& scene) override {
    if (is_beyond(scene)) return Abstains{"beyond its domain"};
    const Distance exact = cores(scene);
    const double apart = *exact.distance - 2 * margin;
    if (!(apart > 0)) return Distance{Verdict::overlapping, 0, {}, {}, {}, {}, {}};
    const Vec3 shift = margin * from_B_to_A(exact);
    return Distance{Verdict::separated, apart, *exact.p_WCa - shift, *exact.p_WCb + shift, {}, {}, {}};
  }

  Answer<Penetration> penetration(const Scene& scene) override {
    if (is_beyond(scene)) return Abstains{"beyond its domain"};
    const Distance exact = cores(scene);
    if (*exact.distance > 2 * margin) return Penetration{Verdict::separated, 0, {}};
    if (*exact.distance > 0) return Penetration{Verdict::overlapping, 2 * margin - *exact.distance, from_B_to_A(exact)};
    Answer<Penetration> of_cores = fast_->penetration(scene);
    if (auto* said = std::get_if<Penetration>(&of_cores)) {
      said->verdict = Verdict::overlapping;
      said->depth = said->depth.value_or(0) + 2 * margin;
    }
    return of_cores;
  }

 private:
  /// Laws change scenes: one that scales them is not counted if one of them is beyond the domain.
  bool is_beyond(const Scene& scene) const { return oracle::beyond(card_.domain, scene).has_value(); }
  Distance cores(const Scene& scene) { return std::get<Distance>(fast_->distance(scene)); }
  static Vec3 from_B_to_A(const Distance& exact) { return (*exact.p_WCa - *exact.p_WCb).normalized(); }

  std::unique_ptr<Subject> fast_ = oracle::subjects::make_fast();
  Card card_;
};

TEST_CASE("no false accusation: bodies with a declared convex radius hold every property") {
  RoundedBodies subject;
  int held = 0;
  for (const Property& property : all()) {
    if (property.query != "distance" && property.query != "penetration") continue;
    for (const Family* family : for_query(families(), property.query)) {
      for (std::uint64_t i = 0; i < scenes_of_a_family; ++i) {
        const oracle::Finding found = property.check(draw(*family, 7, i), subject);
        INFO(property.id << ", " << family->id << ' ' << i << ": " << found.observed << " instead of "
                         << found.expected);
        CHECK(!oracle::failed(found));
        if (found.outcome == oracle::Outcome::holds) ++held;
      }
    }
  }
  CHECK(held > 0);
}

}  // namespace
}  // namespace touchstone::properties
