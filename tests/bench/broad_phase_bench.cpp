// Our broad phases and others', side by side: CSV of nanoseconds a body and frame. `touchstone bench broad_phase` reads
// it.
//
// touchstone_broad_phase_bench --sizes N[,N…] --workloads NAME[,NAME…] --rounds N
// Contestants play a film, forward and backward without end, in turn: each a round of one film's length, or of as many
// frames as fit a slice of time. The figure is the median of its rounds' CPU time a body and frame. What is timed:
// telling the changed boxes, updating, seeing each pair once. Who cannot enter and play a frame within the budget is
// left out and named.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>
#include <sstream>
#include <stdexcept>

#include "tests/bench/broad_phase/contestant.h"
#include "tests/bench/broad_phase/laws.h"
#include "tests/bench/broad_phase/workload.h"

namespace touchstone::bench {
namespace {

constexpr double slice_seconds = 0.25;
constexpr unsigned budget_seconds = 2;

struct Options {
  std::vector<std::size_t> sizes{1000, 10000, 100000};
  std::vector<std::string> workloads = bench::workloads();
  int rounds = 5;
};

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

/// A contestant and where in the film it is.
class Runner {
 public:
  Runner(const Entrant& entrant, const Film& film)
      : entrant_(entrant), film_(film), contestant_(entrant.enter(film.start, film.world)) {}

  void play_frame() {
    const std::size_t frames = film_.forward.size();
    const Frame& frame = at_ < frames ? film_.forward[at_] : film_.backward[2 * frames - 1 - at_];
    pairs_ += contestant_->pairs_after(frame);
    at_ = (at_ + 1) % (2 * frames);
    ++played_;
  }

  void play_round() {
    const double start = cpu_seconds();
    double used = 0;
    double frames = 0;
    while (frames < static_cast<double>(2 * film_.forward.size()) && used < slice_seconds) {
      play_frame();
      ++frames;
      used = cpu_seconds() - start;
    }
    ns_.push_back(1e9 * used / frames / static_cast<double>(film_.start.size()));
  }

  const Entrant& entrant() const { return entrant_; }
  double ns_per_body_and_frame() const { return median(ns_); }
  double pairs_per_body() const {
    return static_cast<double>(pairs_) / played_ / static_cast<double>(film_.start.size());
  }

 private:
  const Entrant& entrant_;
  const Film& film_;
  std::unique_ptr<Contestant> contestant_;
  std::size_t at_ = 0;
  double played_ = 0;
  std::size_t pairs_ = 0;
  std::vector<double> ns_;
};

/// Tried in a process of its own, which the system ends when the budget is used up.
bool keeps_to_budget(const Entrant& entrant, const Film& film) {
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot fork");
  if (child == 0) {
    const rlimit limit{budget_seconds, budget_seconds};
    setrlimit(RLIMIT_CPU, &limit);
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    Runner(entrant, film).play_frame();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::vector<Entrant> everyone() {
  std::vector<Entrant> all = our_strategies();
  for (const auto& more : {bullet(), fcl_managers(), ode_spaces(), cgal()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

void compare(const std::string& workload, std::size_t bodies, int rounds) {
  const Film film = shoot(workload, bodies, bodies <= 10000 ? 64 : 24);
  const std::vector<Entrant> all = everyone();
  const auto print = [&](const Entrant& entrant, const std::string& rest) {
    std::printf("%s,%zu,%s,%s,%s,%s\n", workload.c_str(), bodies, entrant.name.c_str(), entrant.peer ? "peer" : "ours",
                entrant.law.c_str(), rest.c_str());
  };
  std::vector<Runner> runners;
  for (const Entrant& entrant : all) {
    if (keeps_to_budget(entrant, film))
      runners.emplace_back(entrant, film);
    else
      print(entrant, ",,could not enter and play one frame within " + std::to_string(budget_seconds) + " s");
  }
  for (int round = 0; round < rounds; ++round)
    for (Runner& runner : runners) runner.play_round();
  for (const Runner& runner : runners) {
    std::ostringstream figures;
    figures.precision(4);
    figures << runner.ns_per_body_and_frame() << ',' << runner.pairs_per_body() << ',';
    print(runner.entrant(), figures.str());
  }
  std::fflush(stdout);
}

std::vector<std::string> split(const std::string& word) {
  std::vector<std::string> parts;
  std::istringstream in(word);
  for (std::string part; std::getline(in, part, ',');) parts.push_back(part);
  return parts;
}

std::string known(const std::string& workload) {
  const auto& all = workloads();
  if (std::find(all.begin(), all.end(), workload) != all.end()) return workload;
  std::string names;
  for (const std::string& name : all) names += (names.empty() ? "" : ", ") + name;
  throw std::invalid_argument("no workload " + workload + "; there are " + names);
}

std::size_t number(const std::string& word) {
  std::size_t used = 0;
  const unsigned long n = word.empty() || word[0] == '-' ? 0 : std::stoul(word, &used);
  if (used != word.size() || n < 1 || n > 1'000'000) throw std::invalid_argument("expected a number, found " + word);
  return n;
}

Options read(const std::vector<std::string>& words) {
  Options options;
  for (std::size_t i = 0; i + 1 < words.size(); i += 2) {
    const std::string& value = words[i + 1];
    if (words[i] == "--sizes") {
      options.sizes.clear();
      for (const std::string& n : split(value)) options.sizes.push_back(number(n));
    } else if (words[i] == "--workloads") {
      options.workloads.clear();
      for (const std::string& name : split(value)) options.workloads.push_back(known(name));
    } else if (words[i] == "--rounds") {
      options.rounds = static_cast<int>(number(value));
    } else {
      throw std::invalid_argument("no option " + words[i]);
    }
  }
  return options;
}

void run(const Options& options) {
  std::printf("workload,bodies,name,whose,law,ns_per_body_and_frame,pairs_per_body,left_out\n");
  for (const std::size_t bodies : options.sizes)
    for (const std::string& workload : options.workloads) compare(workload, bodies, options.rounds);
  for (const SwapLaw& law : swap_laws())
    std::printf("swaps.%s,%zu,sweep_and_prune,ours,%s,,%.4f,\n", law.workload.c_str(), law.bodies, law.law.c_str(),
                law.swaps_per_body);
}

}  // namespace
}  // namespace touchstone::bench

int main(int argc, char** argv) {
  try {
    touchstone::bench::run(touchstone::bench::read({argv + 1, argv + argc}));
    return 0;
  } catch (const std::logic_error& error) {
    std::fprintf(stderr, "touchstone: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "touchstone: %s\n", error.what());
    return 3;
  }
}
