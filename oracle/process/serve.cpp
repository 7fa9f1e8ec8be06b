#include "oracle/process/serve.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cfenv>
#include <cstdio>
#include <iostream>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <variant>

#include "oracle/process/descriptor.h"
#include "oracle/process/protocol.h"
#include "oracle/process/received_scene.h"

namespace touchstone::oracle {
namespace {

/// Returns a private copy of stdout. Anything else that prints to stdout goes to stderr.
Descriptor private_stdout() {
  Descriptor mine(fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
  if (mine.get() < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) {
    throw std::system_error(errno, std::generic_category(), "stdout");
  }
  return mine;
}

void write_all(const Descriptor& out, const std::string& line) {
  for (std::size_t done = 0; done < line.size();) {
    const ssize_t count = write(out.get(), line.data() + done, line.size() - done);
    if (count < 0 && errno != EINTR) throw std::system_error(errno, std::generic_category(), "stdout");
    if (count > 0) done += static_cast<std::size_t>(count);
  }
}

template <class T>
Answer<Json> in_json(const Answer<T>& answer) {
  if (const T* result = std::get_if<T>(&answer)) return json_of(*result);
  if (const Abstains* abstains = std::get_if<Abstains>(&answer)) return *abstains;
  return std::get<Breaks>(answer);
}

/// A library built with -ffast-math makes the processor flush denormals for the whole process as soon as it is loaded.
Answer<Json> in_default_environment(const AnswerFunction& answer, const Query& query, const Scene& scene) {
  std::fesetenv(FE_DFL_ENV);
  Answer<Json> answered = answer(query, scene);
  std::fesetenv(FE_DFL_ENV);
  return answered;
}

std::string answer_to(protocol::Request request, const AnswerFunction& answer) {
  const Scene scene = received(std::move(request.scene), request.query);
  const Query* query = find_query(request.query);
  if (query == nullptr) return protocol::answer(request.seq, Abstains{"no " + request.query + " query"});
  return std::visit([&](const auto& said) { return protocol::answer(request.seq, said); },
                    in_default_environment(answer, *query, scene));
}

/// The line of what `function` says, as `write` writes it; or that it abstains or breaks.
template <class T, class Function, class Write>
std::string part_for(protocol::Request request, const Function& function, Write&& write) {
  const Scene scene = received(std::move(request.scene), request.query);
  const Answer<T> said = function(request.query, scene);
  if (const T* part = std::get_if<T>(&said)) return write(request.seq, *part);
  if (const auto* abstains = std::get_if<Abstains>(&said)) return protocol::answer(request.seq, *abstains);
  return protocol::answer(request.seq, std::get<Breaks>(said));
}

/// Returns no reply to `stop`. An error in the line becomes an answer, and the next line is read.
std::optional<std::string> reply_to(const std::string& line, const Card& card, const Functions& functions) {
  const auto breaks = [&](const char* how) {
    return protocol::answer(protocol::seq_of(line), Breaks{Breaks::Kind::threw, how});
  };
  try {
    std::fesetenv(FE_DFL_ENV);
    protocol::Request request = protocol::read_request(line);
    switch (request.op) {
      case protocol::Request::Op::stop:
        return std::nullopt;
      case protocol::Request::Op::start:
        return protocol::introduction(request.seq, card);
      case protocol::Request::Op::reproduce: {
        const std::string expected = std::move(request.expected);
        const auto program = [&](const std::string& query, const Scene& scene) {
          return functions.snippet(query, scene, expected);
        };
        return part_for<std::string>(std::move(request), program, protocol::snippet);
      }
      case protocol::Request::Op::work:
        return part_for<Work>(std::move(request), functions.work,
                              [](protocol::Seq seq, const Work& counts) { return protocol::work(seq, counts); });
      case protocol::Request::Op::ask:
        break;
    }
    return answer_to(std::move(request), functions.answer);
  } catch (const std::exception& error) {
    return breaks(error.what());
  } catch (...) {
    return breaks("not a std::exception");
  }
}

constexpr std::size_t longest_question = std::size_t{128} << 20;  // bytes; more than a file of 100 MB, rewritten

/// Returns false at the end of the stream. Of a line that is too long, one byte more than the limit is kept.
bool read_line(std::istream& in, std::string& line) {
  line.clear();
  for (int c = in.rdbuf()->sbumpc(); c != std::char_traits<char>::eof(); c = in.rdbuf()->sbumpc()) {
    if (c == '\n') return true;
    if (line.size() <= longest_question) line += static_cast<char>(c);
  }
  return !line.empty();
}

}  // namespace

void serve(const Card& card, const Functions& functions) {
  const Descriptor out = private_stdout();
  const rlimit no_core_dumps{0, 0};
  setrlimit(RLIMIT_CORE, &no_core_dumps);
  std::ios::sync_with_stdio(false);
  for (std::string line; read_line(std::cin, line);) {
    if (line.size() > longest_question) {
      const std::string how = "request: a line longer than " + std::to_string(longest_question) + " bytes";
      write_all(out, protocol::answer(0, Breaks{Breaks::Kind::threw, how}));
      continue;
    }
    const std::optional<std::string> reply = reply_to(line, card, functions);
    if (!reply) break;
    write_all(out, *reply);
  }
}

int serve(Subject& subject) try {
  serve(subject.card(), {[&](const Query& query, const Scene& scene) {
                           return std::visit([&](auto ask) { return in_json((subject.*ask)(scene)); }, query.ask);
                         },
                         [&](const std::string& query, const Scene& scene, const std::string& expected) {
                           return subject.reproduce(query, scene, expected);
                         },
                         [&](const std::string& query, const Scene& scene) { return subject.work(query, scene); }});
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}

}  // namespace touchstone::oracle
