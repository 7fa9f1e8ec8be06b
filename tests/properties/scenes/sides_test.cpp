// A family at a limit draws both of its sides: which verdicts each must have follows from its sentence.
#include <string>
#include <vector>

#include "oracle/truth/truth.h"
#include "tests/catch.h"
#include "tests/properties/scenes/drawn.h"

using namespace touchstone;

namespace {

std::string verdict(const Scene& pair) {
  const Verdict truth = oracle::truth::distance(pair).verdict;
  return truth == Verdict::separated ? "separated" : truth == Verdict::touching ? "touching" : "overlapping";
}

std::string outcome(const Scene& motion) {
  const TimeOfImpact::Status truth = oracle::truth::time_of_impact(motion).status;
  return truth == TimeOfImpact::Status::hit ? "hit" : truth == TimeOfImpact::Status::miss ? "miss" : "undecided";
}

/// Of 60 scenes each side has at least four.
void draws_all(const char* family, const std::vector<std::string>& sides, std::string (*side_of)(const Scene&)) {
  const std::vector<Scene> scenes = tests::drawn(family, 60);
  for (const std::string& side : sides) {
    INFO(family << ": " << side);
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
    draws_all(family, {"overlapping", "touching", "separated"}, verdict);
}

TEST_CASE("drawn pairs: families of gaps that are never 0 have both signs") {
  for (const char* family : {"touching.relative_gap", "touching.ulps", "parallel.nearly_edges", "parallel.nearly_faces",
                             "parallel.within_ulps", "spheres.within_ulps"})
    draws_all(family, {"overlapping", "separated"}, verdict);
  draws_all("compounds.touching_and_overlapping", {"overlapping", "touching"}, verdict);
}

TEST_CASE("drawn motions: families of near misses have hits too") {
  for (const char* family :
       {"flights.grazing", "flights.apex", "flights.tangent", "flights.grazing_twice", "flights.turning_points",
        "flights.touching", "flights.late_starts", "flights.needles", "flights.oblique"})
    draws_all(family, {"hit", "miss"}, outcome);
}
