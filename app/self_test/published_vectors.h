// The test vectors of vectors/, as a part of the program.
#pragma once

#include <span>

namespace touchstone::app {

struct PublishedVector {
  const char* query;
  const char* text;  ///< JSON, one of "tests" (vectors/schema.json)
};

/// By query, in the order of their file.
std::span<const PublishedVector> published_vectors();

}  // namespace touchstone::app
