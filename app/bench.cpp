#include "app/bench.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <stdio.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>

#include "app/bench_plot.h"
#include "app/bench_table.h"
#include "app/motion_scenes.h"
#include "app/program_folder.h"
#include "app/progress.h"
#include "app/simulation_page.h"
#include "app/work_precision.h"
#include "model/input_error.h"

namespace touchstone::app {
namespace {

namespace fs = std::filesystem;

/// A comparison: a program of its own, since it links the engines. It prints CSV.
struct Comparison {
  std::string program;
  int sizes = 0;      ///< how many it measures if none are named
  int workloads = 0;  ///< likewise
  std::function<std::string(const std::string& csv)> table;
  std::function<std::string(const std::string& csv)> plot;
  std::function<std::string(const std::string& csv)> page = nullptr;  ///< of documents; none: written by hand
};

Comparison of_errors(const std::string& program, int sizes, int workloads, const WorkPrecisionWords& words) {
  return {program, sizes, workloads,
          [words](const std::string& csv) { return work_precision_table(work_precision_rows(csv), words); },
          [words](const std::string& csv) { return work_precision_plot(work_precision_rows(csv), words); }};
}

Comparison of_simulations() {
  const int scenes = static_cast<int>(motion_scenes().size());
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
      {"impulse", of_errors("touchstone_impulse_bench", 1, 7,
                            {"effort: steps, or tolerance", "units of 2^-53, in the energy norm", false})},
      {"pixel", of_errors("touchstone_pixel_bench", 6, 4,
                          {"pixels a metre (masks: side in pixels)", "share of overlapping pairs that is missed"})},
      {"simulation", of_simulations()},
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

/// Words are numbers and names of letters by now, so no shell can be surprised by them.
std::string command(const BenchOptions& options) {
  std::string line = fmt::format("'{}' --rounds {}", program_of(options.name), options.rounds);
  if (!options.sizes.empty()) line += fmt::format(" --sizes {}", fmt::join(options.sizes, ","));
  if (!options.workloads.empty()) line += fmt::format(" --workloads {}", fmt::join(options.workloads, ","));
  return line;
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

/// What the program prints; a step for each group of lines about one workload and size.
Output run(const std::string& line, int groups) {
  Progress progress("measuring", groups);
  FILE* pipe = popen(line.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot start " + line);
  Output output;
  std::string group;
  std::array<char, 4096> buffer{};
  while (fgets(buffer.data(), buffer.size(), pipe) != nullptr) {
    const std::string text = buffer.data();
    output.text += text;
    const auto second_comma = text.find(',', text.find(',') + 1);
    const std::string here = text.substr(0, second_comma);
    if (!group.empty() && here != group) progress.step(here);
    group = here;
  }
  const int status = pclose(pipe);
  output.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 3;
  return output;
}

void write(const fs::path& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  if (!file.flush()) throw InputError(path.string(), "cannot be written");
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
  const Output output =
      run(command(options), count(options.sizes, comparison.sizes) * count(options.workloads, comparison.workloads));
  if (output.exit_code != 0) return output.exit_code;
  const std::string table = comparison.table(output.text);
  const fs::path folder = options.out;
  fs::create_directories(folder);
  write(folder / (options.name + ".csv"), output.text);
  write(folder / (options.name + ".txt"), table);
  write(folder / (options.name + ".svg"), comparison.plot(output.text));
  if (comparison.page) write(folder / (options.name + ".md"), comparison.page(output.text));
  fmt::print("{}\nWritten to {}: {}.csv, .txt, .svg{}\n", table, options.out, options.name,
             comparison.page ? ", .md" : "");
  return 0;
}

}  // namespace touchstone::app
