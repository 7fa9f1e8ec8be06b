// The exact answer of a test vector, and what the judge allows an answer in doubles or floats.
#pragma once

#include <string>

#include "model/json.h"
#include "model/scene.h"

namespace touchstone::app {

/// The exact answer: that of exact_answer (app/commands/ask.h), or of a simulation the trajectory in doubles. Distances
/// and depths have a certificate of the distance of each pair of parts, as the least of several needs all. The query is
/// one of properties::tested_queries(). Throws InputError if the reference has no answer about this scene.
Json exact_vector(const std::string& query, const Scene& scene);

/// {"binary64": ..., "binary32": ...}: how far a distance, a depth or a side of a box may be off (m), as
/// oracle/tolerance has it. Only of the precisions in which the scene is exact; null for other queries.
Json allowance(const std::string& query, const Scene& scene);

}  // namespace touchstone::app
