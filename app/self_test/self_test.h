// A known-answer test of the judge: before a build accuses an engine, it shows that its own answers are right.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/self_test/published_vectors.h"

namespace touchstone::app {

/// What this build computes about a published test vector, where that differs from what was published.
struct OtherAnswer {
  std::string id;         ///< of the vector: "distance-0123abcd"
  std::string place;      ///< "answer/squared_distance_of_cores/exact"
  std::string published;  ///< JSON; "nothing" if the place is new
  std::string computed;   ///< JSON; "nothing" if the place is missing; an error's words
};

/// Compares classes, margin and answer bit for bit. Scale and allowances, which are sums of doubles in an order that is
/// the compiler's, may differ by 1e-9 of themselves.
std::optional<OtherAnswer> other_answer(const PublishedVector& vector);

/// Of all published vectors of the queries, in their order. Incomplete if the run was interrupted.
std::vector<OtherAnswer> other_answers(const std::vector<std::string>& queries, int jobs);

/// Throws std::runtime_error, which names the first vector that is answered otherwise.
void require_published_answers(const std::vector<std::string>& queries, int jobs);

struct SelfTestCommand {
  std::vector<std::string> queries;  ///< empty: all
  int jobs = 0;                      ///< 0: one for each processor
};

/// Prints, for each query, how many vectors are answered otherwise, and which. The exit code is 3 if any is.
int self_test(const SelfTestCommand& command);

}  // namespace touchstone::app
