#include "app/questions.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

#include "tests/catch.h"

namespace touchstone::app {
namespace {

const Effort few{"few", 200, 200, 5, 20, 10, 3, 2};

TEST_CASE("Each family of a stem gets its share, and a question gives the same scene each time") {
  const MeshSet none;
  const std::vector<Question> asked = questions("distance", few, 7, none);
  CHECK(asked.size() == 220);
  std::map<std::string, int> shares;
  for (const Question& question : asked) {
    if (question.counts_for_classes) ++shares[question.family];
  }
  for (const auto& [family, share] : shares) CHECK(std::abs(share - 200 / static_cast<int>(shares.size())) <= 1);
  CHECK(asked[100].scene() == asked[100].scene());
  CHECK_FALSE(asked[100].scene() == questions("distance", few, 8, none)[100].scene());
}

TEST_CASE("Of impacts no more are asked than their truth's cost allows") {
  const std::vector<Question> asked = questions("impulse", few, 7, {});
  CHECK(std::ranges::count_if(asked, &Question::counts_for_classes) == 5);
}

TEST_CASE("Extreme scenes are asked only of the properties that want an end and sense") {
  const std::vector<Question> asked = questions("mass", few, 1, {});
  for (const properties::Property& property : properties::all()) {
    if (property.stem != "mass") continue;
    const bool for_sense = property.id == "mass.survives" || property.id == "mass.repeats";
    CHECK(asked.back().asked_under(property) == for_sense);
  }
}

MeshSet three_meshes() {
  MeshSet set;
  for (int i = 0; i < 3; ++i) set.meshes.push_back({"mesh", "robot", {}});
  return set;
}

TEST_CASE("Every pair of meshes is asked under the agreements with the truth, and under its share of the laws") {
  const MeshSet set = three_meshes();
  const std::vector<Question> asked = questions("distance", few, 1, set);
  std::set<std::string> kinds;
  for (std::size_t k = asked.size() - 3; k < asked.size(); ++k) {
    kinds.insert(asked[k].family);
    int laws = 0;
    for (const properties::Property& property : properties::all()) {
      if (property.stem != "distance") continue;
      if (compares_with_truth(property)) {
        CHECK(asked[k].asked_under(property));
      } else {
        laws += asked[k].asked_under(property) ? 1 : 0;
      }
    }
    CHECK(laws >= 3);
  }
  CHECK(kinds == std::set<std::string>{"mesh.separated", "mesh.near", "mesh.overlapping"});
}

}  // namespace
}  // namespace touchstone::app
