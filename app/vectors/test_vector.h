// Test vectors: scenes with their exact answers, in files that need nothing else of this project to be used.
#pragma once

#include <string>
#include <vector>

#include "model/json.h"
#include "model/scene.h"

namespace touchstone::app {

/// A scene, and where it is from. All else in a file is computed from these.
struct TestVector {
  Scene scene;
  Json source;  ///< {"family", "seed", "index"} of a draw; {"property", "failed_by", ...} of a case; or {"note"}
};

/// Is the scene from a family at the ends of the doubles, where no bound on rounding holds
/// (properties/scenes/extreme.h)?
bool is_extreme(const TestVector& vector);

/// The name of the file that has the vectors of a query, in a folder of test vectors.
std::string vectors_file(const std::string& folder, const std::string& query);

/// The vectors of a file, in its order; none if there is no file. Reads only scenes and sources. Throws InputError.
std::vector<TestVector> read_vectors(const std::string& file);

/// Without those whose scene an earlier one has.
std::vector<TestVector> distinct(std::vector<TestVector> vectors);

/// One of the "tests" of a file: id, classes, scale, allowances and the exact answer, all computed from the scene.
/// Throws InputError if the query has no exact answer about it.
Json vector_json(const std::string& query, const TestVector& vector);

/// The text of a file: the query's clauses, and the vectors, each on a line (vectors/README.md). Requires distinct
/// scenes. Throws InputError, about "tests[3]", if the query has no exact answer about a scene.
std::string text_of_vectors(const std::string& query, const std::vector<TestVector>& vectors);

}  // namespace touchstone::app
