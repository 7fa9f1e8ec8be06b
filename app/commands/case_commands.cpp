#include "app/commands/case_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include "app/report/finding_words.h"
#include "app/report/replay_command.h"
#include "app/report/report_json.h"
#include "app/system/interruption.h"
#include "app/system/program_folder.h"
#include "app/system/progress.h"
#include "app/system/terminal.h"
#include "app/system/writable.h"
#include "app/trial/domain_watch.h"
#include "app/trial/last_asked.h"
#include "app/trial/smallest.h"
#include "app/trial/subject_list.h"
#include "model/input_error.h"
#include "model/json.h"
#include "oracle/case.h"
#include "oracle/judge/words.h"
#include "oracle/truth/truth.h"
#include "properties/clause.h"
#include "properties/property.h"
#include "properties/transforms/name.h"
#include "reference/validity.h"

namespace touchstone::app {
namespace {

using oracle::Case;
using oracle::Finding;
using oracle::words::text;
using properties::Property;

/// The words of a command are relative to the folder where it ran, and the path of the case to the present one.
std::string command_that_runs(const CaseCommand& command, const std::string& verb, const Case& a_case) {
  const bool moves = !a_case.folder.empty() && command.path != "-";
  const std::string path = moves ? std::filesystem::absolute(command.path).string() : command.path;
  const std::string run = fmt::format("{} {} {} --subject {}", shell_word(program_file()), verb, shell_word(path),
                                      shell_word(a_case.subject));
  return moves ? fmt::format("(cd {} && {})", shell_word(a_case.folder), run) : run;
}

/// Prints what the file names. It may be any text, so it is escaped.
[[noreturn]] void refuse_to_run(const CaseCommand& command, const std::string& verb, const Case& a_case) {
  const std::string& subject = a_case.subject;
  const bool is_plain = std::ranges::all_of(subject + a_case.folder, [](char c) { return c >= ' ' && c <= '~'; });
  const std::string how =
      is_plain ? "to run it: " + command_that_runs(command, verb, a_case) : "name it with --subject to run it";
  throw InputError(command.path, fmt::format("the file names a command, which only --subject may do; not run: {}; {}",
                                             Json(subject).dump(-1, ' ', true, Json::error_handler_t::replace), how));
}

/// The file may leave out the faces of polytopes, which the exact answers need.
Case completed_case(const std::string& path) {
  Case a_case = oracle::read_case(path);
  try {
    a_case.scene = reference::completed(std::move(a_case.scene));
  } catch (const InputError& error) {
    throw InputError(path, std::string("scene.") + error.what());
  }
  return a_case;
}

std::string name_of_subject(const CaseCommand& command, const std::string& verb, const Case& a_case) {
  if (!command.subject.empty()) return command.subject;
  if (a_case.subject.empty()) throw InputError(command.path, "names no subject: say which one with --subject");
  if (a_case.subject.starts_with("exec:")) refuse_to_run(command, verb, a_case);
  return a_case.subject;
}

void print_exchanged(oracle::PipeLimits::Way way, std::string_view line) {
  print("{} {}\n", way == oracle::PipeLimits::Way::sent ? ">" : "<", line);
}

auto print_traced(const std::string& connectable) {
  if (connectable.starts_with("inproc:")) {
    throw InputError("--trace", connectable + " answers within this process, so that no lines are exchanged");
  }
  return &print_exchanged;
}

void print_line(const std::string& label, const std::string& value) {
  if (!value.empty()) print("{:<12} {}\n", label, value);
}

bool is_compound(const Body& body) { return std::holds_alternative<Compound>(body.shape); }

void print_truth(const Scene& scene, const std::string& query) {
  if (scene.bodies.size() != 2 || (query != "distance" && query != "penetration")) return;
  const reference::DistanceTruth& truth = oracle::truth::distance(scene);
  print_line("truth", fmt::format("{}; distance {}, |d*|² = {}", text(truth.verdict), text(truth.distance),
                                  truth.core_squared.text()));
  if (query == "penetration" && std::ranges::none_of(scene.bodies, is_compound)) {
    const reference::PenetrationTruth& depth = oracle::truth::penetration(scene);
    print_line("", fmt::format("depth {}; least along {}", text(depth.depth), text(depth.nhat_BA_W)));
  }
  print_line("proof", text(truth.certificate));
}

void print_words(const Case& a_case, const Property& property, const oracle::Card& card, const Finding& finding) {
  print_line("property", property.id + ": " + property.says);
  for (const std::string& id : property.clauses) {
    const properties::Clause& clause = properties::clause(id);
    print_line("clause", clause.id + " (" + clause.title + "): " + clause.says);
  }
  print_line("subject", card.name + " " + card.version);
  print_line("scene", a_case.scene.name.empty() ? a_case.family : a_case.scene.name);
  print_truth(a_case.scene, property.query);
  for (const auto& [label, words] : lines_of(finding)) print_line(label, words);
  print_line("note", a_case.note);
}

struct AskedAgain {
  oracle::Card card;
  Finding finding;
  std::optional<Scene> last;  ///< the scene of the last question
};

/// Ends the subject, so that all lines are exchanged before the words.
AskedAgain ask(const Scene& scene, const Property& property, const std::unique_ptr<oracle::Subject> subject) {
  LastAsked last_asked(*subject);
  const Finding finding = property.check(scene, last_asked);
  return {subject->card(), finding, last_asked.scene()};
}

/// A file beside the case; a case from stdin has no folder.
std::string smaller_name(const std::string& path) {
  if (path == "-") return "smaller.json";
  return std::filesystem::path(path).replace_extension("smaller.json").string();
}

Case cut_down(const Example& example, const Property& property, oracle::Subject& subject, std::uint64_t seed,
              int budget) {
  Progress progress("reducing", budget);
  return smallest_case(example, property, subject, seed, {.budget = budget, .asked = [&] { progress.step(""); }});
}

}  // namespace

int replay(const CaseCommand& command) {
  const Case a_case = completed_case(command.path);
  const Property& property = properties::find(a_case.property);
  const std::string connectable = name_of_subject(command, "replay", a_case);
  oracle::PipeLimits limits = limits_of(command.time_limit);
  if (command.trace) limits.trace = print_traced(connectable);
  const AskedAgain asked = ask(a_case.scene, property, connect(connectable, limits));
  if (command.json) {
    print_lines(text_of(oracle::json_of(asked.finding)));
  } else {
    print_words(a_case, property, asked.card, asked.finding);
    if (failed(asked.finding) && asked.last && *asked.last != a_case.scene) {
      print_line("asked of", properties::name_of_change(a_case.scene, *asked.last));
    }
  }
  return failed(asked.finding) ? 1 : 0;
}

int minimise(const CaseCommand& command) {
  const Case a_case = completed_case(command.path);
  const Property& property = properties::find(a_case.property);
  const std::string connectable = name_of_subject(command, "minimise", a_case);
  const std::string out = command.out.empty() ? smaller_name(command.path) : command.out;
  require_writable_file(out);
  const auto subject = connect(connectable, limits_of(command.time_limit));
  watch_for_interruption();
  DomainWatch watch(*subject);
  const Finding found = property.check(a_case.scene, watch);
  const Example example{a_case.family, a_case.index, a_case.scene, found, watch.beyond()};
  if (interrupted()) {
    complain("interrupted before the case was asked once");
    return interrupted_exit_code();
  }
  if (!failed(example.finding)) {
    print("nothing to reduce: {}\n", oracle::name_of(example.finding.outcome));
    return 1;
  }
  Case smaller = cut_down(example, property, *subject, a_case.seed, command.budget);
  smaller.subject = connectable;
  smaller.folder = folder_of(connectable);
  oracle::write_case(smaller, out);
  print("{}: {}{}\n", out, text_of(oracle::size_of(smaller.scene)), interrupted() ? "; interrupted" : "");
  return interrupted() ? interrupted_exit_code() : 0;
}

}  // namespace touchstone::app
