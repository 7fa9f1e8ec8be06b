#include "app/trend/trend.h"

#include <algorithm>
#include <optional>

namespace touchstone::app {
namespace {

std::map<std::string, const ReportedRow*> rows_of(const ReportFile& report, const std::string& subject) {
  std::map<std::string, const ReportedRow*> rows;
  for (const ReportedRow& row : report.rows) {
    if (row.subject == subject) rows[row.property] = &row;
  }
  return rows;
}

bool answers(const ReportedRow* row) { return row != nullptr && row->answered() > 0; }

/// None if nothing changed. Requires rows that answer.
std::optional<Change> change_of(const ReportedRow& before, const ReportedRow& after, bool same_scenes) {
  if (before.failures == 0 && after.failures == 0) return std::nullopt;
  if (before.failures == 0) return Change::fresh;
  if (after.failures == 0) return Change::fixed;
  if (before.grade != after.grade) return before.grade < after.grade ? Change::worse : Change::better;
  if (!same_scenes || before.failures == after.failures) return std::nullopt;
  return before.failures < after.failures ? Change::worse : Change::better;
}

void add(Trend& trend, const ReportedRow* before, const ReportedRow* after, bool same_scenes) {
  if (!answers(before) && !answers(after)) {
    ++trend.unanswered;
  } else if (!answers(after)) {
    trend.changes.push_back({Change::silent, before, after});
  } else if (!answers(before)) {
    trend.changes.push_back({after->failures > 0 ? Change::fresh : Change::answers, before, after});
  } else if (const auto change = change_of(*before, *after, same_scenes)) {
    trend.changes.push_back({*change, before, after});
  } else {
    ++(after->failures > 0 ? trend.fails : trend.holds);
  }
}

Trend trend_of(const ReportFile& before, const ReportFile& after, const std::string& old_name,
               const std::string& new_name) {
  Trend trend;
  trend.before = old_name;
  trend.after = new_name;
  const bool same_scenes = before.asks_the_scenes_of(after);
  const auto old_rows = rows_of(before, old_name), new_rows = rows_of(after, new_name);
  const auto row = [](const auto& rows, const std::string& property) {
    const auto found = rows.find(property);
    return found == rows.end() ? nullptr : found->second;
  };
  for (const ReportedRow& it : after.rows) {
    if (it.subject == new_name) add(trend, row(old_rows, it.property), &it, same_scenes);
  }
  for (const ReportedRow& it : before.rows) {
    if (it.subject == old_name && !new_rows.contains(it.property)) add(trend, &it, nullptr, same_scenes);
  }
  std::ranges::stable_sort(trend.changes, {}, &ChangedRow::change);
  return trend;
}

}  // namespace

std::string name_of(Change change) {
  switch (change) {
    case Change::fresh:
      return "new";
    case Change::worse:
      return "worse";
    case Change::silent:
      return "unanswered";
    case Change::better:
      return "better";
    case Change::fixed:
      return "fixed";
    case Change::answers:
      return "answered";
  }
  return "";
}

bool Trend::regressed() const {
  return std::ranges::any_of(changes, [](const ChangedRow& row) { return row.change <= Change::silent; });
}

std::vector<Trend> trends(const ReportFile& before, const ReportFile& after,
                          const std::map<std::string, std::string>& pairs) {
  std::vector<Trend> all;
  for (const auto& [old_name, new_name] : pairs) all.push_back(trend_of(before, after, old_name, new_name));
  return all;
}

}  // namespace touchstone::app
