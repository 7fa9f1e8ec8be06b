#include "app/benchmarks/work_precision.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "app/benchmarks/csv_fields.h"

namespace touchstone::app {
namespace {

template <class Key>
std::vector<std::string> distinct(const std::vector<WorkPrecision>& rows, Key key) {
  std::vector<std::string> all;
  for (const WorkPrecision& row : rows) {
    if (std::ranges::count(all, row.*key) == 0) all.push_back(row.*key);
  }
  return all;
}

std::vector<WorkPrecision> of_workload(const std::vector<WorkPrecision>& rows, const std::string& workload) {
  std::vector<WorkPrecision> some;
  std::ranges::copy_if(rows, std::back_inserter(some),
                       [&](const WorkPrecision& row) { return row.workload == workload; });
  return some;
}

const WorkPrecision* find(const std::vector<WorkPrecision>& rows, const std::string& name, const std::string& size) {
  const auto row = std::ranges::find_if(rows, [&](const WorkPrecision& r) { return r.name == name && r.size == size; });
  return row == rows.end() ? nullptr : &*row;
}

std::string time_of(const WorkPrecision* row) {
  if (row == nullptr) return fmt::format("{:>11}", "-");
  return row->ns ? fmt::format("{:>11.4g}", *row->ns) : fmt::format("{:>11}", "left out");
}

std::string error_of(const WorkPrecision* row) {
  return row != nullptr && row->worst_error ? fmt::format("{:>11.3g}", *row->worst_error) : fmt::format("{:>11}", "-");
}

std::string growth(const std::vector<WorkPrecision>& rows, const std::string& name, const std::string& first,
                   const std::string& last) {
  const WorkPrecision* a = find(rows, name, first);
  const WorkPrecision* b = find(rows, name, last);
  const bool both = a != nullptr && b != nullptr && a->ns && b->ns && first != last;
  return both ? fmt::format("{:>8.2f}x", *b->ns / *a->ns) : fmt::format("{:>9}", "-");
}

std::string block(const std::vector<WorkPrecision>& rows, const WorkPrecisionWords& words) {
  const std::vector<std::string> sizes = distinct(rows, &WorkPrecision::size);
  const auto names = distinct(rows, &WorkPrecision::name);
  std::string head;
  for (const std::string& size : sizes) head += fmt::format("{:>11}", size);
  std::string text =
      fmt::format("{}, by {}: ns a query\n{:<28}{}   growth\n", rows.front().workload, words.size, "", head);
  for (const std::string& name : names) {
    text += fmt::format("{:<28}", name);
    for (const std::string& size : sizes) text += time_of(find(rows, name, size));
    text += growth(rows, name, sizes.front(), sizes.back()) + "\n";
  }
  text += fmt::format("{}: worst error, {}\n", rows.front().workload, words.error);
  for (const std::string& name : names) {
    text += fmt::format("{:<28}", name);
    for (const std::string& size : sizes) text += error_of(find(rows, name, size));
    text += "\n";
  }
  return text + "\n";
}

std::string ratios(const std::vector<WorkPrecision>& rows) {
  std::string text;
  for (const WorkPrecision& ours : rows) {
    if (ours.whose != "ours" || !ours.ns) continue;
    std::vector<std::pair<double, std::string>> others;
    for (const WorkPrecision& row : rows) {
      const bool same_question = row.workload == ours.workload && row.size == ours.size;
      if (row.whose == "peer" && same_question && row.ns) others.emplace_back(*row.ns / *ours.ns, row.name);
    }
    if (others.empty()) continue;
    std::ranges::sort(others);
    text += fmt::format("{:<12}{:>6}  {:<22}", ours.workload, ours.size, ours.name);
    for (const auto& [times, name] : others) text += fmt::format("  {:.2f} {}", times, name);
    text += "\n";
  }
  return text.empty() ? "" : "How many times faster than each peer, the best peer first (below 1: it loses)\n" + text;
}

std::string left_out(const std::vector<WorkPrecision>& rows) {
  std::string text;
  for (const WorkPrecision& row : rows) {
    if (!row.left_out.empty())
      text += fmt::format("{:<12}{:>6}  {}: {}\n", row.workload, row.size, row.name, row.left_out);
  }
  return "\nLeft out\n" + (text.empty() ? "none\n" : text);
}

std::optional<double> number(const std::string& field) {
  if (field.empty() || field == "nan" || field == "-nan") return std::nullopt;
  return std::stod(field);
}

}  // namespace

std::vector<WorkPrecision> work_precision_rows(const std::string& csv) {
  std::vector<WorkPrecision> rows;
  for (const std::vector<std::string>& fields : csv_fields(csv, 8)) {
    rows.push_back({fields[0], fields[1], fields[2], fields[3], number(fields[4]), number(fields[5]), number(fields[6]),
                    fields[7]});
  }
  return rows;
}

std::string work_precision_table(const std::vector<WorkPrecision>& rows, const WorkPrecisionWords& words) {
  std::string text;
  for (const std::string& workload : distinct(rows, &WorkPrecision::workload)) {
    text += block(of_workload(rows, workload), words);
  }
  return text + (words.same_question ? ratios(rows) : "") + left_out(rows);
}

}  // namespace touchstone::app
