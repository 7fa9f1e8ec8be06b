#include "app/adapter/adapter_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/adapter/adapter_check.h"
#include "app/adapter/skeletons.h"
#include "app/adapter/widest_domain.h"
#include "app/report/replay_command.h"
#include "app/system/interruption.h"
#include "app/system/progress.h"
#include "app/system/terminal.h"
#include "app/trial/subject_list.h"
#include "model/input_error.h"
#include "model/json.h"
#include "oracle/process/protocol.h"
#include "oracle/query.h"

namespace touchstone::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* default_name = "my_engine";

/// It becomes a file, a module of Python, a package of Rust and a program.
void require_plain_name(const std::string& name) {
  const auto is_plain = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
  if (name.empty() || !std::ranges::all_of(name, is_plain) || (name[0] >= '0' && name[0] <= '9')) {
    throw InputError("name \"" + name + '"', "expected a small letter or _, then small letters, digits and _");
  }
}

int write_skeleton(const AdapterCommand& command) {
  const std::string name = command.name.empty() ? default_name : command.name;
  require_plain_name(name);
  if (command.language.empty()) throw InputError("--lang", "expected one of js, python, rust, cpp");
  if (fs::exists(fs::symlink_status(name))) throw InputError(name, "exists; nothing was written");
  const Skeleton skeleton = skeleton_of(command.language, name);
  std::error_code error;
  if (!fs::create_directory(name, error)) throw InputError(name, "cannot be created: " + error.message());
  for (const auto& [file, text, about] : skeleton.files) {
    write_text((fs::path(name) / file).string(), text);
    print("{:<34} {}\n", name + '/' + file, about);
  }
  for (const std::string& next : skeleton.next) print("Next: {}\n", next);
  return 0;
}

Json json_of(const CheckedQuery& checked) {
  Json hints = Json::array();
  for (const Hint& hint : checked.hints) hints.push_back({{"hint", hint.text}, {"explains", hint.explains}});
  Json json = {{"query", checked.query},      {"asked", checked.asked},       {"right", checked.right},
               {"wrong", checked.wrong},      {"abstains", checked.abstains}, {"breaks", checked.breaks},
               {"fault", checked.is_fault()}, {"hints", std::move(hints)}};
  if (checked.faults() > 0) json["example"] = {{"scene", checked.scene}, {"complaint", checked.complaint}};
  return json;
}

Json json_of(const AdapterCheck& check, const oracle::Card& card) {
  Json queries = Json::array();
  for (const CheckedQuery& query : check.queries) queries.push_back(json_of(query));
  Json json = {{"subject", card.name}, {"version", card.version}, {"queries", std::move(queries)}};
  if (!check.precision.empty()) json["precision"] = check.precision;
  json["fault"] = check.is_fault();
  return json;
}

std::string verdict_of(const CheckedQuery& checked) {
  if (checked.abstains == checked.asked) return "never answered";
  if (checked.faults() == 0) return "ok";
  return checked.is_fault() ? "wrong" : "ok; the wrong answers are few, so probably the engine's";
}

void print_table(const AdapterCheck& check, const oracle::Card& card) {
  print("{} {}\n{:<15} {:>5} {:>6} {:>6} {:>9} {:>7}\n", card.name, card.version, "query", "asked", "right", "wrong",
        "abstains", "breaks");
  for (const CheckedQuery& query : check.queries) {
    print("{:<15} {:>5} {:>6} {:>6} {:>9} {:>7}  {}\n", query.query, query.asked, query.right, query.wrong,
          query.abstains, query.breaks, verdict_of(query));
    for (const Hint& hint : query.hints)
      print("  hint: {} (explains {} of {})\n", hint.text, hint.explains, query.wrong);
    if (query.faults() > 0) print("  e.g. \"{}\": {}\n", query.scene, query.complaint);
  }
  if (!check.precision.empty()) print("hint: {}\n", check.precision);
  print("{}\n",
        check.is_fault()
            ? "Wrong answers to plain questions: find out whether the adapter is at fault before its engine is judged."
            : "No fault of the adapter was found.");
}

int check_it(const AdapterCommand& command) {
  if (command.name.empty()) throw InputError("adapter check", "expected a subject, as \"exec:python3 my_engine.py\"");
  const auto subject = connect(command.name, limits_of(command.time_limit));
  watch_for_interruption();
  Progress progress("asking", 0);
  const AdapterCheck check =
      check_adapter(*subject, command.queries, [&](const std::string& query) { progress.step(query); });
  if (interrupted()) return interrupted_exit_code();
  if (check.queries.empty()) throw InputError(command.name, "claims none of the queries, so there is nothing to check");
  if (command.json) {
    print_lines(text_of(json_of(check, subject->card())));
  } else {
    print_table(check, subject->card());
  }
  return check.is_fault() ? 1 : 0;
}

/// "2^-12 to 2^10", "up to 2^7"; and where nothing failed beyond.
std::string words_of(const HeldRange& range) {
  if (range.least > range.most) return "fails on plain scenes";
  const Axis& axis = *range.axis;
  const std::string from = axis.least == axis.start ? "up to" : fmt::format("2^{} to", range.least);
  std::string words = fmt::format("{} 2^{}", from, range.most);
  if (!range.fails_above) words += range.most == axis.most ? "; more is not asked" : "; more is outside its domain";
  if (!range.fails_below && axis.least < axis.start) {
    words += range.least == axis.least ? "; less is not asked" : "; less is outside its domain";
  }
  return words;
}

Json json_of(const std::vector<HeldRange>& ranges) {
  Json rows = Json::array();
  for (const HeldRange& range : ranges) {
    Json row = {{"property", range.property->id}, {"axis", range.axis->name}};
    if (range.least <= range.most) row["exponents"] = {range.least, range.most};
    row["fails_below"] = range.fails_below;
    row["fails_above"] = range.fails_above;
    rows.push_back(std::move(row));
  }
  return rows;
}

int measure_domain(const AdapterCommand& command) {
  if (command.name.empty()) throw InputError("adapter domain", "expected a subject, as \"exec:python3 my_engine.py\"");
  const auto subject = connect(command.name, limits_of(command.time_limit));
  watch_for_interruption();
  Progress progress("asking", 0);
  const std::vector<HeldRange> ranges =
      widest_domain(*subject, command.queries, [&](const std::string& query) { progress.step(query); });
  if (interrupted()) return interrupted_exit_code();
  if (ranges.empty()) throw InputError(command.name, "answers none of the queries, so there is nothing to measure");
  const oracle::Card& card = subject->card();
  const Json proposed = oracle::protocol::json_of(default_domain(card.precision));
  if (command.json) {
    print_lines(text_of(
        Json{{"subject", card.name}, {"version", card.version}, {"proposed", proposed}, {"ranges", json_of(ranges)}}));
    return 0;
  }
  print("{} {}\nproposed for its precision: \"domain\": {}\n", card.name, card.version, proposed.dump());
  for (const HeldRange& range : ranges)
    print("{:<30} {:<11} {}\n", range.property->id, range.axis->name, words_of(range));
  return 0;
}

}  // namespace

const std::vector<std::string>& adapter_actions() {
  static const std::vector<std::string> actions = {"new", "check", "domain"};
  return actions;
}

int adapter(const AdapterCommand& command) {
  if (command.action == "new") return write_skeleton(command);
  return command.action == "domain" ? measure_domain(command) : check_it(command);
}

}  // namespace touchstone::app
