// Whatever the other process does becomes a verdict, and the run continues.
#include "oracle/process/pipe.h"

#include <sys/personality.h>
#include <sys/wait.h>

#include <cerrno>
#include <filesystem>
#include <thread>

#include "model/input_error.h"
#include "oracle/process/child_process.h"
#include "tests/catch.h"

namespace touchstone::oracle {
namespace {

using Kind = Breaks::Kind;

const std::string program = TOUCHSTONE_MISBEHAVING;

/// One limit at a time, so that the load of the machine changes no verdict.
const PipeLimits short_cpu{.cpu_seconds = 0.2, .wall_seconds = 60};
const PipeLimits short_wall{.cpu_seconds = 60, .wall_seconds = 1};
const PipeLimits short_line{.cpu_seconds = 60, .wall_seconds = 60, .longest_line = 1 << 20};
const PipeLimits patient{.cpu_seconds = 60, .wall_seconds = 60};

PipeSubject misbehaving(const std::string& mode, PipeLimits within = patient) {
  return PipeSubject({program, mode}, within);
}

/// A question about a pair needs two bodies; the misbehaving subject looks at the name only.
Scene scene(const std::string& name) {
  Body ball;
  ball.shape = Sphere{1};
  return {name, {ball, ball}, Vec3::Zero()};
}

double distance(PipeSubject& subject, const std::string& name) {
  const Answer<Distance> answer = subject.distance(scene(name));
  REQUIRE(std::holds_alternative<Distance>(answer));
  return std::get<Distance>(answer).distance.value();
}

Breaks breaks(PipeSubject& subject) {
  const Answer<Distance> answer = subject.distance(scene("trap"));
  REQUIRE(std::holds_alternative<Breaks>(answer));
  return std::get<Breaks>(answer);
}

int open_descriptors() {
  const std::filesystem::directory_iterator open("/proc/self/fd");
  return static_cast<int>(std::distance(begin(open), end(open)));
}

TEST_CASE("a program has its memory at the same addresses each time") {
  const int before = personality(0xffffffff);
  if (personality(static_cast<unsigned long>(before) | ADDR_NO_RANDOMIZE) == -1) return;  // as in some containers
  personality(static_cast<unsigned long>(before));
  const auto addresses = [] {
    ChildProcess child({"/bin/sh", "-c", "read question; cut -d' ' -f1 /proc/self/maps | tr '\\n' ' '; echo"});
    return std::get<std::string>(
        child.exchange("where?\n", {.cpu_seconds = 60, .wall_seconds = 60, .longest_line = 1 << 16}));
  };
  const std::string first = addresses();
  CHECK(first.size() > 100);
  CHECK(addresses() == first);
  CHECK(personality(0xffffffff) == before);
}

TEST_CASE("a well-behaved subject introduces itself and answers") {
  PipeSubject subject = misbehaving("none");
  CHECK(subject.card().name == "misbehaving");
  CHECK(distance(subject, "") == 1);
  CHECK(std::get<Abstains>(subject.distance(scene("abstain"))).why == "not today");
  CHECK(std::get<Abstains>(subject.mass(scene(""))).why == "no mass query");
}

TEST_CASE("each misdeed has its verdict, and the next question is answered") {
  struct Deed {
    const char* mode;
    Kind kind;
    const char* how;
    PipeLimits within = patient;
  };
  const Deed deed = GENERATE(values<Deed>(
      {{"abort", Kind::crashed, "signal 6 (Aborted): Assertion `it holds' failed."},
       {"exit", Kind::crashed, "exit status 3"},
       {"orphan", Kind::crashed, "exit status 3"},
       {"close", Kind::crashed, "it closed its output and went on"},
       {"spin", Kind::hung, "no answer within 0.2 s of its own CPU time", short_cpu},
       {"sleep", Kind::hung, "no answer within 1 s", short_wall},
       {"throw", Kind::threw, "caught \xef\xbf\xbd"},
       {"throw_int", Kind::threw, "not a std::exception"},
       {"nan", Kind::garbage, "result.distance: expected a number, found null"},
       {"inf", Kind::garbage, "result.distance: expected a number, found null"},
       {"wire_words", Kind::garbage, "answer:1:1: syntax error"},
       {"wire_empty", Kind::garbage, "answer: empty"},
       {"wire_array", Kind::garbage, "answer: expected an object"},
       {"wire_bytes", Kind::garbage, "answer:1:"},
       {"wire_wrong_seq", Kind::garbage, "answer.seq: not that of the question"},
       {"wire_no_seq", Kind::garbage, "answer: the key \"seq\" is missing"},
       {"wire_two_words", Kind::garbage, "answer: expected \"seq\" and one of"},
       {"wire_nothing", Kind::garbage, "answer: expected \"seq\" and one of"},
       {"wire_null", Kind::garbage, "result.distance: expected a number, found null, which is how many JSON"},
       {"wire_text", Kind::garbage, "result.distance: expected a finite number, found \"NaN\""},
       {"wire_huge", Kind::garbage, "answer:1:"},
       {"wire_unknown_key", Kind::garbage, "result: unknown key \"distanz\""},
       {"wire_truncated", Kind::crashed, "exit status 0, in the middle of an answer"},
       {"wire_endless", Kind::garbage, "an answer longer than 1048576 bytes", short_line}}));
  CAPTURE(deed.mode);
  const int before = open_descriptors();
  {
    PipeSubject subject = misbehaving(deed.mode, deed.within);
    const Breaks said = breaks(subject);
    CHECK(said.kind == deed.kind);
    CHECK_THAT(said.how, Catch::StartsWith(deed.how));
    CHECK(distance(subject, "") == 1);
    CHECK(breaks(subject) == said);
  }
  CHECK(open_descriptors() == before);
  CHECK(waitpid(-1, nullptr, WNOHANG) == -1);
  CHECK(errno == ECHILD);
}

TEST_CASE("an answer too many is held against the next question") {
  PipeSubject subject = misbehaving("wire_two_answers");
  CHECK(std::holds_alternative<Distance>(subject.distance(scene("trap"))));
  CHECK(std::get<Breaks>(subject.distance(scene(""))).kind == Kind::garbage);
  CHECK(distance(subject, "") == 1);
}

TEST_CASE("what a library prints does no harm") {
  const std::string mode = GENERATE(std::string("print"), std::string("flood"), std::string("nap"));
  PipeSubject subject = misbehaving(mode);
  CHECK(distance(subject, "trap") == 1);
  CHECK(distance(subject, "trap") == 1);
}

TEST_CASE("a sleeping subject does not use up its CPU time") {
  PipeSubject subject = misbehaving("nap", {.cpu_seconds = 0.1, .wall_seconds = 60});
  CHECK(distance(subject, "trap") == 1);
}

TEST_CASE("each question is asked in the default floating-point environment") {
  PipeSubject subject = misbehaving("fast_math");
  CHECK(distance(subject, "denormal") == 1);
  CHECK(distance(subject, "trap") == 1);
  CHECK(distance(subject, "denormal") == 1);
}

TEST_CASE("a fresh process after so many questions, and when asked for") {
  PipeSubject subject = misbehaving("none", {.cpu_seconds = 60, .wall_seconds = 60, .recycle_after = 2});
  for (const double count : {1, 2, 1, 2, 1}) CHECK(distance(subject, "count") == count);
  subject.restart();
  CHECK(distance(subject, "count") == 1);
}

TEST_CASE("a scene larger than any buffer goes through while the subject floods") {
  Scene large = scene("trap");
  for (int i = 0; i < 20000; ++i) large.bodies.emplace_back().shape = Sphere{1.0 / (i + 1)};
  PipeSubject subject = misbehaving("flood");
  CHECK(std::holds_alternative<Distance>(subject.distance(large)));
}

TEST_CASE("threads with a subject each do not disturb one another") {
  const int before = open_descriptors();
  std::vector<std::thread> threads;
  std::vector<int> right(4);
  for (int& count : right) {
    threads.emplace_back([&count] {
      for (int i = 0; i < 10; ++i) {
        PipeSubject subject = misbehaving("abort");
        const bool broke = std::holds_alternative<Breaks>(subject.distance(scene("trap")));
        const bool answered = std::holds_alternative<Distance>(subject.distance(scene("")));
        count += broke && answered;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(right == std::vector<int>(4, 10));
  CHECK(open_descriptors() == before);
}

TEST_CASE("a program that cannot be a subject is bad input") {
  CHECK_THROWS_WITH(PipeSubject({"/nowhere/engine"}),
                    Catch::Contains("/nowhere/engine") && Catch::Contains("cannot be run"));
  CHECK_THROWS_WITH(PipeSubject({program, "start_exit"}), Catch::Contains("exit status 4: no licence found"));
  CHECK_THROWS_WITH(PipeSubject({program, "start_words"}), Catch::Contains("introduction:1:1: "));
  CHECK_THROWS_WITH(PipeSubject({program, "start_deaf"}, short_wall), Catch::Contains("no answer within 1 s"));
  CHECK_THROWS_AS(PipeSubject({"/bin/true"}), InputError);
  CHECK_THROWS_AS(PipeSubject({"/bin/cat"}), InputError);
  CHECK_THROWS_AS(PipeSubject(std::vector<std::string>{}), InputError);
}

TEST_CASE("connectables") {
  CHECK(connect("exec:'" + program + "' none", "")->card().name == "misbehaving");
  CHECK_THROWS_WITH(connect("exec:", ""), Catch::Contains("expected a command line"));
  CHECK_THROWS_WITH(connect("exec:a | b", ""), Catch::Contains("not a plain command line"));
  CHECK_THROWS_WITH(connect("exec:'a", ""), Catch::Contains("not a plain command line"));
  CHECK_THROWS_WITH(connect("bulet", TOUCHSTONE_SUBJECTS),
                    Catch::Contains("\"bulet\": unknown; ") && Catch::Contains("exec:COMMAND LINE"));
  CHECK(subjects_beside("/nowhere").empty());
  for (const std::string& name : subjects_beside(TOUCHSTONE_SUBJECTS)) {
    CHECK(connect(name, TOUCHSTONE_SUBJECTS)->card().name == name);
  }
}

}  // namespace
}  // namespace touchstone::oracle
