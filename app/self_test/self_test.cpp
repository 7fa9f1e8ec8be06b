#include "app/self_test/self_test.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "app/system/interruption.h"
#include "app/system/progress.h"
#include "app/system/terminal.h"
#include "app/trial/parallel.h"
#include "app/vectors/test_vector.h"
#include "model/input_error.h"
#include "properties/property.h"
#include "reference/validity.h"

namespace touchstone::app {
namespace {

constexpr double rounding = 1e-9;  // relative, of an allowance

bool is_rounded_otherwise(const std::string& path, const Json& published, const Json& computed) {
  const bool may_be = path == "/scale" || path.starts_with("/allowed/");
  return may_be && published.is_number() && computed.is_number() &&
         std::abs(published.get<double>() - computed.get<double>()) <= rounding * std::abs(published.get<double>());
}

std::string text_at(const Json& json, const std::string& path) {
  const Json::json_pointer place(path);
  return json.contains(place) ? json.at(place).dump() : "nothing";
}

/// As text and back, since a number beyond the doubles is published as null.
Json computed_again(const std::string& query, const Json& published) {
  const Scene scene = reference::completed(read<Scene>(published["scene"], "scene"));
  return Json::parse(vector_json(query, {scene, published["source"]}).dump());
}

std::vector<PublishedVector> vectors_of(const std::vector<std::string>& queries) {
  std::vector<PublishedVector> chosen;
  std::ranges::copy_if(published_vectors(), std::back_inserter(chosen),
                       [&](const PublishedVector& vector) { return std::ranges::count(queries, vector.query) > 0; });
  return chosen;
}

std::string words_of(const OtherAnswer& other) {
  return fmt::format("{}: {}: {}; published: {}", other.id, other.place, other.computed, other.published);
}

}  // namespace

std::optional<OtherAnswer> other_answer(const PublishedVector& vector) {
  const Json published = Json::parse(vector.text);
  const std::string id = published["id"];
  try {
    const Json computed = computed_again(vector.query, published);
    for (const Json& change : Json::diff(published, computed)) {
      const std::string path = change["path"];
      if (change["op"] == "replace" &&
          is_rounded_otherwise(path, published.at(Json::json_pointer(path)), change["value"])) {
        continue;
      }
      return OtherAnswer{id, path.substr(1), text_at(published, path), text_at(computed, path)};
    }
  } catch (const InputError& error) {
    return OtherAnswer{id, "answer", published["answer"].dump(), error.what()};
  }
  return std::nullopt;
}

std::vector<OtherAnswer> other_answers(const std::vector<std::string>& queries, int jobs) {
  const std::vector<PublishedVector> asked = vectors_of(queries);
  std::vector<std::optional<OtherAnswer>> found(asked.size());
  Progress progress("self-test", static_cast<int>(asked.size()));
  in_parallel(asked.size(), jobs, [&](std::size_t piece, std::size_t) {
    if (interrupted()) return;
    found[piece] = other_answer(asked[piece]);
    progress.step(asked[piece].query);
  });
  std::vector<OtherAnswer> others;
  for (std::optional<OtherAnswer>& other : found) {
    if (other) others.push_back(std::move(*other));
  }
  return others;
}

void require_published_answers(const std::vector<std::string>& queries, int jobs) {
  const std::vector<OtherAnswer> others = other_answers(queries, jobs);
  if (others.empty()) return;
  throw std::runtime_error(
      fmt::format("the judge's own answers are wrong, so nothing is judged: {} of its test vectors, first {}",
                  others.size(), words_of(others.front())));
}

int self_test(const SelfTestCommand& command) {
  watch_for_interruption();
  const std::vector<std::string>& queries = command.queries.empty() ? properties::tested_queries() : command.queries;
  const std::vector<OtherAnswer> others = other_answers(queries, threads_of(command.jobs));
  if (interrupted()) return interrupted_exit_code();
  for (const std::string& query : queries) {
    const auto wrong =
        std::ranges::count_if(others, [&](const OtherAnswer& other) { return other.id.starts_with(query + '-'); });
    print("{}: {} test vectors, {} answered otherwise than published\n", query, vectors_of({query}).size(), wrong);
  }
  for (const OtherAnswer& other : others) complain("{}", words_of(other));
  return others.empty() ? 0 : fault_exit_code;
}

}  // namespace touchstone::app
