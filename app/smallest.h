// The smallest scene that still shows a failing row's defect.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "app/ledger.h"
#include "oracle/subject.h"
#include "properties/property.h"

namespace touchstone::app {

/// Cuts down the row's `smallest` example, keeping its defect and a grade at least as bad, and checks the result once
/// more in a fresh process; a subject that does not repeat itself keeps the scene as found, and the case's note says
/// so, as does that of a search that was interrupted. The case names the subject by its card: the caller knows how to
/// reach it. `asked` is called after each question of the search.
oracle::Case smallest_case(const Example& example, const properties::Property& property, oracle::Subject& subject,
                           std::uint64_t seed, int budget, const std::function<void()>& asked = {});

/// All failing rows, on as many threads as there are crews (one subject object a subject in each).
void cut_down(Ledger& ledger, const std::vector<std::vector<std::unique_ptr<oracle::Subject>>>& crews, int budget);

}  // namespace touchstone::app
