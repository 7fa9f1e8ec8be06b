// The judge's known-answer test: does it see another answer, and no other?
#include "app/self_test/self_test.h"

#include <algorithm>
#include <set>
#include <string>

#include "model/json.h"
#include "properties/property.h"
#include "tests/catch.h"

using touchstone::Json;
using touchstone::app::other_answer;
using touchstone::app::OtherAnswer;
using touchstone::app::published_vectors;
using touchstone::app::PublishedVector;

namespace {

/// The first vector of the query, with another value at a place.
std::optional<OtherAnswer> asked_with(const std::string& query, const std::string& place, const Json& value) {
  const auto first = std::ranges::find(published_vectors(), query, &PublishedVector::query);
  REQUIRE(first != published_vectors().end());
  Json json = Json::parse(first->text);
  REQUIRE(json.contains(Json::json_pointer(place)));
  json[Json::json_pointer(place)] = value;
  const std::string text = json.dump();
  return other_answer({query.c_str(), text.c_str()});
}

double published_number(const std::string& query, const std::string& place) {
  const auto first = std::ranges::find(published_vectors(), query, &PublishedVector::query);
  REQUIRE(first != published_vectors().end());
  return Json::parse(first->text).at(Json::json_pointer(place));
}

}  // namespace

TEST_CASE("self-test: each query has published vectors, each once") {
  std::set<std::string> ids;
  std::set<std::string> queries;
  for (const PublishedVector& vector : published_vectors()) {
    const std::string id = Json::parse(vector.text)["id"];
    CHECK(id.starts_with(std::string(vector.query) + '-'));
    CHECK(ids.insert(id).second);
    queries.insert(vector.query);
  }
  const auto& tested = touchstone::properties::tested_queries();
  CHECK(queries == std::set<std::string>(tested.begin(), tested.end()));
}

TEST_CASE("self-test: this build answers each as it was published") {
  CHECK(touchstone::app::other_answers(touchstone::properties::tested_queries(), 1).empty());
}

TEST_CASE("self-test: an answer that differs in one place is named") {
  const auto other = asked_with("distance", "/answer/squared_distance_of_cores/exact", "17");
  REQUIRE(other);
  CHECK(other->id.starts_with("distance-"));
  CHECK(other->place == "answer/squared_distance_of_cores/exact");
  CHECK(other->published == "\"17\"");
  CHECK(asked_with("mass", "/classes", Json::array()));
  CHECK(asked_with("penetration", "/margin", Json::array({0, 1})));
}

TEST_CASE("self-test: an allowance may differ by rounding alone") {
  const std::string place = "/allowed/binary64";
  const double allowed = published_number("distance", place);
  CHECK_FALSE(asked_with("distance", place, allowed * (1 + 1e-12)));
  CHECK(asked_with("distance", place, allowed * (1 + 1e-6)));
  CHECK(asked_with("distance", place, nullptr));
}

TEST_CASE("self-test: a scene on which the query has no answer is named, with the reason") {
  const auto other = asked_with("distance", "/scene/bodies", Json::array());
  REQUIRE(other);
  CHECK(other->place == "answer");
  CHECK_THAT(other->computed, Catch::Contains("bodies"));
}
