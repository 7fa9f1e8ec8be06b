// A page that shows every test vector: picture, classes, where it is from, and the exact answer.
#pragma once

#include <string>
#include <vector>

#include "model/json.h"

namespace touchstone::app {

/// One HTML file that needs no other. `files` are the parsed texts of text_of_vectors (app/vectors/test_vector.h).
std::string vectors_page(const std::vector<Json>& files);

}  // namespace touchstone::app
