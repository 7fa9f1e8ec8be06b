#include "oracle/process/pipe.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <variant>

#include "model/json.h"
#include "oracle/process/protocol.h"

namespace touchstone::oracle {
namespace {

struct Written {
  Scene scene;
  std::string text;
};

/// The texts of the last scenes. Several subjects are asked about a scene and about its images under the laws of a
/// query, of which there are up to two dozen, and writing a scene costs as much as its query. One cache per thread. A
/// restart clears it, so the text never depends on earlier queries: 0 and -0 are equal, but are written differently.
thread_local std::array<Written, 24> memory;
thread_local std::size_t oldest = 0;

const std::string& text_of(const Scene& scene) {
  for (const Written& written : memory) {
    if (!written.text.empty() && written.scene == scene) return written.text;
  }
  Written& written = memory[oldest];
  oldest = (oldest + 1) % memory.size();
  written = {scene, json_of(scene).dump()};
  return written.text;
}

void trace(const PipeLimits& limits, PipeLimits::Way way, std::string_view line) {
  if (limits.trace != nullptr) limits.trace(way, line.ends_with('\n') ? line.substr(0, line.size() - 1) : line);
}

std::string shortened(const std::string& line) {
  constexpr std::size_t longest = 4000;
  return line.size() <= longest ? line : line.substr(0, longest) + " ...";
}

std::variant<std::string, Breaks> exchange(ChildProcess& child, const PipeLimits& limits, const std::string& line,
                                           double cpu_seconds, double wall_seconds) {
  trace(limits, PipeLimits::Way::sent, line);
  auto said = child.exchange(line, {cpu_seconds, wall_seconds, limits.longest_line, limits.given_up});
  if (const std::string* answer = std::get_if<std::string>(&said)) trace(limits, PipeLimits::Way::received, *answer);
  return said;
}

/// The factor of the limits for a query.
double times_of(const std::string& query, const Card& card, const PipeLimits& limits) {
  const bool may_take_long = query == "simulation" || query == "constraint" || card.precision == Precision::exact;
  return may_take_long ? limits.simulation_factor : 1;
}

/// JSON has no NaN: most libraries write null in its place.
std::string with_hint(const std::string& complaint) {
  const bool is_null = complaint.ends_with("expected a number, found null");
  return is_null ? complaint + ", which is how many JSON libraries write NaN and infinity" : complaint;
}

}  // namespace

PipeSubject::PipeSubject(std::vector<std::string> command, PipeLimits limits)
    : command_(std::move(command)), limits_(limits) {
  if (command_.empty()) throw InputError("subject", "an empty command; expected a program and its arguments");
  card_ = start();
}

PipeSubject::~PipeSubject() { restart(); }

Answer<Masses> PipeSubject::mass(const Scene& scene) { return ask<Masses>("mass", scene); }
Answer<Bounds> PipeSubject::bounds(const Scene& scene) { return ask<Bounds>("bounds", scene); }
Answer<PairSet> PipeSubject::broad_phase(const Scene& scene) { return ask<PairSet>("broad_phase", scene); }
Answer<PairHistory> PipeSubject::pair_history(const Scene& scene) { return ask<PairHistory>("pair_history", scene); }
Answer<Distance> PipeSubject::distance(const Scene& scene) { return ask<Distance>("distance", scene); }
Answer<Penetration> PipeSubject::penetration(const Scene& scene) { return ask<Penetration>("penetration", scene); }
Answer<Impulse> PipeSubject::impulse(const Scene& scene) { return ask<Impulse>("impulse", scene); }
Answer<Pixels> PipeSubject::pixel(const Scene& scene) { return ask<Pixels>("pixel", scene); }
Answer<TimeOfImpact> PipeSubject::time_of_impact(const Scene& scene) {
  return ask<TimeOfImpact>("time_of_impact", scene);
}
Answer<Trajectory> PipeSubject::simulation(const Scene& scene) { return ask<Trajectory>("simulation", scene); }
Answer<Trajectory> PipeSubject::constraint(const Scene& scene) { return ask<Trajectory>("constraint", scene); }

void PipeSubject::restart() {
  if (child_) {
    const std::string line = protocol::stop(++seq_);
    trace(limits_, PipeLimits::Way::sent, line);
    child_->say(line);
  }
  child_.reset();
  memory = {};
}

/// The introduction is limited by wall-clock time only: loading is not part of answering, and a large runtime loads for
/// seconds.
Card PipeSubject::start() try {
  seq_ = 0;
  asked_ = 0;
  child_ = std::make_unique<ChildProcess>(command_);
  const auto said = exchange(*child_, limits_, protocol::start(++seq_), limits_.wall_seconds, limits_.wall_seconds);
  if (const Breaks* breaks = std::get_if<Breaks>(&said)) {
    throw InputError("", "did not introduce itself: " + breaks->how);
  }
  const std::string& line = std::get<std::string>(said);
  try {
    return protocol::read_introduction(line, seq_);
  } catch (const InputError& error) {
    throw InputError("", error.what() + ("; expected its card, found the line: " + shortened(line)));
  }
} catch (const InputError& error) {
  child_.reset();
  throw InputError(fmt::format("subject \"{}\"", fmt::join(command_, " ")), error.what());
}

/// `write` makes the line of the question from its number, `read` the answer from a line and the number. `times`: of
/// the limits.
template <class T, class Write, class Read>
Answer<T> PipeSubject::answer_to(Write&& write, Read&& read, double times) {
  if (limits_.recycle_after > 0 && asked_ == limits_.recycle_after) restart();
  if (!child_) {
    try {
      start();
    } catch (const InputError& error) {
      return Breaks{Breaks::Kind::crashed, std::string("would not start again: ") + error.what()};
    }
  }
  ++asked_;
  const double cpu_before = child_->cpu_seconds();
  const auto said =
      exchange(*child_, limits_, write(++seq_), times * limits_.cpu_seconds, times * limits_.wall_seconds);
  cpu_seconds_of_answer_ = std::holds_alternative<std::string>(said) ? child_->cpu_seconds() - cpu_before : 0;
  if (const Breaks* breaks = std::get_if<Breaks>(&said)) {
    child_.reset();
    return *breaks;
  }
  try {
    return read(std::get<std::string>(said), seq_);
  } catch (const InputError& error) {
    child_.reset();
    return Breaks{Breaks::Kind::garbage, with_hint(error.what())};
  }
}

template <class T>
Answer<T> PipeSubject::ask(const std::string& query, const Scene& scene) {
  if (std::ranges::count(card_.answers, query) == 0) return Abstains{"no " + query + " query"};
  return answer_to<T>([&](std::int64_t seq) { return protocol::ask(seq, query, text_of(scene)); },
                      protocol::read_answer<T>, times_of(query, card_, limits_));
}

Answer<std::string> PipeSubject::reproduce(const std::string& query, const Scene& scene, const std::string& expected) {
  if (std::ranges::count(card_.reproduces, query) == 0) return Abstains{"no snippets of " + query};
  return answer_to<std::string>(
      [&](std::int64_t seq) { return protocol::reproduce(seq, query, text_of(scene), expected); },
      protocol::read_snippet, 1);
}

Answer<Work> PipeSubject::work(const std::string& query, const Scene& scene) {
  const bool is_offered = std::ranges::count(card_.answers, query) > 0;
  if (!is_offered || std::ranges::count(card_.work_limits, query, &WorkLimit::query) == 0) {
    return Abstains{"does not count the work of " + query};
  }
  return answer_to<Work>([&](std::int64_t seq) { return protocol::work(seq, query, text_of(scene)); },
                         protocol::read_work, times_of(query, card_, limits_));
}

}  // namespace touchstone::oracle
