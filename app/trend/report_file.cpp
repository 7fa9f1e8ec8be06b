#include "app/trend/report_file.h"

#include <fmt/format.h>

#include "app/baseline/named_value.h"
#include "model/json_node.h"
#include "model/source_text.h"

namespace touchstone::app {
namespace {

constexpr const char* report_format = "report/1";

std::string read_error(const Node& node) {
  const Node error = node.at("error");
  const std::string size = error.is_text() ? error.text() : fmt::format("{:.3g}", error.number());
  return size + ' ' + node.at("unit").text();
}

ReportedRow read_row(const Node& node) {
  ReportedRow row;
  row.subject = node.at("subject").text();
  row.property = node.at("property").text();
  row.holds = node.at("holds").index();
  for (const char* kind : {"fails", "breaks", "refused"}) row.failures += node.at(kind).index();
  if (const auto grade = node.find("grade")) row.grade = read_named(*grade, oracle::Grade::A, oracle::Grade::F);
  if (const auto defects = node.find("defects")) {
    for (int i = static_cast<int>(oracle::Defect::phantom); i <= static_cast<int>(oracle::Defect::garbage); ++i) {
      const std::string name = oracle::name_of(static_cast<oracle::Defect>(i));
      if (const auto count = defects->find(name)) row.defects[name] = count->index();
    }
  }
  if (const auto error = node.find("largest_error")) row.largest_error = read_error(*error);
  if (const auto file = node.find("case")) row.case_file = file->text();
  return row;
}

ReportFile read_report_json(const Json& json) {
  const Node node(json, "");
  if (const std::string format = node.at("touchstone").text(); format != report_format) {
    node.at("touchstone").refuse(fmt::format("expected \"{}\", found {}", report_format, Json(format).dump()));
  }
  if (node.at("interrupted").truth()) node.at("interrupted").refuse("the run was interrupted: it says too little");
  ReportFile report;
  if (!node.at("seed").is_null() && !json.at("seed").is_number_unsigned())
    node.at("seed").refuse("expected an integer from 0 to 2^64 - 1");
  report.seed = json.at("seed").get<std::uint64_t>();
  report.effort = node.at("effort").text();
  report.cases = node.at("cases_per_query").index();
  const Node subjects = node.at("subjects"), rows = node.at("rows");
  for (int i = 0; i < subjects.size(); ++i) {
    report.versions[subjects[i].at("name").text()] = subjects[i].at("version").text();
  }
  for (int i = 0; i < rows.size(); ++i) report.rows.push_back(read_row(rows[i]));
  return report;
}

}  // namespace

ReportFile read_report(const std::string& path) {
  const SourceText source = read_source(path);
  ReportFile report = read_document(source.text, source.name, read_report_json);
  report.path = path;
  return report;
}

}  // namespace touchstone::app
