// A line for each query of a long run.
#include "app/trial/query_lines.h"

#include <string>
#include <vector>

#include "tests/catch.h"

namespace touchstone::app {
namespace {

using namespace std::chrono_literals;

TEST_CASE("A query has one line, when its last unit is done") {
  std::vector<std::string> lines;
  QueryLines progress({{"distance", 2}, {"mass", 1}}, 0s, [&](const std::string& line) { lines.push_back(line); });
  progress.step("distance", 24);
  CHECK(lines.empty());
  progress.step("mass", 1);
  progress.step("distance", 6);
  CHECK(lines == std::vector<std::string>{"asked mass: 1 scene, 0:00 since the start",
                                          "asked distance: 30 scenes, 0:00 since the start"});
}

TEST_CASE("A short run has none") {
  std::vector<std::string> lines;
  QueryLines progress({{"mass", 1}}, 1h, [&](const std::string& line) { lines.push_back(line); });
  progress.step("mass", 24);
  CHECK(lines.empty());
}

}  // namespace
}  // namespace touchstone::app
