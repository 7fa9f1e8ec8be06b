// A family at a limit draws both of its sides: which verdicts each must have follows from its sentence.
#include <vector>

#include "oracle/truth/truth.h"
#include "tests/catch.h"
#include "tests/properties/scenes/drawn.h"

using namespace touchstone;

namespace {

Verdict verdict(const Scene& pair) { return oracle::truth::distance(pair).verdict; }

TimeOfImpact::Status outcome(const Scene& motion) { return oracle::truth::time_of_impact(motion).status; }

/// Of 60 scenes each side has at least four.
template <class Side>
void draws_all(const char* family, const std::vector<Side>& sides, Side (*side_of)(const Scene&)) {
  const std::vector<Scene> scenes = tests::drawn(family, 60);
  for (const Side side : sides) {
    INFO(family << ": side " << static_cast<int>(side));
    CHECK(tests::count(scenes, [&](const Scene& scene) { return side_of(scene) == side; }) >= 4);
  }
}

}  // namespace

TEST_CASE("drawn pairs: families of small gaps have pairs that overlap, that touch and that are apart") {
  for (const char* family : {"boxes.dyadic_gap",
                             "boxes.tiny_gap",
                             "touching.dyadic_gap",
                             "touching.tiny_gap",
                             "touching.shifted",
                             "parallel.edges",
                             "slender.needles",
                             "slender.plates",
                             "slender.boxes",
                             "spheres.lattice",
                             "spheres.odd_sums",
                             "hulls.redundant",
                             "compounds.unlike",
                             "compounds.balls",
                             "far.floats",
                             "far.doubles",
                             "ratio.to_2_20",
                             "ratio.to_2_28",
                             "turn.beyond_90",
                             "turn.near_identity",
                             "turn.not_unit",
                             "scale.2_20",
                             "scale.2_40",
                             "scale.2_60",
                             "spheres.on_summit",
                             "spheres.beside_corner",
                             "slender.needle_on_plate"})
    draws_all(family, std::vector{Verdict::overlapping, Verdict::touching, Verdict::separated}, verdict);
}

TEST_CASE("drawn pairs: families of gaps that are never 0 have both signs") {
  for (const char* family : {"touching.relative_gap", "touching.ulps", "parallel.nearly_edges", "parallel.nearly_faces",
                             "parallel.within_ulps", "spheres.within_ulps"})
    draws_all(family, std::vector{Verdict::overlapping, Verdict::separated}, verdict);
  draws_all("compounds.touching_and_overlapping", std::vector{Verdict::overlapping, Verdict::touching}, verdict);
}

TEST_CASE("drawn motions: families of near misses have hits too") {
  for (const char* family :
       {"flights.grazing", "flights.apex", "flights.tangent", "flights.grazing_twice", "flights.turning_points",
        "flights.touching", "flights.late_starts", "flights.needles", "flights.oblique"})
    draws_all(family, std::vector{TimeOfImpact::Status::hit, TimeOfImpact::Status::miss}, outcome);
}
