#include "model/source_text.h"

#include "tests/catch.h"

namespace touchstone {
namespace {

std::string place(std::string_view json, const std::string& message) {
  const std::string all = located(InputError("", message), json, "f.json").what();
  REQUIRE(all.ends_with(": " + message));
  return all.substr(0, all.size() - message.size() - 2);
}

TEST_CASE("a complaint about a JSON path has the line and the column of what stands there") {
  const std::string json =
      "{\n"
      "  \"a\": [1, {\"b\": \"},]{\\\"\", \"c\": [10,\n"
      "    20]}],\n"
      "  \"d\": 4, \"unknown.key: \": 5,\n"
      "  \"é\": 1, \"d\": 6\n"
      "}";
  CHECK(place(json, "a: wrong") == "f.json:2:8");
  CHECK(place(json, "a[0]: wrong") == "f.json:2:9");
  CHECK(place(json, "a[1]: wrong") == "f.json:2:12");
  CHECK(place(json, "a[1].b: wrong") == "f.json:2:18");
  CHECK(place(json, "a[1].c[1]: wrong") == "f.json:3:5");
  CHECK(place(json, "a[1] (a name): wrong") == "f.json:2:12");
  CHECK(place(json, "d: wrong") == "f.json:5:16");  // of a key that stands twice the second; é is one column
  CHECK(place(json, "wrong") == "f.json:1:1");
}

TEST_CASE("a complaint about a key has the place of what stands at it, or should") {
  const std::string json = "{\n\"a\": {\n\"odd: key\": 1}}";
  CHECK(place(json, "a: unknown key \"odd: key\"; known are \"b\"") == "f.json:3:13");
  CHECK(place(json, "a: the key \"b\" is missing") == "f.json:2:6");
  CHECK(place(json, "the key \"b\" is missing") == "f.json:1:1");
  CHECK(place(json, "unknown key \"a\"; known are \"b: c\"") == "f.json:2:6");
}

TEST_CASE("a path that leads nowhere counts as far as it leads") {
  const std::string json = "{\"a\":\n[1]}";
  CHECK(place(json, "a[7]: wrong") == "f.json:2:1");
  CHECK(place(json, "a.b: wrong") == "f.json:2:1");
  CHECK(place(json, "b: missing") == "f.json");
  CHECK(place(json, "the ball (1): wrong") == "f.json");
}

TEST_CASE("places are found in text that ends anywhere") {
  const std::string json = "{\"a\": [1, {\"b\": \"\\\"x\", \"c\": [10, 20]}], \"d\": 4}";
  for (std::size_t size = 0; size <= json.size(); ++size) {
    for (const char* path : {"a[1].c[1]: wrong", "d: wrong", "a[1]: the key \"c\" stands twice", "wrong"}) {
      CHECK(place(std::string_view(json).substr(0, size), path).starts_with("f.json"));
    }
  }
}

TEST_CASE("a complaint that quotes much is cut short") {
  const std::string message = located(InputError("", std::string(1'000'000, 'x')), "{}", "f.json").what();
  CHECK(message.size() < 700);
}

}  // namespace
}  // namespace touchstone
