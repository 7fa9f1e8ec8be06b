// The CSV of a benchmark: no field has a comma, a quote or a line break in it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace touchstone::app {

/// The fields of each line but the first, which names them. A line has `columns` fields: what it lacks is empty.
std::vector<std::vector<std::string>> csv_fields(const std::string& csv, std::size_t columns);

}  // namespace touchstone::app
