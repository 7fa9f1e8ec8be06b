#include "app/commands/soak.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "app/system/interruption.h"
#include "app/system/progress.h"
#include "app/system/terminal.h"
#include "app/trial/parallel.h"
#include "model/json.h"
#include "properties/scenes/domain.h"
#include "reference/agreement.h"

namespace touchstone::app {
namespace {

struct Tally {
  long agree = 0;
  std::vector<std::string> disagreements;
};

}  // namespace

int soak(int pairs, std::uint64_t seed, int jobs) {
  watch_for_interruption();
  std::vector<const properties::Family*> families;
  for (const properties::Family& family : properties::families()) {
    if (std::ranges::find(family.queries, "distance") != family.queries.end()) families.push_back(&family);
  }
  constexpr int chunk = 50;
  const int share = (pairs + static_cast<int>(families.size()) - 1) / static_cast<int>(families.size());
  const int chunks = (share + chunk - 1) / chunk;
  const auto pieces = families.size() * static_cast<std::size_t>(chunks);
  std::vector<Tally> tallies(pieces);
  {
    Progress progress("three routes", static_cast<int>(pieces));
    in_parallel(pieces, jobs, [&](std::size_t piece, std::size_t) {
      const properties::Family& family = *families[piece / static_cast<std::size_t>(chunks)];
      const int begin = static_cast<int>(piece % static_cast<std::size_t>(chunks)) * chunk;
      for (int index = begin; index < std::min(begin + chunk, share) && !interrupted(); ++index) {
        const Scene scene = draw(family, seed, static_cast<std::uint64_t>(index));
        const std::string wrong = reference::disagreement(scene);
        if (wrong.empty()) {
          ++tallies[piece].agree;
        } else {
          tallies[piece].disagreements.push_back(
              fmt::format("{} {}: {}\n{}", family.id, index, wrong, json_of(scene).dump()));
        }
      }
      progress.step(family.id);
    });
  }
  long asked = 0;
  long disagreements = 0;
  for (std::size_t f = 0; f < families.size(); ++f) {
    Tally sum;
    for (std::size_t c = 0; c < static_cast<std::size_t>(chunks); ++c) {
      Tally& tally = tallies[f * static_cast<std::size_t>(chunks) + c];
      sum.agree += tally.agree;
      std::ranges::move(tally.disagreements, std::back_inserter(sum.disagreements));
    }
    print("{:<32} {:>6} pairs  {} disagreements\n", families[f]->id,
          sum.agree + static_cast<long>(sum.disagreements.size()), sum.disagreements.size());
    for (const std::string& text : sum.disagreements) print_lines("  " + text + '\n');
    asked += sum.agree + static_cast<long>(sum.disagreements.size());
    disagreements += static_cast<long>(sum.disagreements.size());
  }
  print("{} pairs over {} families, seed {}: three routes, {} disagreements{}\n", asked, families.size(), seed,
        disagreements, interrupted() ? " (interrupted)" : "");
  if (disagreements > 0) return 3;
  return interrupted() ? interrupted_exit_code() : 0;
}

}  // namespace touchstone::app
