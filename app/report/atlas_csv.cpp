#include "app/report/atlas_csv.h"

#include <fmt/format.h>

#include <algorithm>

namespace touchstone::app {
namespace {

/// A field is in quotes if it has a comma, a quote or a new line: names come from engines.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

}  // namespace

std::string name_of(DomainSide side) {
  return side == DomainSide::inside ? "inside" : side == DomainSide::across ? "across" : "outside";
}

std::string atlas_csv(const Ledger& ledger) {
  std::string csv = "query,subject,axis,unit,above,up_to,scenes,failing,broken,largest_error_over_allowed,declared\n";
  for (const auto& [query, profile] : ledger.profiles) {
    for (const TestedSubject& subject : ledger.subjects) {
      for (const auto& [place, cell] : profile.atlas[subject.index]) {
        const AtlasAxis& axis = atlas_axes()[static_cast<std::size_t>(place.first)];
        const Interval bounds = class_bounds(axis, place.second);
        csv += fmt::format("{},{},{},{},{:g},{:g},{},{},{},{:.3g},{}\n", query, csv_field(subject.card.name), axis.name,
                           axis.unit, bounds.lo, bounds.hi, cell.scenes, cell.failing, cell.broken, cell.excess,
                           name_of(side_of(axis, place.second, subject.card.domain)));
      }
    }
  }
  return csv;
}

}  // namespace touchstone::app
