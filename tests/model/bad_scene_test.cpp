// Each row of bad_scenes.json makes good_scene.json invalid in one place; schema_test.py checks the schema against the
// same rows.
#include "model/json.h"
#include "tests/catch.h"

namespace touchstone {
namespace {

const std::string here = HERE;

std::string complaint(const std::string& text) {
  try {
    scene_from(text, "");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST_CASE("every bad scene is refused with its own message") {
  const Json good = parse(read_text(here + "/good_scene.json"), "good");
  REQUIRE(complaint(good.dump()) == "accepted");
  for (const Json& row : parse(read_text(here + "/bad_scenes.json"), "bad")) {
    const std::string message = complaint(good.patch(Json::array({row.at("patch")})).dump());
    CHECK(message.substr(message.find(' ') + 1) == row.at("message").get<std::string>());  // behind "1:COLUMN: "
  }
}

TEST_CASE("what a scene leaves out has its default") {
  const Scene scene = scene_from(
      R"({"touchstone": "scene/1", "bodies": [{"shape": {"type": "sphere", "radius": 2},
          "X_WB": {"p": [1, 2, 3], "q": {"w": 1, "x": 0, "y": 0, "z": 0}}}]})",
      "");
  const Scene expected{"", {{"", Sphere{2}, {Vec3(1, 2, 3), {1, 0, 0, 0}}, {}, {}, Density{1}}}, Vec3::Zero()};
  CHECK(scene == expected);
}

TEST_CASE("a bad file is named before the place in it") {
  CHECK_THROWS_WITH(scene_from(R"({"touchstone": "scene/1", "bodies": 3})", "a/scene.json"),
                    "a/scene.json:1:37: bodies: expected an array, found 3");
  CHECK_THROWS_WITH(scene_from(R"({"touchstone": "scene/1", "bodies": [{"shape": {"type": "sphere", "radius": -1},
                                   "X_WB": {"p": [0, 0, 0], "q": {"w": 1, "x": 0, "y": 0, "z": 0}}}]})",
                               "a/scene.json"),
                    "a/scene.json:1:77: bodies[0].shape.radius: expected a number above 0, found -1");
}

}  // namespace
}  // namespace touchstone
