// The failures that are known: a file with which `check` compares a run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/baseline/date.h"
#include "app/trial/ledger.h"
#include "oracle/finding.h"
#include "oracle/judge/grade.h"

namespace touchstone::app {

/// Somebody's word for why a failure is accepted, and until when.
struct Waiver {
  std::string reason;
  std::string link;
  Date expires;  ///< the last day on which it counts

  bool operator==(const Waiver&) const = default;
};

/// All scenes on which a subject fails a property in one way.
struct KnownFailure {
  std::string subject;  ///< the name on its card
  std::string property;
  oracle::Defect cause = oracle::Defect::none;
  oracle::Grade grade = oracle::Grade::F;  ///< the worst among these scenes
  std::optional<Waiver> waiver;

  bool operator==(const KnownFailure&) const = default;
};

/// What was asked when it was written, and what failed then.
struct Baseline {
  std::uint64_t seed = 0;
  std::string effort;
  int cases = 0;  ///< drawn scenes per query
  std::vector<KnownFailure> failures;

  bool operator==(const Baseline&) const = default;
};

/// The failures of a run, by property and then by subject.
Baseline baseline_of(const Ledger& ledger);

/// Gives each failure the waiver that the old baseline has for the same subject, property and cause.
void keep_waivers(Baseline& baseline, const Baseline& old);

/// Strict, as model/json.h is: a file that is missing or malformed, a property or a cause that does not exist, a date
/// that is none, and a second entry for the same failure are an InputError that names the place.
Baseline read_baseline(const std::string& path);

/// Throws what write_text (model/json.h) throws, and leaves the old file where it fails.
void write_baseline(const Baseline& baseline, const std::string& path);

}  // namespace touchstone::app
