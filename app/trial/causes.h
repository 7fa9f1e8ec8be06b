// One cause that breaks many rows is one cause.
#pragma once

#include <string>
#include <vector>

#include "app/trial/ledger.h"

namespace touchstone::app {

/// Failing rows of one subject that are shown with the same break: the same defect with the same words, apart from the
/// numbers in them. A row that answers wrongly is a cause by itself.
struct Cause {
  const TestedSubject* subject = nullptr;
  std::vector<const Row*> rows;  ///< property by property; never empty
};

/// The words of a break with # for each number: indices and coordinates differ from scene to scene. A minus before a
/// number goes with it.
std::string without_numbers(const std::string& words);

/// Of one subject, by first row. Each failing row is in one cause.
std::vector<Cause> causes(const ResultMatrix& results, const TestedSubject& subject);

/// Of all subjects, inside their declared domains.
std::vector<Cause> causes(const Ledger& ledger);

}  // namespace touchstone::app
