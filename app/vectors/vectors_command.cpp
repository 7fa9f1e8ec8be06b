#include "app/vectors/vectors_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "app/system/progress.h"
#include "app/system/terminal.h"
#include "app/system/writable.h"
#include "app/vectors/drawn_vectors.h"
#include "app/vectors/exact_vector.h"
#include "app/vectors/test_vector.h"
#include "app/vectors/vectors_page.h"
#include "model/input_error.h"
#include "oracle/case.h"
#include "properties/property.h"
#include "properties/scenes/extreme.h"
#include "reference/validity.h"

namespace touchstone::app {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string>& queries_of(const VectorsCommand& command) {
  return command.queries.empty() ? properties::tested_queries() : command.queries;
}

/// Where the scene of a case is from. A subject is named without its command line.
Json source_of(const oracle::Case& a_case) {
  Json source = {{"property", a_case.property}};
  const bool has_subject = !a_case.subject.empty();
  if (has_subject && a_case.finding.outcome != oracle::Outcome::holds) {
    source["failed_by"] = a_case.subject.substr(0, a_case.subject.find(' '));
    source["defect"] = oracle::name_of(a_case.finding.defect);
  }
  if (!a_case.family.empty()) {
    source["smaller_than"] = {{"family", a_case.family}, {"seed", a_case.seed}, {"index", a_case.index}};
  }
  if (!a_case.note.empty()) source["note"] = a_case.note;
  return source;
}

void require_answer(const std::string& query, const Scene& scene, const std::string& file) try {
  exact_vector(query, scene);
} catch (const InputError& error) {
  throw InputError(file, std::string("no exact answer: ") + error.what());
}

std::map<std::string, std::vector<TestVector>> given_cases(const VectorsCommand& command) {
  std::map<std::string, std::vector<TestVector>> given;
  for (const std::string& file : command.cases) {
    oracle::Case a_case = oracle::read_case(file);
    const std::string& query = properties::find(a_case.property).query;
    TestVector vector{reference::completed(a_case.scene), source_of(a_case)};
    require_answer(query, vector.scene, file);
    given[query].push_back(std::move(vector));
  }
  return given;
}

void add_draws(std::vector<TestVector>& all, const std::string& query, const VectorsCommand& command) {
  if (command.draws == 0) return;
  for (const auto* families : {&properties::families(), &properties::extremes()}) {
    for (const properties::Family* family : properties::for_query(*families, query)) {
      std::ranges::move(drawn_vectors(query, *family, command.seed, command.draws), std::back_inserter(all));
    }
  }
}

struct NewText {
  std::string file;
  std::string text;
  std::size_t count = 0;  ///< of vectors
};

std::vector<NewText> new_texts(const VectorsCommand& command) {
  const std::map<std::string, std::vector<TestVector>> given = given_cases(command);
  std::vector<NewText> texts;
  Progress progress("answering", static_cast<int>(queries_of(command).size()));
  for (const std::string& query : queries_of(command)) {
    progress.step(query);
    const std::string file = vectors_file(command.folder, query);
    std::vector<TestVector> all = read_vectors(file);
    if (const auto more = given.find(query); more != given.end()) {
      all.insert(all.end(), more->second.begin(), more->second.end());
    }
    add_draws(all, query, command);
    if (all.empty()) continue;
    try {
      all = distinct(std::move(all));
      texts.push_back({file, text_of_vectors(query, all), all.size()});
    } catch (const InputError& error) {
      throw InputError(file, error.what());
    }
  }
  return texts;
}

int check(const std::vector<NewText>& texts) {
  int differ = 0;
  for (const NewText& written : texts) {
    if (read_text(written.file) == written.text) continue;
    ++differ;
    complain("{}: differs from what `touchstone vectors` would write", written.file);
  }
  return differ > 0 ? 1 : 0;
}

void write_page(const std::vector<NewText>& texts, const std::string& page) {
  std::vector<Json> files;
  for (const NewText& written : texts) files.push_back(parse(written.text, written.file));
  write_text(page, vectors_page(files));
  print("{}\n", page);
}

}  // namespace

int vectors(const VectorsCommand& command) {
  if (!fs::is_directory(command.folder)) {
    throw InputError(command.folder, "is no folder; make it first, or name the one with the test vectors");
  }
  const std::vector<NewText> texts = new_texts(command);
  if (command.check) return check(texts);
  require_writable_folder(command.folder, command.folder);
  if (!command.page.empty()) require_writable_file(command.page);
  for (const NewText& written : texts) {
    write_text(written.file, written.text);
    print("{}: {} test vectors\n", written.file, written.count);
  }
  if (!command.page.empty()) write_page(texts, command.page);
  return 0;
}

}  // namespace touchstone::app
