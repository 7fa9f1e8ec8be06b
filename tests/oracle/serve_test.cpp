// What a subject's program does with lines that are no good question: it says so, with the place, and lives.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "oracle/process/child_process.h"
#include "oracle/process/pipe.h"
#include "tests/catch.h"

namespace touchstone::oracle {
namespace {

using nlohmann::json;

const std::string turned = R"({"p":[0,0,0],"q":{"w":1,"x":0,"y":0,"z":0}})";
const std::string tetrahedron = R"({"type":"polytope","vertices":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]]})";

std::string body(const std::string& shape, const std::string& pose = turned) {
  return R"({"shape":)" + shape + R"(,"X_WB":)" + pose + "}";
}

std::string ask(const std::string& query, const std::string& bodies, const std::string& rest = "") {
  return R"({"op":"ask","seq":7,"query":")" + query + R"(","scene":{"touchstone":"scene/1","bodies":[)" + bodies + "]" +
         rest + "}}";
}

class Served {
 public:
  explicit Served(const std::string& name) : child_({TOUCHSTONE_SUBJECTS "/touchstone-subject-" + name}) {}

  json said_to(const std::string& line) {
    const auto said = child_.exchange(line + '\n', {30, 300, 1 << 20});
    if (const Breaks* breaks = std::get_if<Breaks>(&said)) FAIL(breaks->how);
    return json::parse(std::get<std::string>(said));
  }

 private:
  ChildProcess child_;
};

TEST_CASE("a subject's program answers a bad line and reads the next") {
  const std::string name = GENERATE(std::string("reference"), std::string("fast"), std::string("fcl.libccd"));
  if (std::ranges::count(subjects_beside(TOUCHSTONE_SUBJECTS), name) == 0) return;  // FCL may not be installed
  CAPTURE(name);
  struct Line {
    std::string text;
    int seq;
    std::string how;
  };
  const std::string unit = R"({"type":"sphere","radius":1})";
  const std::string no_turn = R"({"p":[0,0,0],"q":{"w":0,"x":0,"y":0,"z":0}})";
  const std::string nested = std::string(300, '[') + std::string(300, ']');
  const std::vector<Line> lines = {
      {"garbage", 0, "request:1:1: syntax error"},
      {"", 0, "request: empty"},
      {nested, 0, "request"},
      {R"({"seq":7})", 7, "request: the key \"op\" is missing"},
      {R"({"op":"sing","seq":7})", 7, "request.op: expected one of"},
      {R"({"op":"ask","seq":-7})", 0, "request.seq: expected an integer"},
      {R"({"op":"ask","seq":7,"query":"mass","scene":{}})", 7, "scene: the key \"touchstone\" is missing"},
      {R"({"op":"start","seq":7,"protocol":2})", 7, "request.protocol: expected 1"},
      {ask("mass", body(unit, no_turn)), 7, "scene.bodies[0].X_WB.q: zero"},
      {ask("mass", body(R"({"type":"sphere","radius":-1})")), 7,
       "scene.bodies[0].shape.radius: expected a number above 0"},
      {ask("mass", body(R"({"type":"polytope","vertices":[[0,0,0],[1,0,0],[0,1,0],[1,1,0]]})")), 7,
       "scene.bodies[0].shape.vertices: all in one plane"},
      {ask("mass", body(R"({"type":"polytope","vertices":[[0,0,0],[4,0,0],[0,4,0],[0,0,4],[1,1,1]]})")), 7,
       "scene.bodies[0].shape.vertices[4]: lies inside the hull"},
      {ask("mass",
           body(R"({"type":"compound","parts":[{"X_BP":)" + turned +
                R"(,"shape":{"type":"polytope","vertices":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]],"faces":[[0,1,2]]}}]})")),
       7, "scene.bodies[0].shape.parts[0].shape.faces[0]: no face on the other side of the edge 0-1"},
      {ask("distance", body(unit)), 7, "scene.bodies: the query distance is about bodies 0 and 1: two are needed"},
      {ask("impulse", body(unit) + "," + body(unit)), 7, "scene.contact: missing"},
      {ask("pixel", body(unit)), 7, "scene.raster: missing"},
      {ask("simulation", body(unit)), 7, "scene.motion: missing"}};
  Served served(name);
  for (const Line& line : lines) {
    CAPTURE(line.text);
    const json said = served.said_to(line.text);
    CHECK(said.at("seq") == line.seq);
    CHECK(said.at("breaks").at("kind") == "threw");
    CHECK_THAT(said.at("breaks").at("how").get<std::string>(), Catch::StartsWith(line.how));
  }
  // Faces are derived. A tetrahedron's volume is a sixth.
  const json masses = served.said_to(ask("mass", body(tetrahedron))).at("result");
  CHECK(masses.at(0).at("mass").get<double>() == Approx(1 / 6.0));
}

}  // namespace
}  // namespace touchstone::oracle
