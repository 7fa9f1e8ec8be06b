#include "app/benchmarks/bench_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/benchmarks/csv_fields.h"

namespace touchstone::app {
namespace {

/// The strategy that is used by default; it is printed last.
constexpr const char* our_default = "wrapped_grid";

template <class Key>
std::vector<std::string> distinct(const std::vector<BenchRow>& rows, const Key& key) {
  std::vector<std::string> all;
  for (const BenchRow& row : rows) {
    if (std::ranges::count(all, key(row)) == 0) all.push_back(key(row));
  }
  return all;
}

std::vector<BenchRow> timed(const std::vector<BenchRow>& rows) {
  std::vector<BenchRow> some;
  std::ranges::copy_if(rows, std::back_inserter(some),
                       [](const BenchRow& row) { return !row.workload.starts_with("swaps."); });
  return some;
}

std::vector<std::size_t> sizes(const std::vector<BenchRow>& rows) {
  std::vector<std::size_t> all;
  for (const BenchRow& row : rows) {
    if (std::ranges::count(all, row.bodies) == 0) all.push_back(row.bodies);
  }
  std::ranges::sort(all);
  return all;
}

/// The rows of one workload, by name and size.
using Cells = std::map<std::pair<std::string, std::size_t>, BenchRow>;

std::string law_text(const Cells& cells, const std::string& name, const std::vector<std::size_t>& at) {
  std::vector<std::pair<double, double>> points;
  for (const std::size_t n : at) {
    const auto cell = cells.find({name, n});
    if (cell != cells.end() && cell->second.ns) {
      points.emplace_back(static_cast<double>(n), *cell->second.ns * static_cast<double>(n));
    }
  }
  return points.size() < 2 ? "-" : fmt::format("n^{:.2f}", fitted_exponent(points));
}

std::string times_text(const std::string& workload, const std::vector<BenchRow>& rows) {
  const std::vector<std::size_t> at = sizes(rows);
  Cells cells;
  for (const BenchRow& row : rows) cells.emplace(std::pair{row.name, row.bodies}, row);
  std::string text = fmt::format("{}: ns a body and frame\n{:<26}", workload, "");
  for (const std::size_t n : at) text += fmt::format("{:>10}", n);
  text += fmt::format("{:>9}{:>10}  {}\n", "growth", "a frame", "claimed");
  for (const std::string& name : distinct(rows, [](const BenchRow& row) { return row.name; })) {
    text += fmt::format("{:<26}", name);
    std::string law;
    for (const std::size_t n : at) {
      const auto cell = cells.find({name, n});
      const bool there = cell != cells.end() && cell->second.ns;
      text += there ? fmt::format("{:>10.1f}", *cell->second.ns) : fmt::format("{:>10}", "left out");
      if (cell != cells.end()) law = cell->second.law;
    }
    const auto first = cells.find({name, at.front()});
    const auto last = cells.find({name, at.back()});
    const bool both = first != cells.end() && last != cells.end() && first->second.ns && last->second.ns;
    text += both ? fmt::format("{:>8.2f}x", *last->second.ns / *first->second.ns) : fmt::format("{:>9}", "-");
    text += fmt::format("{:>10}  {}\n", law_text(cells, name, at), law);
  }
  return text + "\n";
}

/// How many times faster the default is than the best strategy and than each peer.
std::string ratio_text(const std::string& workload, const std::vector<BenchRow>& rows) {
  std::string text;
  for (const std::size_t n : sizes(rows)) {
    const auto ours = std::ranges::find_if(
        rows, [&](const BenchRow& row) { return row.name == our_default && row.bodies == n && row.ns; });
    if (ours == rows.end()) continue;
    std::vector<std::pair<double, std::string>> others;
    for (const BenchRow& row : rows) {
      if (row.peer && row.bodies == n && row.ns) others.emplace_back(*row.ns / *ours->ns, row.name);
    }
    std::ranges::sort(others);
    text += fmt::format("{:<10}{:>8}", workload, n);
    for (const auto& [times, name] : others) text += fmt::format("  {:.2f} {}", times, name);
    text += others.empty() ? "  no peer kept to the budget\n" : "\n";
  }
  return text;
}

std::string left_out_text(const std::vector<BenchRow>& rows) {
  std::string text;
  for (const BenchRow& row : rows) {
    if (!row.left_out.empty())
      text += fmt::format("{:<10}{:>8}  {}: {}\n", row.workload, row.bodies, row.name, row.left_out);
  }
  return text.empty() ? "none\n" : text;
}

std::string counted_text(const std::vector<BenchRow>& rows) {
  std::string text;
  for (const std::string& workload : distinct(rows, [](const BenchRow& row) { return row.workload; })) {
    if (!workload.starts_with("swaps.")) continue;
    std::vector<std::pair<double, double>> points;
    std::string law;
    text += fmt::format("{:<18}", workload);
    for (const BenchRow& row : rows) {
      if (row.workload != workload) continue;
      law = row.law;
      points.emplace_back(static_cast<double>(row.bodies), row.count * static_cast<double>(row.bodies));
      text += fmt::format("  {}: {:.1f} n", row.bodies, row.count);
    }
    text += fmt::format("  = n^{:.3f}, derived {}\n", fitted_exponent(points), law);
  }
  return text;
}

}  // namespace

std::vector<BenchRow> bench_rows(const std::string& csv) {
  std::vector<BenchRow> rows;
  for (const std::vector<std::string>& fields : csv_fields(csv, 8)) {
    BenchRow row{fields[0], std::stoul(fields[1]), fields[2], fields[3] == "peer", fields[4], {}, 0, fields[7]};
    if (!fields[5].empty()) row.ns = std::stod(fields[5]);
    if (!fields[6].empty()) row.count = std::stod(fields[6]);
    rows.push_back(row);
  }
  return rows;
}

double fitted_exponent(const std::vector<std::pair<double, double>>& points) {
  const double n = static_cast<double>(points.size());
  double x = 0;
  double y = 0;
  double xx = 0;
  double xy = 0;
  for (const auto& [at, value] : points) {
    const double u = std::log(at);
    const double v = std::log(value);
    x += u / n;
    y += v / n;
    xx += u * u / n;
    xy += u * v / n;
  }
  return (xy - x * y) / (xx - x * x);
}

std::string bench_table(const std::vector<BenchRow>& rows) {
  const std::vector<BenchRow> times = timed(rows);
  std::map<std::string, std::vector<BenchRow>> by_workload;
  for (const BenchRow& row : times) by_workload[row.workload].push_back(row);
  const auto workloads = distinct(times, [](const BenchRow& row) { return row.workload; });
  std::string text;
  for (const std::string& workload : workloads) text += times_text(workload, by_workload[workload]);
  text +=
      fmt::format("How many times faster {} is than each peer, the best peer first (below 1: it loses)\n", our_default);
  for (const std::string& workload : workloads) text += ratio_text(workload, by_workload[workload]);
  text += "\nLeft out\n" + left_out_text(times);
  text += "\nSwaps of sweep and prune a frame\n" + counted_text(rows);
  return text;
}

}  // namespace touchstone::app
