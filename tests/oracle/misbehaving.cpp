// A subject that answers every scene with "1 m apart". For the scene named "trap" it does what its first argument says.
#include <unistd.h>
#include <xmmintrin.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <thread>

#include "oracle/process/protocol.h"
#include "oracle/process/serve.h"

namespace touchstone::oracle {
namespace {

const Card card{"misbehaving", "0", Precision::binary64, {"distance"}, false, 0, "", "", {}};

Distance apart(double distance) {
  Distance said;
  said.verdict = Verdict::separated;
  said.distance = distance;
  return said;
}

void spin() {
  for (volatile bool forever = true; forever;) {
  }
}

void flood() {
  const std::string line(9999, 'x');
  for (int i = 0; i < 1000; ++i) std::fprintf(stderr, "%s\n", line.c_str());
}

/// Sets flush-to-zero and denormals-are-zero, as a library built with -ffast-math does.
void flush_denormals() { _mm_setcsr(_mm_getcsr() | 0x8040); }

const std::map<std::string, std::function<Distance()>> tricks = {
    {"none", [] { return apart(1); }},
    {"abort", []() -> Distance { std::fprintf(stderr, "Assertion `it holds' failed.\n"), std::abort(); }},
    {"exit", []() -> Distance { std::_Exit(3); }},
    {"orphan",
     []() -> Distance {
       if (fork() == 0) sleep(1000);
       std::_Exit(3);
     }},
    {"close",
     []() -> Distance {
       for (int fd = 3; fd < 64; ++fd) close(fd);
       spin();
       return {};
     }},
    {"spin", [] { return spin(), apart(1); }},
    {"sleep", [] { return sleep(1000), apart(1); }},
    {"nap", [] { return std::this_thread::sleep_for(std::chrono::milliseconds(300)), apart(1); }},
    {"throw", []() -> Distance { throw std::runtime_error("caught \xff"); }},
    {"throw_int", []() -> Distance { throw 1; }},
    {"print", [] { return std::puts("a library says hello"), std::fflush(stdout), apart(1); }},
    {"flood", [] { return flood(), apart(1); }},
    {"nan", [] { return apart(std::numeric_limits<double>::quiet_NaN()); }},
    {"inf", [] { return apart(std::numeric_limits<double>::infinity()); }},
    {"fast_math", [] { return flush_denormals(), apart(1); }}};

/// What a foreign subject may write in place of {"seq":SEQ,"result":…}.
const std::map<std::string, std::string> texts = {{"wire_words", "hello\n"},
                                                  {"wire_empty", "\n"},
                                                  {"wire_array", "[1]\n"},
                                                  {"wire_bytes", "\xff\xfe\x01\n"},
                                                  {"wire_wrong_seq", R"({"seq":999999,"result":{}})"
                                                                     "\n"},
                                                  {"wire_no_seq", R"({"result":{}})"
                                                                  "\n"},
                                                  {"wire_two_words", R"({"seq":SEQ,"result":{},"abstains":"why"})"
                                                                     "\n"},
                                                  {"wire_nothing", R"({"seq":SEQ})"
                                                                   "\n"},
                                                  {"wire_null", R"({"seq":SEQ,"result":{"distance":null}})"
                                                                "\n"},
                                                  {"wire_text", R"({"seq":SEQ,"result":{"distance":"NaN"}})"
                                                                "\n"},
                                                  {"wire_huge", R"({"seq":SEQ,"result":{"distance":1e999}})"
                                                                "\n"},
                                                  {"wire_unknown_key", R"({"seq":SEQ,"result":{"distanz":1}})"
                                                                       "\n"},
                                                  {"wire_two_answers", R"({"seq":SEQ,"result":{}})"
                                                                       "\n"
                                                                       R"({"seq":SEQ,"result":{}})"
                                                                       "\n"},
                                                  {"wire_truncated", R"({"seq":SEQ,"res)"},
                                                  {"wire_endless", std::string(3000000, ' ')}};

class Misbehaving : public Subject {
 public:
  explicit Misbehaving(std::function<Distance()> trick) : trick_(std::move(trick)) {}
  const Card& card() const override { return oracle::card; }

  /// "count": the number of questions that this process has been asked; "denormal": 1 if half of the least normal
  /// number is not flushed to zero.
  Answer<Distance> distance(const Scene& scene) override {
    ++asked_;
    if (scene.name == "count") return apart(asked_);
    if (scene.name == "abstain") return Abstains{"not today"};
    volatile double least_normal = std::numeric_limits<double>::min();
    if (scene.name == "denormal") return apart(least_normal / 2 > 0 ? 1 : 0);
    return scene.name == "trap" ? trick_() : apart(1);
  }

 private:
  std::function<Distance()> trick_;
  int asked_ = 0;
};

int serve_text(const std::string& text) {
  for (std::string line; std::getline(std::cin, line);) {
    const protocol::Request request = protocol::read_request(line);
    if (request.op == protocol::Request::Op::stop) break;
    std::string answer = protocol::introduction(request.seq, card);
    if (request.op == protocol::Request::Op::ask) {
      answer = request.scene.name == "trap" ? text : protocol::answer(request.seq, json_of(apart(1)));
    }
    if (const auto at = answer.find("SEQ"); at != std::string::npos) answer.replace(at, 3, std::to_string(request.seq));
    std::cout << answer << std::flush;
    if (answer.back() != '\n') return 0;
  }
  return 0;
}

int run(const std::string& mode) {
  if (mode == "start_exit") return std::fputs("no licence found\n", stderr), 4;
  if (mode == "start_words") return std::puts("Welcome!"), 0;
  if (mode == "start_deaf") return fclose(stdin), std::fflush(stdout), pause();
  if (const auto text = texts.find(mode); text != texts.end()) return serve_text(text->second);
  Misbehaving subject(tricks.at(mode));
  return serve(subject);
}

}  // namespace
}  // namespace touchstone::oracle

int main(int, char** argv) { return touchstone::oracle::run(argv[1]); }
