// Compares a run with a baseline.
#pragma once

#include "app/baseline/baseline.h"

namespace touchstone::app {

/// How many failures of the baseline, and of the run.
struct Comparison {
  long known = 0;      ///< fail as before, or with a better grade
  long waived = 0;     ///< of these, the ones with a waiver that counts
  long fresh = 0;      ///< are not in the baseline
  long worse = 0;      ///< have a worse grade than in the baseline
  long expired = 0;    ///< have a waiver that has expired
  long passing = 0;    ///< do not occur any more, though their property was answered
  long not_asked = 0;  ///< their property was not asked in this run, or not answered

  bool green() const { return fresh + worse + expired + passing == 0; }
};

/// Marks the rows of the ledger: `departures` says what differs; `known` why a failing row without any is accepted.
/// Requires a run that was neither interrupted nor ended by its first failure.
Comparison compare(const Baseline& baseline, Date today, Ledger& ledger);

}  // namespace touchstone::app
