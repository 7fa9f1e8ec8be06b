#include "app/benchmarks/csv_fields.h"

#include <sstream>

namespace touchstone::app {

std::vector<std::vector<std::string>> csv_fields(const std::string& csv, std::size_t columns) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::istringstream in(line);
    std::vector<std::string>& fields = rows.emplace_back();
    for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
    fields.resize(columns);
  }
  return rows;
}

}  // namespace touchstone::app
