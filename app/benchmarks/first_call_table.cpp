#include "app/benchmarks/first_call_table.h"

#include <fmt/format.h>

#include "app/benchmarks/csv_fields.h"

namespace touchstone::app {
namespace {

double ratio(const FirstCall& row) { return *row.fast_ns / *row.reference_ns; }

std::string times_text(const FirstCall& row) {
  if (!row.fast_ns) return fmt::format("{:<44}{:>11}{:>11}{:>9}{:>9}\n", row.questions, "-", "-", "-", "-");
  return fmt::format("{:<44}{:>11.2f}{:>11.2f}{:>9.2f}{:>9.2f}\n", row.questions, *row.fast_ns / 1000,
                     *row.reference_ns / 1000, ratio(row), row.worst_ratio);
}

template <class IsAbove>
std::string above_text(const std::vector<FirstCall>& rows, IsAbove is_above) {
  std::string text;
  for (const FirstCall& row : rows) {
    if (row.fast_ns && is_above(row))
      text += fmt::format("{:<16}{:<44}{:>9.2f}{:>9.2f}\n", row.query, row.questions, ratio(row), row.worst_ratio);
  }
  return text.empty() ? "none\n" : text;
}

std::string left_out_text(const std::vector<FirstCall>& rows) {
  std::string text;
  for (const FirstCall& row : rows) {
    if (!row.left_out.empty()) text += fmt::format("{:<16}{:<44}{}\n", row.query, row.questions, row.left_out);
  }
  return text.empty() ? "none\n" : text;
}

}  // namespace

std::vector<FirstCall> first_call_rows(const std::string& csv) {
  std::vector<FirstCall> rows;
  for (const std::vector<std::string>& fields : csv_fields(csv, 7)) {
    FirstCall row{fields[0], fields[1], fields[2], {}, {}, 0, fields[6]};
    if (!fields[3].empty()) {
      row.fast_ns = std::stod(fields[3]);
      row.reference_ns = std::stod(fields[4]);
      row.worst_ratio = std::stod(fields[5]);
    }
    rows.push_back(row);
  }
  return rows;
}

std::string first_call_table(const std::vector<FirstCall>& rows) {
  std::string text, query;
  for (const FirstCall& row : rows) {
    if (row.query != query) {
      query = row.query;
      text += fmt::format("{}{:<44}{:>11}{:>11}{:>9}{:>9}\n", text.empty() ? "" : "\n",
                          query + ", us a question asked once", "fast", "reference", "ratio", "worst");
    }
    text += times_text(row);
  }
  text += "\nRows above 1, where fast is slower than the exact reference\n" +
          above_text(rows, [](const FirstCall& row) { return ratio(row) > 1; });
  text += "\nRows of at most 1 with a scene above 1\n" +
          above_text(rows, [](const FirstCall& row) { return ratio(row) <= 1 && row.worst_ratio > 1; });
  return text + "\nLeft out\n" + left_out_text(rows);
}

}  // namespace touchstone::app
