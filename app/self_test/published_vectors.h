// The test vectors of vectors/, as a part of the program.
#pragma once

#include <string>
#include <vector>

namespace touchstone::app {

struct PublishedVector {
  std::string query;
  const char* text;  ///< JSON, one of "tests" (vectors/schema.json)
};

/// By query, in the order of their file.
const std::vector<PublishedVector>& published_vectors();

}  // namespace touchstone::app
