#include "app/case_commands.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/report_json.h"
#include "app/roster.h"
#include "app/smallest.h"
#include "model/input_error.h"
#include "oracle/case.h"
#include "oracle/truth.h"
#include "oracle/words.h"
#include "properties/clause.h"
#include "properties/property.h"

namespace touchstone::app {
namespace {

using oracle::Case;
using oracle::Finding;
using oracle::words::text;
using properties::Property;

std::unique_ptr<oracle::Subject> subject_of(const CaseCommand& command, const Case& a_case) {
  const std::string name = command.subject.empty() ? a_case.subject : command.subject;
  if (name.empty()) throw InputError(command.path, "names no subject: say which one with --subject");
  return connect(name, command.limits);
}

bool failed(const Finding& finding) {
  return finding.outcome == oracle::Outcome::fails || finding.outcome == oracle::Outcome::breaks;
}

void print_line(const char* label, const std::string& value) {
  if (!value.empty()) fmt::print("{:<12} {}\n", label, value);
}

void print_truth(const Scene& scene, const std::string& stem) {
  if (scene.bodies.size() != 2 || (stem != "distance" && stem != "penetration")) return;
  const reference::DistanceTruth& truth = oracle::truth::distance(scene);
  print_line("truth", fmt::format("{}; distance {}; |d*|² = {}", text(truth.verdict), text(truth.distance),
                                  truth.core_squared.text()));
  print_line("proof", text(truth.certificate));
}

void print_finding(const Finding& finding) {
  print_line("outcome", oracle::name_of(finding.outcome) +
                            (finding.defect == oracle::Defect::none ? "" : ": " + oracle::name_of(finding.defect)));
  print_line("observed", finding.observed);
  print_line("expected", finding.expected);
  if (!finding.unit.empty()) {
    print_line("error", fmt::format("{:.4g} {}; allowed {:.4g}", finding.error, finding.unit, finding.allowed));
  }
  if (finding.margin) print_line("margin", text(*finding.margin) + " m from another truth");
  print_line("because", finding.why);
}

void print_words(const Case& a_case, const Property& property, const oracle::Card& card, const Finding& finding) {
  print_line("property", property.id + ": " + property.says);
  for (const std::string& id : property.clauses) {
    const properties::Clause& clause = properties::clause(id);
    print_line("clause", clause.id + " (" + clause.title + "): " + clause.says);
  }
  print_line("subject", card.name + " " + card.version);
  print_line("scene", a_case.scene.name.empty() ? a_case.family : a_case.scene.name);
  print_truth(a_case.scene, property.stem);
  print_finding(finding);
  print_line("note", a_case.note);
}

}  // namespace

int replay(const CaseCommand& command) {
  const Case a_case = oracle::read_case(command.path);
  const Property& property = properties::find(a_case.property);
  const auto subject = subject_of(command, a_case);
  const Finding finding = property.check(a_case.scene, *subject);
  if (command.json) {
    fmt::print("{}", text_of(oracle::json_of(finding)));
  } else {
    print_words(a_case, property, subject->card(), finding);
  }
  return failed(finding) ? 1 : 0;
}

int minimise(const CaseCommand& command) {
  const Case a_case = oracle::read_case(command.path);
  const Property& property = properties::find(a_case.property);
  const auto subject = subject_of(command, a_case);
  const Example example{a_case.family, a_case.index, a_case.scene, property.check(a_case.scene, *subject)};
  if (!failed(example.finding)) {
    fmt::print("nothing to cut down: {}\n", oracle::name_of(example.finding.outcome));
    return 1;
  }
  const Case smaller = smallest_case(example, property, *subject, a_case.seed, command.budget);
  const std::string out = command.out.empty()
                              ? std::filesystem::path(command.path).replace_extension("smaller.json").string()
                              : command.out;
  oracle::write_case(smaller, out);
  const oracle::Size size = oracle::size_of(smaller.scene);
  fmt::print("{}: {} bodies, at most {} vertices a body and {} significant bits\n", out, size.bodies,
             size.vertices_per_body_max, size.significant_bits_max);
  return 0;
}

}  // namespace touchstone::app
