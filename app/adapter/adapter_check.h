// Proves an adapter before its engine is judged: asks scenes that are solved on paper, and recognises typical mistakes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "oracle/subject.h"

namespace touchstone::app {

/// What a wrong answer looks like, and how many of the query's wrong answers that explains.
struct Hint {
  std::string text;
  int explains = 0;
};

/// The answers to one query.
struct CheckedQuery {
  std::string query;
  int asked = 0, right = 0, wrong = 0, abstains = 0, breaks = 0;
  std::vector<Hint> hints;       ///< those that explain most come first
  std::string scene, complaint;  ///< of the first wrong answer, or of the first that was none

  int faults() const { return wrong + breaks; }

  /// A typical mistake explains several wrong answers, or more than an eighth is wrong: an engine that is any good errs
  /// less often on such scenes. It may still be the engine's fault.
  bool is_fault() const { return !hints.empty() || 8 * faults() > asked - abstains; }
};

struct AdapterCheck {
  std::vector<CheckedQuery> queries;
  std::string precision;  ///< what is wrong with the card's precision; empty: nothing

  bool is_fault() const;
};

/// Asks the queries that the subject's card claims and that are in `queries`; all that it claims if that is empty.
/// `asked` is called before each scene. A query is given up after `most_hangs` hangs (app/trial/effort.h).
AdapterCheck check_adapter(oracle::Subject& subject, const std::vector<std::string>& queries,
                           const std::function<void(const std::string& query)>& asked);

}  // namespace touchstone::app
