// The published schema accepts the messages that are exchanged, in both directions, and nothing else.
#include "oracle/process/protocol.h"

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "model/input_error.h"
#include "oracle/process/child_process.h"
#include "oracle/process/pipe.h"
#include "oracle/query.h"
#include "tests/catch.h"

namespace touchstone::oracle {
namespace {

/// "ok" or "bad" for each line.
std::vector<std::string> by_schema(const std::vector<std::string>& lines) {
  const std::string file = "protocol_test_lines." + std::to_string(getpid()) + ".txt";  // CTest runs cases in parallel
  {
    std::ofstream out(file);
    for (const std::string& line : lines) out << line << '\n';
  }
  const std::string command =
      "/usr/bin/python3 '" TOUCHSTONE_SOURCE "/tests/oracle/protocol_schema.py' '" TOUCHSTONE_SOURCE "/docs' < " + file;
  FILE* output = popen(command.c_str(), "r");
  REQUIRE(output != nullptr);
  std::vector<std::string> verdicts;
  char word[16];
  while (std::fscanf(output, "%15s", word) == 1) verdicts.emplace_back(word);
  CHECK(pclose(output) == 0);
  std::filesystem::remove(file);
  return verdicts;
}

Scene scene() {
  Scene made;
  made.name = "a \"sphere\" beside a box";
  for (const Shape& shape : {Shape(Sphere{0.1}), Shape(Box{{1, 2, 3}})}) {
    made.bodies.emplace_back().shape = shape;
    made.bodies.back().X_WB.p_WB.x() = 1.25 * static_cast<double>(made.bodies.size());
  }
  made.frames = {{{0, Pose{}}, {1, Pose{}}}, {}, {{0, {}}}};
  return made;
}

/// The lines of both sides of a complete conversation.
std::vector<std::string> conversation(const std::vector<std::string>& command) {
  ChildProcess child(command);
  std::vector<std::string> lines;
  const auto exchange = [&](std::string question) {
    const auto said = child.exchange(question, {60, 60, 1 << 20});
    REQUIRE(std::holds_alternative<std::string>(said));
    question.pop_back();
    lines.push_back(question);
    lines.push_back(std::get<std::string>(said));
  };
  protocol::Seq seq = 0;
  exchange(protocol::start(++seq));
  for (const std::string& query : query_names()) exchange(protocol::ask(++seq, query, json_of(scene()).dump()));
  lines.push_back(protocol::stop(++seq));
  lines.back().pop_back();
  return lines;
}

TEST_CASE("real traffic in both directions fits the published schema") {
  std::vector<std::string> lines, speakers;
  const auto record = [&](const std::string& name, const std::vector<std::string>& command) {
    for (const std::string& line : conversation(command)) lines.push_back(line);
    speakers.resize(lines.size(), name);
  };
  for (const std::string& name : subjects_beside(TOUCHSTONE_SUBJECTS))
    record(name, {TOUCHSTONE_SUBJECTS "/touchstone-subject-" + name});
  record("python", {"/usr/bin/python3", TOUCHSTONE_SOURCE "/oracle/subjects/python/sphere_engine.py"});
  const std::vector<std::string> verdicts = by_schema(lines);
  REQUIRE(verdicts.size() == lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    INFO(speakers[i] << ": " << lines[i]);
    CHECK(verdicts[i] == "ok");
  }
}

TEST_CASE("the document names every query") {
  const std::string document = read_text(TOUCHSTONE_SOURCE "/docs/protocol.md");
  for (const std::string& query : query_names()) CHECK_THAT(document, Catch::Contains('`' + query + '`'));
}

TEST_CASE("the session in the document is what is really said") {
  std::ifstream document(TOUCHSTONE_SOURCE "/docs/protocol.md");
  ChildProcess child({"/usr/bin/python3", TOUCHSTONE_SOURCE "/oracle/subjects/python/sphere_engine.py"});
  std::vector<std::string> lines;
  std::string said;
  for (std::string line; std::getline(document, line);) {
    if (!line.starts_with("> {") && !line.starts_with("< {")) continue;
    const std::string message = line.substr(2);
    lines.push_back(message);
    if (line[0] == '<') {
      CHECK(message == said);
    } else if (protocol::read_request(message).op != protocol::Request::Op::stop) {
      said = std::get<std::string>(child.exchange(message + '\n', {60, 60, 1 << 20}));
    }
  }
  CHECK(lines.size() == 7);
  CHECK(by_schema(lines) == std::vector<std::string>(lines.size(), "ok"));
}

Event two_bodies() {
  Event event;
  event.kind = Event::Kind::release;
  event.b = 1;
  return event;
}

TEST_CASE("every kind of answer that we write fits the schema") {
  Distance whole;
  whole.verdict = Verdict::touching;
  whole.distance = 0;
  whole.p_WCa = whole.p_WCb = Vec3(1, 2, 3);
  whole.feature_A = whole.feature_B = Feature{0, {1, 2}};
  whole.enclosure = Interval{0, 0};
  std::vector<std::string> lines = {
      protocol::answer(1, json_of(whole)),
      protocol::answer(2, Abstains{"why"}),
      protocol::answer(3, Breaks{Breaks::Kind::threw, "how"}),
      protocol::answer(3, Breaks{Breaks::Kind::refused, "how"}),
      protocol::answer(4, json_of(Masses{std::nullopt, MassProperties{}})),
      protocol::answer(5, json_of(PairSet{{0, 1}})),
      protocol::answer(6, json_of(Bounds{Aabb{}})),
      protocol::answer(8, json_of(PairHistory{{{{0, 1}}, PairSet{{0, 1}}, PairSet{}}, {{}, {}, {}}})),
      protocol::answer(9, json_of(Impulse{{}, Vec3(1, 2, 3), 1e-16, 1e-12})),
      protocol::answer(10, json_of(Pixels{{{"01"}, {"11"}}, {{"11"}, {"11"}}, {1, std::pair{1, 0}}, {"01"}, {"11"}})),
      protocol::answer(11, json_of(TimeOfImpact{TimeOfImpact::Status::hit, 0.5, Interval{0.25, 0.5}, 1e-9})),
      protocol::answer(
          12,
          json_of(Trajectory{{{State{}}}, std::vector{Event{}, two_bodies()}, 0.5, "why", ContactSolver{3, 1, 0.25}})),
      protocol::answer(7, json_of(Penetration{Verdict::overlapping, 1.0, Vec3(0, 0, 1)}))};
  for (std::string& line : lines) line.pop_back();
  CHECK(by_schema(lines) == std::vector<std::string>(lines.size(), "ok"));
}

TEST_CASE("schema and reader refuse the same answers") {
  const std::vector<std::string> lines = {R"({"result":{}})",
                                          R"({"seq":1})",
                                          R"({"seq":1,"result":{},"abstains":"why"})",
                                          R"({"seq":1,"result":{"distance":null}})",
                                          R"({"seq":1,"result":{"distance":"NaN"}})",
                                          R"({"seq":1,"result":{"distanz":1}})",
                                          R"({"seq":1,"result":{"verdict":"near"}})",
                                          R"({"seq":1,"result":{"p_WCa":[1,2]}})",
                                          R"({"seq":1,"abstains":null})",
                                          R"({"seq":1,"breaks":"boom"})",
                                          R"({"seq":1,"breaks":{"kind":"sulked","how":""}})",
                                          R"({"seq":"1","result":{}})",
                                          R"([])"};
  CHECK(by_schema(lines) == std::vector<std::string>(lines.size(), "bad"));
  for (const std::string& line : lines) {
    CAPTURE(line);
    CHECK_THROWS_AS(protocol::read_answer<Distance>(line, 1), InputError);
  }
}

TEST_CASE("an integer in an answer is the double that it reads as") {
  const auto distance = [](const std::string& written) {
    const std::string line = R"({"seq":1,"result":{"distance":)" + written + "}}";
    return std::get<Distance>(protocol::read_answer<Distance>(line, 1)).distance.value();
  };
  // As JSON.stringify writes 2^53 + 2, 2^63, 2^64 + 2^12, 2^69 and the greatest double below 10^21.
  CHECK(distance("9007199254740994") == 0x1p53 + 2);
  CHECK(distance("9223372036854776000") == 0x1p63);
  CHECK(distance("18446744073709556000") == 0x1p64 + 0x1p12);
  CHECK(distance("590295810358705700000") == 0x1p69);
  CHECK(distance("999999999999999900000") == 999999999999999900000.0);
  CHECK(distance("9007199254740993") == 0x1p53);  // to even
  const std::string card =
      R"({"seq":1,"protocol":1,"card":{"name":"n","version":"1","precision":"exact","answers":[],"broad_phase_margin":)";
  CHECK(protocol::read_introduction(card + "590295810358705700000}}", 1).broad_phase_margin == 0x1p69);
  CHECK_THROWS_AS(protocol::read_introduction(card + "-1}}", 1), InputError);
  // A scene means exactly its numbers.
  std::string question = protocol::ask(1, "distance", json_of(scene()).dump());
  question.replace(question.find("1.25"), 4, "9007199254740993");
  CHECK_THROWS_AS(protocol::read_request(question), InputError);
}

TEST_CASE("schema and reader refuse the same introductions") {
  const std::string good =
      R"({"seq":1,"protocol":1,"card":{"name":"n","version":"1","precision":"exact","answers":[]}})";
  CHECK(by_schema({good}) == std::vector<std::string>{"ok"});
  CHECK(protocol::read_introduction(good, 1).precision == Precision::exact);
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    return text.replace(text.find(from), from.size(), to);
  };
  const std::vector<std::string> lines = {changed(R"("protocol":1,)", ""),
                                          changed(R"("protocol":1)", R"("protocol":2)"),
                                          changed("exact", "binary16"),
                                          changed(R"("name":"n",)", ""),
                                          changed("[]", "[1]"),
                                          changed(R"("name")", R"("knows_touching":1,"name")")};
  CHECK(by_schema(lines) == std::vector<std::string>(lines.size(), "bad"));
  for (const std::string& line : lines) {
    CAPTURE(line);
    CHECK_THROWS_AS(protocol::read_introduction(line, 1), InputError);
  }
}

TEST_CASE("a card survives the way") {
  Card card{"n", "1.2", Precision::binary32, {"mass"}, true, 0.05, "about", "home", {{"TS-MASS-1", "what", "link"}}};
  card.domain = {Interval{0.25, 100}, Interval{0, 2000}, 1000, 50, 64, 10, 8, 20, 0.5};
  card.distance_tolerance = {0.5, 0.125, 0.01, 0.02};
  card.contact_tolerance = {0.25, 0.5, 0.125};
  card.boxes = BoxKind::of_turned_box;
  card.precision_of = {{"mass", Precision::binary64}, {"polytope", Precision::binary32}};
  card.dynamics = {Combine::geometric_mean, Combine::max, 1, true, 0.25, 0.5, 100, 47, Sleep{0.1, 0.2, 0.5}};
  card.reproduces = {"mass"};
  card.work_limits = {{"distance", "step", 3, {{"vertices", 0.5}}, 16}, {"mass", "step"}};
  const std::string line = protocol::introduction(9, card);
  const Card read = protocol::read_introduction(line, 9);
  CHECK(protocol::introduction(9, read) == line);
  CHECK(read.deviations.at(0).clause == "TS-MASS-1");
  CHECK(read.domain == card.domain);
  CHECK(read.distance_tolerance == card.distance_tolerance);
  CHECK(read.contact_tolerance == card.contact_tolerance);
  CHECK(read.boxes == card.boxes);
  CHECK(read.precision_of == card.precision_of);
  CHECK(read.dynamics == card.dynamics);
  CHECK(read.reproduces == card.reproduces);
  CHECK(read.work_limits == card.work_limits);
  CHECK(by_schema({line.substr(0, line.size() - 1)}) == std::vector<std::string>{"ok"});
  CHECK_THROWS_WITH(protocol::read_introduction(line, 8), "introduction.seq: not that of the question");
}

TEST_CASE("a question survives the way") {
  const protocol::Request request = protocol::read_request(protocol::ask(7, "distance", json_of(scene()).dump()));
  CHECK(request.op == protocol::Request::Op::ask);
  CHECK(request.seq == 7);
  CHECK(request.query == "distance");
  CHECK(request.scene == scene());
}

TEST_CASE("a request has no further keys") {
  CHECK_NOTHROW(protocol::read_request(R"({"op":"stop","seq":1})"));
  CHECK_THROWS_AS(protocol::read_request(R"({"op":"stop","seq":1,"query":"mass"})"), InputError);
  CHECK_NOTHROW(protocol::read_request(R"({"op":"start","seq":1,"protocol":1})"));
  CHECK_THROWS_AS(protocol::read_request(R"({"op":"start","seq":1,"protocol":1,"query":"mass"})"), InputError);
  CHECK_THROWS_AS(protocol::read_request(R"({"op":"ask","seq":1,"query":"mass","scene":{"bodies":[]},"x":0})"),
                  InputError);
}

TEST_CASE("a request for a snippet and its answer survive the way") {
  const std::string line = protocol::reproduce(7, "distance", json_of(scene()).dump(), "\"1\"");
  const protocol::Request request = protocol::read_request(line);
  CHECK(request.op == protocol::Request::Op::reproduce);
  CHECK(request.query == "distance");
  CHECK(request.scene == scene());
  CHECK(request.expected == "\"1\"");
  const std::string unsaid = protocol::reproduce(7, "distance", json_of(scene()).dump(), "");
  CHECK(protocol::read_request(unsaid).expected.empty());
  CHECK_THROWS(protocol::read_request(R"({"op":"ask","seq":1,"query":"mass","scene":{},"expected":"1"})"));
  const std::string answer = R"({"seq":7,"snippet":"print(\"1\")\n"})";
  CHECK(std::get<std::string>(protocol::read_snippet(answer, 7)) == "print(\"1\")\n");
  CHECK(std::get<Abstains>(protocol::read_snippet(R"({"seq":7,"abstains":"no"})", 7)).why == "no");
  CHECK_THROWS(protocol::read_snippet(R"({"seq":7,"result":{}})", 7));
  CHECK(by_schema({line.substr(0, line.size() - 1), unsaid.substr(0, unsaid.size() - 1), answer}) ==
        std::vector<std::string>(3, "ok"));
}

TEST_CASE("a question about work and its answer survive the way") {
  const std::string line = protocol::work(7, "distance", json_of(scene()).dump());
  const protocol::Request request = protocol::read_request(line);
  CHECK(request.op == protocol::Request::Op::work);
  CHECK(request.query == "distance");
  CHECK(request.scene == scene());
  const std::string answer = protocol::work(7, {{"step", 3}, {"exact", std::uint64_t{1} << 40}});
  CHECK(std::get<Work>(protocol::read_work(answer, 7)) == Work{{"step", 3}, {"exact", std::uint64_t{1} << 40}});
  CHECK(std::get<Abstains>(protocol::read_work(R"({"seq":7,"abstains":"no"})", 7)).why == "no");
  for (const char* counts :
       {"[1]", R"({"step":-1})", R"({"step":0.5})", R"({"step":1e20})", R"({"step":null})", R"({"step":"3"})"}) {
    CHECK_THROWS_AS(protocol::read_work(R"({"seq":7,"work":)" + std::string(counts) + "}", 7), InputError);
  }
  CHECK(by_schema({line.substr(0, line.size() - 1), answer.substr(0, answer.size() - 1)}) ==
        std::vector<std::string>(2, "ok"));
}

TEST_CASE("fast counts its work, and is asked only about what its card promises") {
  PipeSubject fast({TOUCHSTONE_SUBJECTS "/touchstone-subject-fast"});
  const Answer<Work> counted = fast.work("distance", scene());
  CHECK(std::get<Work>(counted).at("descent") == 1);
  CHECK(std::get<Work>(fast.work("distance", scene())) == std::get<Work>(counted));
  PipeSubject reference({TOUCHSTONE_SUBJECTS "/touchstone-subject-reference"});
  CHECK(std::holds_alternative<Abstains>(reference.work("distance", scene())));
}

TEST_CASE("a C++ subject abstains from snippets") {
  ChildProcess child({TOUCHSTONE_SUBJECTS "/touchstone-subject-fast"});
  const auto said = child.exchange(protocol::reproduce(3, "distance", json_of(scene()).dump(), ""), {60, 60, 1 << 20});
  CHECK(std::get<Abstains>(protocol::read_snippet(std::get<std::string>(said), 3)).why == "no snippets");
}

}  // namespace
}  // namespace touchstone::oracle
