// The case files of properties/corpus, as a part of the program.
#pragma once

#include <string>
#include <vector>

namespace touchstone::app {

struct CorpusCase {
  std::string query;
  std::string name;  ///< of the file, without its ending
  std::string text;  ///< a case file (oracle/case.h)
};

/// By query and name.
const std::vector<CorpusCase>& corpus_cases();

}  // namespace touchstone::app
