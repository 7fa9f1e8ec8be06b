// What a subject never answers counts as not offered.
#pragma once

#include <string>
#include <vector>

#include "app/trial/ledger.h"

namespace touchstone::app {

/// A query to which a subject gives no answer in the whole run, but from which it abstains, counts as abstained from,
/// also on the scenes where it threw first; likewise a property that judges a part of the answer which is never given.
/// The reason names what was thrown. A crash, a hang or garbage stays a failure.
void count_as_abstentions(ResultMatrix& results);

struct Unanswered {
  const TestedSubject* subject = nullptr;
  std::string query;
};

/// The queries that a subject was asked and that it answered in no row, by subject and then in the order of the run.
std::vector<Unanswered> unanswered(const Ledger& ledger);

}  // namespace touchstone::app
