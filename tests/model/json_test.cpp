#include "model/json.h"

#include <cstring>

#include "tests/catch.h"
#include "tests/model/random_scene.h"

namespace touchstone {
namespace {

using tests::Bits;
using namespace std::string_literals;

/// Compares by representation: operator== treats -0 as 0, but a file must preserve it.
template <class T>
bool same_bits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

template <class T>
T through_text(const T& value) {
  return read<T>(parse(json_of(value).dump(), "text"), "value");
}

template <class T>
std::string complaint(const std::string& text) {
  try {
    read<T>(parse(text, "reply"), "result");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST_CASE("any finite double survives text bit for bit") {
  Bits bits(1);
  for (int i = 0; i < 100'000; ++i) {
    const Vec3 v = bits.vec3();
    REQUIRE(same_bits(through_text(v), v));
  }
  for (const double number :
       {-0.0, 5e-324, 2.2250738585072011e-308, 1.7976931348623157e308, -1e308, 0.1, 1e15, 1e16, 9007199254740993.0}) {
    REQUIRE(same_bits(through_text(Vec3(number, -number, 1))[0], number));
  }
}

TEST_CASE("a scene survives text, compact or for people") {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    const Scene scene = tests::random_scene(seed);
    const Scene compact = through_text(scene);
    REQUIRE(compact == scene);
    REQUIRE(json_of(compact).dump() == json_of(scene).dump());  // preserves -0 too
    REQUIRE(text_of(json_of(read<Scene>(parse(text_of(json_of(scene)), ""), ""))) == text_of(json_of(scene)));
  }
}

TEST_CASE("answers survive text") {
  Bits bits(2);
  for (int i = 0; i < 500; ++i) {
    const Interval interval{bits.finite(), bits.finite()};
    const Feature feature{bits.below(9), {bits.below(9), bits.below(9)}};
    const Distance distance{
        static_cast<Verdict>(i % 3), bits.finite(), bits.vec3(), bits.vec3(), feature, feature, interval};
    CHECK(through_text(distance) == distance);
    const Penetration penetration{static_cast<Verdict>(i % 3), bits.finite(), bits.vec3()};
    CHECK(through_text(penetration) == penetration);
    const Impulse impulse{{tests::random_velocity(bits), tests::random_velocity(bits)}, bits.vec3(), bits.finite(), {}};
    CHECK(through_text(impulse) == impulse);
    const Bounds bounds{{bits.vec3(), bits.vec3()}, {bits.vec3(), bits.vec3()}};
    CHECK(through_text(bounds) == bounds);
    const Masses masses{tests::random_mass_properties(bits), std::nullopt};
    CHECK(through_text(masses) == masses);
  }
  CHECK(through_text(Distance{}) == Distance{});
  CHECK(through_text(Penetration{}) == Penetration{});
  CHECK(through_text(Bounds{}).empty());
  CHECK(through_text(Masses{}).empty());
  CHECK(through_text(PairSet{}).empty());
  CHECK(through_text(PairSet{{0, 1}}) == PairSet{{0, 1}});
  CHECK(through_text(PairSet{{0, 1}, {0, 2}, {1, 2}}) == PairSet{{0, 1}, {0, 2}, {1, 2}});
  const PairHistory history{{{{0, 1}}, PairSet{{0, 1}}, PairSet{}}, {{}, {}, {}}, {{{1, 2}}, {}, PairSet{{0, 2}}}};
  CHECK(through_text(history) == history);
  CHECK(through_text(PairHistory{}).empty());
  const Mask mask{"010", "111"};
  const Pixels pixels{{mask, mask}, {mask}, {4, std::pair{1, 0}}, mask, {"000", "000"}};
  CHECK(through_text(pixels) == pixels);
  CHECK(through_text(Pixels{}) == Pixels{});
  CHECK(through_text(TimeOfImpact{}) == TimeOfImpact{});
  const TimeOfImpact hit{TimeOfImpact::Status::hit, 0.1, Interval{0.1, 0.25}, 1e-310};
  CHECK(through_text(hit) == hit);
  const State state{{Vec3(1, -0.0, 3), {1, 2, 3, 4}}, {Vec3(0.1, 0, 0), Vec3(0, 0, 1)}};
  const Event impact{Event::Kind::impact, 0.3, 0, 2, Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 5, 0), state, State{}};
  Event force;
  force.kind = Event::Kind::force;
  force.after_a = state;
  const Trajectory trajectory{
      {{state, State{}}, {State{}, state}}, std::vector{impact, force}, 0.75, "why", ContactSolver{1000, 2, 0x1p-40}};
  CHECK(through_text(trajectory) == trajectory);
  CHECK(through_text(Trajectory{}) == Trajectory{});
}

TEST_CASE("what is not an answer is refused by place") {
  CHECK(complaint<Distance>(R"({"distance": null})") == "result.distance: expected a number, found null");
  CHECK(complaint<Distance>(R"({"distance": "nan"})") == "result.distance: expected a finite number, found \"nan\"");
  CHECK(complaint<Distance>(R"({"distance": "far"})") == "result.distance: expected a number, found a string");
  for (const std::string word : {"NaN", "nan", "-nan", "Infinity", "-Infinity", "inf", "-inf"}) {
    CHECK(complaint<Distance>("{\"distance\": " + word + "}") ==
          "reply:1:14: distance: expected a finite number, found " + word);
  }
  CHECK(complaint<Distance>(R"({"distance": true})") == "result.distance: expected a number, found true");
  CHECK(complaint<Distance>(R"({"depth": 1})").starts_with("result: unknown key \"depth\"; known are \"verdict\", "));
  CHECK(complaint<Distance>(R"({"verdict": "apart"})") ==
        "result.verdict: expected \"separated\", \"touching\" or \"overlapping\", found \"apart\"");
  CHECK(complaint<Distance>(R"({"p_WCa": [1, 2]})") == "result.p_WCa: expected 3 items, found 2");
  CHECK(complaint<Distance>(R"({"p_WCa": [1, 2, {}]})") == "result.p_WCa[2]: expected a number, found an object");
  CHECK(complaint<Distance>(R"({"enclosure": [1]})") == "result.enclosure: expected 2 items, found 1");
  CHECK(complaint<Distance>(R"({"feature_A": {"vertices": []}})") == "result.feature_A: the key \"part\" is missing");
  CHECK(complaint<Distance>(R"({"feature_A": {"part": -1, "vertices": []}})") ==
        "result.feature_A.part: expected an integer from 0 to 2147483647, found -1");
  CHECK(complaint<Distance>("[]") == "result: expected an object, found an array");
  CHECK(complaint<Penetration>(R"({"depth": [1]})") == "result.depth: expected a number, found an array");
  CHECK(complaint<Penetration>("null") == "result: expected an object, found null");
  CHECK(complaint<Bounds>(R"([{"lo": [0, 0, 0]}])") == "result[0]: the key \"hi\" is missing");
  CHECK(complaint<Bounds>("{}") == "result: expected an array, found an object");
  CHECK(complaint<Masses>(R"([null, {"mass": 1}])") == "result[1]: the key \"p_BBcm\" is missing");
  CHECK(complaint<PairHistory>(R"([{"begun": []}])") == "result[0]: the key \"pairs\" is missing");
  CHECK(complaint<PairHistory>(R"([{"pairs": [], "ended": [[1, 0]]}])") ==
        "result[0].ended[0]: expected the smaller index first");
  CHECK(complaint<Impulse>("{}") == "result: the key \"after\" is missing");
  CHECK(complaint<Impulse>(R"({"after": []})") == "result.after: expected 2 items, found 0");
  CHECK(complaint<Pixels>(R"({"sampled": [["012"]]})").starts_with("result"));
  CHECK(complaint<TimeOfImpact>(R"({"meeting": "hit"})") == "result: the key \"meeting\" is \"status\" now");
  CHECK(complaint<Trajectory>(R"({"states": [], "events": [{"kind": "push"}]})") ==
        "result.events[0].kind: the kind \"push\" is \"force\" now");
  CHECK(complaint<PairSet>("[[0, 1.5]]") == "result[0][1]: expected an integer, found 1.5");
  CHECK(complaint<PairSet>("[[0, 4294967297]]") ==
        "result[0][1]: expected an integer from 0 to 2147483647, found 4294967297");
  CHECK(complaint<PairSet>("[[1, 0]]") == "result[0]: expected the smaller index first");
  CHECK(complaint<PairSet>("[[1, 1]]") == "result[0]: expected the smaller index first");
  CHECK(complaint<PairSet>("[[0, 2], [0, 1]]") == "result[1]: expected the pairs sorted, each once");
  CHECK(complaint<PairSet>("[[0, 1], [0, 1]]") == "result[1]: expected the pairs sorted, each once");
}

TEST_CASE("an integer counts as a number when a double holds it exactly") {
  const auto of = [](const std::string& integer) { return complaint<Vec3>("[" + integer + ", 0, 0]"); };
  CHECK(of("9007199254740992") == "accepted");
  CHECK(of("-9007199254740992") == "accepted");
  CHECK(of("18446744073709549568") == "accepted");
  CHECK(of("1180591620717411303424") == "accepted");  // 2^70
  for (const std::string integer : {"9007199254740993", "-9007199254740993", "18446744073709551615",
                                    "9223372036854775807", "18446744073709551617", "-18446744073709551617"}) {
    CHECK(of(integer).ends_with("[0]: the integer " + integer +
                                " is not a double; write it with a decimal point to have it rounded"));
  }
}

TEST_CASE("what is not JSON is refused by line and column") {
  const auto of = [](const std::string& text) {
    try {
      parse(text, "f.json");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  CHECK(of("") == "f.json: empty; expected JSON");
  CHECK(of(" \n\t") == "f.json: empty; expected JSON");
  CHECK(of("[1,\n2").starts_with("f.json:2:2: "));
  CHECK(of("{\"a\": ").starts_with("f.json:1:7: "));
  CHECK(of("{}\n{}").starts_with("f.json:2:1: "));
  CHECK(of("[NaN]") == "f.json:1:2: [0]: expected a finite number, found NaN");
  CHECK(of("{NaN").find("expected a finite number, found NaN") !=
        std::string::npos);  // once a crash, found by libFuzzer
  CHECK(of("[{\"a\":{inf}}]").find("[0].a: expected a finite number, found inf") != std::string::npos);
  CHECK(of("[-Infinity]") == "f.json:1:2: [0]: expected a finite number, found -Infinity");
  CHECK(of("[1e400]") == "f.json:1:2: [0]: too great for a double, found 1e400");
  CHECK(of("{\"a\": [1,\n-1e-400]}") ==
        "f.json:2:1: a[1]: too small for a double, found -1e-400: it would be read as 0");
  CHECK(of("[2e-324]").starts_with("f.json:1:2: [0]: too small for a double"));
  CHECK(of("[1e-320, 3e-324, 0e-999, -0.0]") == "accepted");  // they round to denormals or are 0
  CHECK(of(R"({"a": {"b": 1, "b": 2}})") == "f.json:1:21: a: the key \"b\" stands twice in one object");
  CHECK(of(R"([{"a": 1}, {"a": 1}])") == "accepted");
  CHECK(of("{}\n\0"s) == "f.json:2:1: a NUL byte; expected text");
  CHECK(of("\"\u00e9\u00e9\" x").starts_with("f.json:1:6: "));  // columns count characters
}

TEST_CASE("what is nested deeper than any document is refused while it is read") {
  const auto of = [](const std::string& text) {
    try {
      parse(text, "f.json");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const auto nested = [](std::size_t levels) { return std::string(levels, '[') + std::string(levels, ']'); };
  CHECK(of(nested(16)) == "accepted");
  CHECK(of(nested(17)).ends_with("[0][0]: nested deeper than 16 levels"));
  CHECK(of(nested(100'000)) == of(nested(17)));
  CHECK(of(std::string(100'000, '[')) == of(nested(17)));
  CHECK(complaint<Vec3>(nested(60'000)).ends_with("nested deeper than 16 levels"));
}

TEST_CASE("an object of more keys than any document has is refused") {
  const auto of = [](int keys) {
    std::string text = "{";
    for (int i = 0; i < keys; ++i) text += (i > 0 ? ", \"" : "\"") + std::to_string(i) + "\": 0";
    return text + "}";
  };
  CHECK(parse(of(2101), "").size() == 2101);  // the counts of a property's errors, by all powers of two of doubles
  CHECK_THROWS_WITH(parse(of(2102), "f.json"), "f.json:1:1: more than 2101 keys in one object");
}

TEST_CASE("a complaint is printable and short, whatever it quotes") {
  try {
    parse("\"\xff" + std::string(10'000, 'x'), "f.json");
    FAIL();
  } catch (const InputError& error) {
    const std::string message = error.what();
    CHECK(message.size() < 400);
    CHECK(std::all_of(message.begin(), message.end(), [](char c) { return c >= ' ' && c < 0x7f; }));
  }
}

TEST_CASE("JSON for people puts on one line what fits") {
  CHECK(text_of(Json{{"p", {1.0, 2.0}}}) == "{\"p\":[1.0,2.0]}\n");
  const std::string text = text_of(Json(std::vector<std::vector<int>>(40, {1, 2})));
  CHECK(text.starts_with("[\n  [1,2],\n  [1,2],\n"));
  CHECK(text.ends_with("\n  [1,2]\n]\n"));
}

}  // namespace
}  // namespace touchstone
