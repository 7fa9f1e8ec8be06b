// Minimises the scene of a failing row, so that it still shows the row's defect.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "app/trial/effort.h"
#include "app/trial/ledger.h"
#include "oracle/subject.h"
#include "properties/property.h"

namespace touchstone::app {

/// How long a smaller scene is searched for.
struct Search {
  int budget = 0;                               ///< queries
  int hangs = std::numeric_limits<int>::max();  ///< ends after so many
  std::function<void()> asked = {};             ///< called after each query
};

/// Minimises the row's `smallest` example, keeping its defect, a grade at least as bad, and a fault at least as large
/// beside what is allowed and beside the scene (app/trial/fault_size.h). Checks the result once more in a fresh
/// process. If the subject does not repeat itself, the scene stays as found, and the case's note says so; it also says
/// if the search was interrupted, or ended by hangs. If the last question was about another scene, as in a law about
/// two answers, the case has that scene too. A scene outside the domain that the subject's card declares stays outside,
/// and one inside stays inside. The case has a snippet for each of its scenes, if the subject writes one. It names the
/// subject by its card, since the caller knows how to connect to it.
oracle::Case smallest_case(const Example& example, const properties::Property& property, oracle::Subject& subject,
                           std::uint64_t seed, const Search& search);

/// Minimises all failing rows by the effort's budgets, with one thread per entry of `workers` (each holds one object
/// per subject). Of a subject's rows that show a hang only the first is minimised, with at most `most_hangs` hangs.
void cut_down(Ledger& ledger, const std::vector<std::vector<std::unique_ptr<oracle::Subject>>>& workers,
              const Effort& effort);

}  // namespace touchstone::app
