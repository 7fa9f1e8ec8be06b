#include "oracle/case.h"

#include <cmath>
#include <filesystem>
#include <limits>

#include "model/input_error.h"
#include "tests/catch.h"

namespace touchstone::oracle {
namespace {

Case a_case() {
  Case c;
  c.property = "distance.value";
  c.subject = "some.engine";
  c.family = "boxes.equal_cubes";
  c.seed = std::numeric_limits<std::uint64_t>::max();
  c.index = 9007199254740993;  // 2^53 + 1, which no double holds
  c.scene.bodies.resize(2);
  for (Body& body : c.scene.bodies) body.shape = Box{Vec3(1, 0.1, 5e-324)};
  c.scene.bodies[1].X_WB = {{1e300, -0.1, 1.0 / 3}, {0.1, 3, 0, -1}};
  c.finding.outcome = Outcome::fails;
  c.finding.defect = Defect::too_far;
  c.finding.observed = "distance \"1\"";
  c.finding.expected = "0";
  c.finding.error = std::numeric_limits<double>::infinity();
  c.finding.allowed = 12.5;
  c.finding.unit = "ulps of the scene's scale";
  c.finding.rounding = 208;
  c.finding.relative = HUGE_VAL;
  c.finding.of_body = 0.5;
  c.finding.margin = Interval{0.1, std::numeric_limits<double>::infinity()};
  c.finding.certificate = "a proof";
  c.note = "line one\nline two";
  c.changed = {"all lengths times 2^-20", c.scene};
  c.changed->scene.bodies.pop_back();
  return c;
}

TEST_CASE("A case reads back as it was, bit for bit") {
  const Case c = a_case();
  CHECK(case_from(text_of(json_of(c)), "text") == c);
  CHECK(case_from(json_of(c).dump(), "text") == c);
  Case empty;
  empty.property = "mass.value";
  CHECK(case_from(text_of(json_of(empty)), "text") == empty);
}

TEST_CASE("Every outcome and defect has a name that reads back") {
  for (int i = 0; i <= static_cast<int>(Defect::garbage); ++i) {
    Finding finding;
    finding.defect = static_cast<Defect>(i);
    CHECK(read_finding(json_of(finding), "finding") == finding);
  }
  for (int i = 0; i <= static_cast<int>(Outcome::outside); ++i) {
    Finding finding;
    finding.outcome = static_cast<Outcome>(i);
    CHECK(read_finding(json_of(finding), "finding") == finding);
  }
  Finding unordered;
  unordered.error = std::numeric_limits<double>::quiet_NaN();
  CHECK(std::isnan(read_finding(json_of(unordered), "finding").error));
}

TEST_CASE("A bad case is refused, and the message names the place") {
  const auto refused = [](const char* path, const Json& value) {
    Json json = json_of(a_case());
    json[Json::json_pointer(path)] = value;
    try {
      case_from(json.dump(), "some.json");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  using Catch::Contains;
  CHECK_THAT(refused("/touchstone", "case/2"), Contains("some.json") && Contains("touchstone") && Contains("case/1"));
  CHECK_THAT(refused("/colour", 1), Contains("colour"));
  CHECK_THAT(refused("/seed", -1), Contains("seed"));
  CHECK_THAT(refused("/seed", 1.5), Contains("seed"));
  CHECK_THAT(refused("/index", "1"), Contains("index"));
  CHECK_THAT(refused("/property", 1), Contains("property"));
  CHECK_THAT(refused("/finding/outcome", "fine"), Contains("finding.outcome") && Contains("fine"));
  CHECK_THAT(refused("/finding/defect", "bad"), Contains("finding.defect"));
  CHECK_THAT(refused("/finding/error", "much"), Contains("finding.error"));
  CHECK_THAT(refused("/finding/error", Json()), Contains("finding.error"));
  CHECK_THAT(refused("/finding/margin", {1, 2, 3}), Contains("finding.margin"));
  CHECK_THAT(refused("/finding/colour", 1), Contains("colour"));
  CHECK_THAT(refused("/scene/bodies/1/shape/half_extents/2", 0), Contains("scene.bodies[1].shape.half_extents[2]"));
  CHECK_THAT(refused("/scene/bodies/1/shape/radius", 1), Contains("scene.bodies[1].shape"));
  CHECK_THROWS_AS(case_from("", "some.json"), InputError);
  CHECK_THROWS_AS(case_from("[]", "some.json"), InputError);
  CHECK_THROWS_AS(case_from("{\"touchstone\":\"case/1\"}", "some.json"), InputError);
  const std::string whole = json_of(a_case()).dump();
  for (std::size_t length = 0; length < whole.size(); ++length) {
    REQUIRE_THROWS_AS(case_from(whole.substr(0, length), "some.json"), InputError);
  }
}

TEST_CASE("Cases as files") {
  const std::string path = (std::filesystem::temp_directory_path() / "touchstone_case_test.json").string();
  write_case(a_case(), path);
  CHECK(read_case(path) == a_case());
  std::filesystem::remove(path);
  CHECK_THROWS_AS(read_case(path), InputError);
}

}  // namespace
}  // namespace touchstone::oracle
