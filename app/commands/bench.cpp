#include "app/commands/bench.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <stdio.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <system_error>

#include "app/benchmarks/bench_plot.h"
#include "app/benchmarks/bench_table.h"
#include "app/benchmarks/first_call_table.h"
#include "app/benchmarks/simulation_page.h"
#include "app/benchmarks/work_precision.h"
#include "app/motion/motion_scenes.h"
#include "app/system/program_folder.h"
#include "app/system/progress.h"
#include "app/system/terminal.h"
#include "app/system/writable.h"
#include "model/input_error.h"
#include "model/json.h"
#include "oracle/process/living_children.h"

extern char** environ;

namespace touchstone::app {
namespace {

namespace fs = std::filesystem;

/// A comparison. It is a program of its own, since it links the engines, and prints CSV.
struct Comparison {
  std::string program;
  int sizes = 0;      ///< how many sizes it measures by default
  int workloads = 0;  ///< how many workloads it measures by default
  std::function<std::string(const std::string& csv)> table;
  std::function<std::string(const std::string& csv)> plot;            ///< none: the table says it all
  std::function<std::string(const std::string& csv)> page = nullptr;  ///< for the documentation; none: written by hand
};

Comparison of_errors(const std::string& program, int sizes, int workloads, const WorkPrecisionWords& words) {
  return {program, sizes, workloads,
          [words](const std::string& csv) { return work_precision_table(work_precision_rows(csv), words); },
          [words](const std::string& csv) { return work_precision_plot(work_precision_rows(csv), words); }};
}

Comparison of_simulations() {
  constexpr int piles = 11;  // tests/bench/simulation/piles.h
  const int scenes = static_cast<int>(motion_scenes().size()) + piles;
  Comparison comparison =
      of_errors("touchstone_simulation_bench", 6, scenes,
                {"steps a second (0: ours, which have none)", "relative, as each scene says", false});
  comparison.page = simulation_page;
  return comparison;
}

const std::map<std::string, Comparison>& registry() {
  static const std::map<std::string, Comparison> comparisons{
      {"broad_phase",
       {"touchstone_broad_phase_bench", 3, 6, [](const std::string& csv) { return bench_table(bench_rows(csv)); },
        [](const std::string& csv) { return bench_plot(bench_rows(csv)); }}},
      {"distance", of_errors("touchstone_distance_bench", 5, 2, {"vertices a body", "ulps of the scene's scale"})},
      {"first_call",
       {"touchstone_first_call_bench", 1, 11,
        [](const std::string& csv) { return first_call_table(first_call_rows(csv)); }, nullptr}},
      {"impulse", of_errors("touchstone_impulse_bench", 1, 7,
                            {"effort: steps, or tolerance", "units of 2^-53, in the energy norm", false})},
      {"pixel", of_errors("touchstone_pixel_bench", 6, 4,
                          {"pixels a metre (masks: side in pixels)", "share of overlapping pairs that is missed"})},
      {"simulation", of_simulations()},
      {"time_of_impact",
       of_errors("touchstone_time_of_impact_bench", 3, 6,
                 {"vertices a body", "s: the width of an enclosure, or the difference from the exact time"})},
  };
  return comparisons;
}

std::string program_of(const std::string& name) {
  const fs::path program = fs::path(benches_folder()) / registry().at(name).program;
  if (!fs::exists(program)) {
    throw InputError("bench " + name, "was not built (" + program.string() +
                                          "). `./touchstone bench` builds it where the engines that it compares are "
                                          "installed");
  }
  return program.string();
}

std::vector<std::string> command(const BenchOptions& options) {
  std::vector<std::string> words = {program_of(options.name), "--rounds", std::to_string(options.rounds)};
  const auto add = [&words](const char* option, const std::vector<std::string>& values) {
    if (!values.empty()) words.insert(words.end(), {option, fmt::format("{}", fmt::join(values, ","))});
  };
  add("--sizes", options.sizes);
  add("--workloads", options.workloads);
  return words;
}

void check_words(const std::vector<std::string>& words, const std::string& place) {
  for (const std::string& word : words) {
    const bool plain = !word.empty() && std::ranges::all_of(word, [](char c) {
      return ('a' <= c && c <= 'z') || ('0' <= c && c <= '9') || c == '_' || c == '-';
    });
    if (!plain) throw InputError(place, "expected a word of a-z, 0-9, _ and -, found \"" + word + "\"");
  }
}

struct Output {
  std::string text;
  int exit_code = 0;
};

/// A program that runs in a process group of its own, and is ended together with ours.
class Program {
 public:
  explicit Program(const std::vector<std::string>& words) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
    out_ = fdopen(ends[0], "r");
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const int error = posix_spawn(&pid_, arguments[0], &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    if (error != 0) throw std::system_error(error, std::generic_category(), words[0]);
    oracle::enter_child(pid_);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  FILE* out() const { return out_; }

  int exit_code() {
    std::fclose(out_);
    siginfo_t info{};
    while (waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOWAIT) != 0 && errno == EINTR) continue;
    oracle::leave_child(pid_);
    int status = 0;
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) continue;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 3;
  }

 private:
  FILE* out_ = nullptr;
  pid_t pid_ = -1;
};

/// Returns the output of the program. Each group of lines about one workload and size is one step of progress.
Output run(const std::vector<std::string>& words, int groups) {
  Progress progress("measuring", groups);
  Program program(words);
  Output output;
  std::string group;
  std::array<char, 4096> buffer{};
  while (fgets(buffer.data(), buffer.size(), program.out()) != nullptr) {
    const std::string text = buffer.data();
    output.text += text;
    const auto second_comma = text.find(',', text.find(',') + 1);
    const std::string here = text.substr(0, second_comma);
    if (!group.empty() && here != group) progress.step(here);
    group = here;
  }
  output.exit_code = program.exit_code();
  return output;
}

}  // namespace

std::vector<std::string> benches() {
  std::vector<std::string> names;
  for (const auto& [name, comparison] : registry()) names.push_back(name);
  return names;
}

int bench(const BenchOptions& options) {
  check_words(options.sizes, "--sizes");
  check_words(options.workloads, "--workloads");
  const auto count = [](const auto& words, int fallback) {
    return words.empty() ? fallback : static_cast<int>(words.size());
  };
  const Comparison& comparison = registry().at(options.name);
  const std::vector<std::string> words = command(options);
  const fs::path folder = options.out;
  fs::create_directories(folder);
  require_writable_folder(options.out, options.out);
  const Output output =
      run(words, count(options.sizes, comparison.sizes) * count(options.workloads, comparison.workloads));
  if (output.exit_code != 0) return output.exit_code;
  const std::string table = comparison.table(output.text);
  const auto write = [&](const char* ending, const std::string& text) {
    write_text((folder / (options.name + ending)).string(), text);
  };
  write(".csv", output.text);
  write(".txt", table);
  if (comparison.plot) write(".svg", comparison.plot(output.text));
  if (comparison.page) write(".md", comparison.page(output.text));
  print_lines(table + '\n');
  print("Written to {}: {}.csv, .txt{}{}\n", options.out, options.name, comparison.plot ? ", .svg" : "",
        comparison.page ? ", .md" : "");
  return 0;
}

}  // namespace touchstone::app
