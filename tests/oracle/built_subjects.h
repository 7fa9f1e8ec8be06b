// The subjects that were built. Engines may be installed into the same folder (./touchstone engines); the test
// "adapters: engines" asks those.
#pragma once

#include <algorithm>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "oracle/process/pipe.h"

namespace touchstone::oracle {

/// Those whose cards claim the query.
inline std::vector<std::unique_ptr<Subject>> answering(const std::string& query) {
  std::vector<std::unique_ptr<Subject>> subjects;
  std::istringstream names(TOUCHSTONE_BUILT_SUBJECTS);
  for (std::string name; names >> name;) {
    std::unique_ptr<Subject> subject = connect(name, TOUCHSTONE_SUBJECTS);
    if (std::ranges::count(subject->card().answers, query) > 0) subjects.push_back(std::move(subject));
  }
  return subjects;
}

}  // namespace touchstone::oracle
