#include "app/trial/questions.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

#include "tests/catch.h"

namespace touchstone::app {
namespace {

const Effort few{.name = "few",
                 .cases = 200,
                 .cases_alone = 200,
                 .more_impacts = 50,
                 .extreme_cases = 20,
                 .minimise_budget = 10,
                 .mesh_share = 3,
                 .deep_mesh_pairs = 2};

std::vector<Question> questions(const std::string& query, std::uint64_t seed, const MeshSet& set) {
  const Questions asked(query, few, seed, set);
  std::vector<Question> all;
  for (std::size_t k = 0; k < asked.size(); ++k) all.push_back(asked[k]);
  return all;
}

TEST_CASE("Each family of a query gets its share, and a question gives the same scene each time") {
  const MeshSet none;
  const std::vector<Question> asked = questions("distance", 7, none);
  CHECK(asked.size() == 220);
  std::map<std::string, int> shares;
  for (const Question& question : asked) {
    if (question.counts_for_classes) ++shares[question.family];
  }
  for (const auto& [family, share] : shares) CHECK(std::abs(share - 200 / static_cast<int>(shares.size())) <= 1);
  CHECK(asked[100].scene() == asked[100].scene());
  CHECK_FALSE(asked[100].scene() == questions("distance", 8, none)[100].scene());
}

TEST_CASE("There are more impacts, but the laws that ask again are asked of the first cases only") {
  const std::vector<Question> asked = questions("impulse", 7, {});
  CHECK(std::ranges::count_if(asked, &Question::counts_for_classes) == 250);
  const auto asked_under = [&](std::size_t k, const char* id) { return asked[k].asked_under(properties::find(id)); };
  for (const std::size_t k : {0, 199, 200, 249}) {
    CHECK(asked_under(k, "impulse.agrees"));
    CHECK(asked_under(k, "impulse.survives"));
    CHECK(asked_under(k, "impulse.swapped") == (k < 200));
    CHECK(asked_under(k, "impulse.repeats") == (k < 200));
  }
}

TEST_CASE("Extreme scenes are asked only of the properties that want an end and sense") {
  const std::vector<Question> asked = questions("mass", 1, {});
  for (const properties::Property& property : properties::all()) {
    if (property.query != "mass") continue;
    const bool for_sense = property.id == "mass.survives" || property.id == "mass.repeats";
    CHECK(asked.back().asked_under(property) == for_sense);
  }
}

TEST_CASE("Of the queries whose answer is a trajectory fewer scenes are asked") {
  Effort effort = few;
  effort.trajectories.simulations = 90;
  effort.trajectories.constraints = 40;
  effort.trajectories.extreme_cases = 5;
  CHECK(Questions("simulation", effort, 1, {}).size() == 95);
  CHECK(Questions("constraint", effort, 1, {}).size() == 40);  // no extreme ones are drawn
  CHECK(Questions("time_of_impact", effort, 1, {}).size() == 220);
}

TEST_CASE("Drawn and extreme scenes are numbered each from 0") {
  const std::vector<Question> asked = questions("mass", 1, {});
  CHECK(asked[199].number == 199);
  CHECK(asked[200].number == 0);
  CHECK(asked.back().number == 19);
}

MeshSet three_meshes() {
  MeshSet set;
  for (int i = 0; i < 3; ++i) set.meshes.push_back({"mesh", "robot", {}});
  return set;
}

TEST_CASE("Every pair of meshes is asked under the agreements with the truth, and under its share of the laws") {
  const MeshSet set = three_meshes();
  const std::vector<Question> asked = questions("distance", 1, set);
  std::set<std::string> kinds;
  for (std::size_t k = asked.size() - 3; k < asked.size(); ++k) {
    kinds.insert(asked[k].family);
    int laws = 0;
    for (const properties::Property& property : properties::all()) {
      if (property.query != "distance") continue;
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
