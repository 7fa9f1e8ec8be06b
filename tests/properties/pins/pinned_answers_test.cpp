// What our own subjects answer about the first scenes of each family, bit for bit, and what work it takes.
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>
#include <variant>

#include "fast/broad_phase/strategies.h"
#include "model/json.h"
#include "oracle/query.h"
#include "oracle/subjects/touchstone/fast.h"
#include "oracle/subjects/touchstone/fast_pairs.h"
#include "oracle/subjects/touchstone/fast_strategies.h"
#include "oracle/subjects/touchstone/reference.h"
#include "properties/scenes/extreme.h"
#include "tests/catch.h"
#include "tests/properties/pins/pinned_page.h"

using namespace touchstone;

namespace {

template <class T>
std::string text(const Answer<T>& answer) {
  if (const auto* abstains = std::get_if<Abstains>(&answer)) return "abstains: " + abstains->why;
  if (const auto* breaks = std::get_if<Breaks>(&answer)) return "breaks: " + breaks->how;
  return json_of(std::get<T>(answer)).dump();
}

std::string answered(oracle::Subject& subject, const oracle::Query& query, const Scene& scene) {
  try {
    return std::visit([&](auto ask) { return text((subject.*ask)(scene)); }, query.ask);
  } catch (const std::exception& error) {
    return std::string("throws: ") + error.what();
  }
}

std::string worked(oracle::Subject& subject, const oracle::Query& query, const Scene& scene) {
  const Answer<oracle::Work> work = subject.work(query.name, scene);
  std::string counts;
  if (const auto* counted = std::get_if<oracle::Work>(&work)) {
    for (const auto& [name, count] : *counted) counts += name + ' ' + std::to_string(count) + ' ';
  }
  return counts;
}

/// How many scenes of a family are asked about: those of motions cost milliseconds.
struct Draws {
  std::uint64_t of_pairs, of_motions;

  std::uint64_t of(const std::string& query) const {
    return query == "simulation" || query == "constraint" ? of_motions : of_pairs;
  }
};

/// For each query and family one line: the digest of the answers, and that of the work, unless the subject counts none.
std::string answers(const std::string& name, oracle::Subject& subject, const std::vector<std::string>& queries,
                    Draws draws) {
  std::string page;
  for (const std::string& asked : queries) {
    const oracle::Query& query = *oracle::find_query(asked);
    const std::string drawn_for = asked == "pair_history" ? "broad_phase" : asked;
    for (const std::vector<properties::Family>* families : {&properties::families(), &properties::extremes()}) {
      for (const properties::Family* family : properties::for_query(*families, drawn_for)) {
        tests::Digest said, work;
        bool counts = false;
        for (std::uint64_t i = 0; i < draws.of(asked); ++i) {
          const Scene scene = properties::draw(*family, 1, i);
          said.add(answered(subject, query, scene));
          const std::string counted = worked(subject, query, scene);
          work.add(counted);
          counts = counts || !counted.empty();
        }
        page += name + ' ' + asked + ' ' + family->id + ' ' + said.text() + (counts ? ' ' + work.text() : "") + '\n';
      }
    }
  }
  return page;
}

/// The same for the named motions in docs/scenes/motion, by name: heaps, arches and tops, which are more than families
/// draw. Of `constraint` without those that take it seconds.
std::string answers_about_motions(oracle::Subject& subject) {
  std::map<std::string, std::string> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(TOUCHSTONE_SOURCE_DIR "/docs/scenes/motion")) {
    if (entry.is_regular_file()) paths[entry.path().stem().string()] = entry.path().string();
  }
  const std::set<std::string> slow = {"arch", "balls_49", "balls_666", "dominoes", "gas"};
  std::string page;
  for (const std::string asked : {"simulation", "constraint"}) {
    const oracle::Query& query = *oracle::find_query(asked);
    for (const auto& [name, path] : paths) {
      if (asked == "constraint" && slow.contains(name)) continue;
      const Scene scene = read_scene(path);
      tests::Digest said, work;
      said.add(answered(subject, query, scene));
      work.add(worked(subject, query, scene));
      page += asked + ' ' + name + ' ' + said.text() + ' ' + work.text() + '\n';
    }
  }
  return page;
}

}  // namespace

// These are regression pins, not truths: what is right is for the properties to say. They show that all builds give the
// same bits, and see a fault that stays within what a property allows, or that costs time alone. A change that means to
// change answers makes them anew: TOUCHSTONE_UPDATE=1 ./touchstone test -R "pins:".
TEST_CASE("pins: the answers of fast") {
  const auto fast = oracle::subjects::make_fast();
  const std::string now = answers("fast", *fast, oracle::query_names(), {64, 4});
  CHECK(tests::changed_lines("fast_answers.txt", now) == std::vector<std::string>{});
}

TEST_CASE("pins: the named motions by fast") {
  const std::string now = answers_about_motions(*oracle::subjects::make_fast());
  CHECK(tests::changed_lines("fast_motions.txt", now) == std::vector<std::string>{});
}

TEST_CASE("pins: the answers of the strategies of fast") {
  std::string now;
  for (const fast::Strategy& strategy : fast::strategies()) {
    const auto subject = oracle::subjects::make_fast_strategy(strategy.name);
    now += answers(subject->card().name, *subject, {"broad_phase", "pair_history"}, {32, 0});
  }
  CHECK(tests::changed_lines("strategy_answers.txt", now) == std::vector<std::string>{});
}

TEST_CASE("pins: the answers of pairs that fast follows") {
  std::string now;
  for (const char* name : {"warm", "cold"}) {
    const auto subject = oracle::subjects::make_fast_pairs(name);
    now += answers(subject->card().name, *subject, {"distance", "penetration"}, {32, 0});
  }
  CHECK(tests::changed_lines("pair_answers.txt", now) == std::vector<std::string>{});
}

TEST_CASE("pins: the answers of the reference") {
  const auto reference = oracle::subjects::make_reference();
  const std::string now = answers("reference", *reference, oracle::query_names(), {6, 1});
  CHECK(tests::changed_lines("reference_answers.txt", now) == std::vector<std::string>{});
}
