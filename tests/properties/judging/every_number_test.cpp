// Which property sees that one number of an answer is wrong? A canary for each number, and a page that shows it. A
// property that no longer looks at a component, a body, a sample or an event sees fewer of them than the page says.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "model/input_error.h"
#include "oracle/passing_on.h"
#include "oracle/process/protocol.h"
#include "oracle/query.h"
#include "oracle/subjects/touchstone/fast.h"
#include "properties/judging/remembered_answers.h"
#include "properties/property.h"
#include "tests/catch.h"
#include "tests/properties/generated_page.h"
#include "tests/properties/scenes.h"

namespace touchstone::properties {
namespace {

/// Of a trajectory so few numbers are changed, in turn: each costs all properties.
constexpr std::size_t numbers_of_a_trajectory = 60;

/// The numbers of an answer that are no indices: JSON pointers.
std::vector<std::string> numbers_of(const Json& answer) {
  std::vector<std::string> places;
  const Json flat = answer.flatten();
  for (const auto& [place, value] : flat.items()) {
    if (value.is_number_float()) places.push_back(place);
  }
  return places;
}

/// An eighth of the greatest number beside it, or 1/8.
double error_at(const Json& answer, const Json::json_pointer& place) {
  double greatest = 0;
  for (const Json& beside : answer.at(place.parent_pointer())) {
    if (beside.is_number()) greatest = std::max(greatest, std::abs(beside.get<double>()));
  }
  return greatest > 0 ? greatest / 8 : 0.125;
}

/// Says truthfully what another subject does, but for one number of every answer to one query.
class WrongNumber final : public oracle::PassingOn<WrongNumber> {
 public:
  WrongNumber(oracle::Subject& truthful, const std::string& place) : PassingOn(truthful), place_(place) {}

 private:
  friend PassingOn;

  template <class T>
  Answer<T> pass(oracle::QueryFunction<T> query, const Scene& scene) {
    Answer<T> answer = (subject_.*query)(scene);
    if (const T* said = std::get_if<T>(&answer)) {
      Json json = touchstone::json_of(*said);
      if (!json.contains(place_) || !json[place_].is_number_float()) return answer;
      json[place_] = json[place_].get<double>() + error_at(json, place_);
      return oracle::protocol::read_answer<T>(oracle::protocol::answer(1, json), 1);
    }
    return answer;
  }

  Json::json_pointer place_;
};

/// null for a scene that the query is not about, or no answer.
Json answer_to(const std::string& query, oracle::Subject& subject, const Scene& scene) try {
  return std::visit(
      [&]<class T>(oracle::QueryFunction<T> ask) {
        const Answer<T> answer = (subject.*ask)(scene);
        const T* said = std::get_if<T>(&answer);
        return said == nullptr ? Json() : touchstone::json_of(*said);
      },
      oracle::find_query(query)->ask);
} catch (const InputError&) {
  return nullptr;
}

/// "states/2/1/X_WB/p/0" is one of "states/*/*/X_WB/p/0": an index before a name counts bodies, samples or events.
std::string kind_of(const std::string& place) {
  std::vector<std::string> words;
  for (std::size_t begin = 1; begin <= place.size();) {
    const std::size_t end = std::min(place.find('/', begin), place.size());
    words.push_back(place.substr(begin, end - begin));
    begin = end + 1;
  }
  const auto is_index = [](const std::string& word) { return std::isdigit(static_cast<unsigned char>(word[0])) != 0; };
  std::string kind;
  bool named = false;
  for (auto word = words.rbegin(); word != words.rend(); ++word) {
    named = named || !is_index(*word);
    kind = (named && is_index(*word) ? "*" : *word) + (kind.empty() ? "" : "/") + kind;
  }
  return kind;
}

/// How many wrong numbers of a kind a property was asked about, and how many it saw.
struct Seen {
  int asked = 0;
  int seen = 0;
};

using Kinds = std::map<std::string, std::map<std::string, Seen>>;  // by kind and property

void ask_about(const std::string& query, const Scene& scene, const std::vector<std::string>& places,
               oracle::Subject& truthful, Kinds& kinds) {
  for (const Property& property : all()) {
    if (property.query != query || asks_twice(property) || property.id.ends_with(".survives")) continue;
    if (property.check(scene, truthful).outcome != oracle::Outcome::holds) continue;
    for (const std::string& place : places) {
      WrongNumber wrong(truthful, place);
      Seen& seen = kinds[kind_of(place)][property.id];
      ++seen.asked;
      seen.seen += oracle::failed(property.check(scene, wrong)) ? 1 : 0;
    }
  }
}

/// A few numbers of each scene, others in the next one.
std::vector<std::string> some_of(std::vector<std::string> places, std::size_t most, std::size_t turn) {
  if (places.size() <= most) return places;
  std::vector<std::string> some;
  for (std::size_t k = 0; k < most; ++k) some.push_back(places[(k * places.size() / most + turn) % places.size()]);
  return some;
}

std::string rows(const std::string& query) {
  const bool is_trajectory = query == "simulation" || query == "constraint";
  const auto fast = oracle::subjects::make_fast();
  Kinds kinds;
  std::size_t turn = 0;
  for (const Scene& scene : tests::scenes_of(query)) {
    RememberedAnswers truthful(*fast);
    const std::vector<std::string> places = numbers_of(answer_to(query, truthful, scene));
    ask_about(query, scene, is_trajectory ? some_of(places, numbers_of_a_trajectory, turn++) : places, truthful, kinds);
  }
  std::string text;
  for (const auto& [kind, by_property] : kinds) {
    text += "| `" + query + "` | `" + kind + "` | ";
    std::string seers;
    for (const auto& [property, seen] : by_property) {
      if (seen.seen == 0) continue;
      seers += (seers.empty() ? "`" : ", `") + property + "` " + std::to_string(seen.seen) + '/' +
               std::to_string(seen.asked);
    }
    text += (seers.empty() ? "none" : seers) + " |\n";
  }
  return text;
}

std::string page() {
  std::string page =
      "# Which number is judged by which property\n\n"
      "For each number of an answer the properties that fail if it alone is wrong, by an eighth of the greatest "
      "number\n"
      "beside it: of how many wrong answers of `fast` about the scenes made by hand. An index before a name, of a "
      "body, a\n"
      "sample or an event, is written `*`. Made by `tests/properties/judging/every_number_test.cpp`; a change here "
      "changes\n"
      "what the judge sees. To make it anew: `TOUCHSTONE_UPDATE=1 ./touchstone test -R \"one number\"`.\n\n"
      "| query | number | seen by |\n|---|---|---|\n";
  for (const std::string& query : tested_queries()) {
    if (query != "broad_phase" && query != "pixel") page += rows(query);  // their answers have no such numbers
  }
  return page;
}

TEST_CASE("each canary about one number of an answer is seen by the properties that the page says") {
  const std::string made = page();
  CHECK(tests::committed_page("judged_numbers.md", made) == made);
}

}  // namespace
}  // namespace touchstone::properties
