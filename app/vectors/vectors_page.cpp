#include "app/vectors/vectors_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "app/report/page/page.h"
#include "app/report/page/picture.h"
#include "app/report/page/style.h"
#include "app/report/page/turn_script.h"
#include "app/report/xml.h"

namespace touchstone::app {
namespace {

constexpr std::size_t most_shown = 1500;  ///< characters of an answer; a choice: the file has all of it

/// "family boxes.tiny_gap, seed 1, index 3"; the source of a case in the same form.
std::string words_of_source(const Json& source) {
  std::vector<std::string> words;
  for (const auto& [key, value] : source.items()) {
    if (key == "smaller_than") {
      words.push_back("made smaller from " + words_of_source(value));
    } else {
      words.push_back(key + ' ' + (value.is_string() ? value.get<std::string>() : value.dump()));
    }
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string card(const Json& test) {
  std::string answer = touchstone::text_of(test["answer"]);
  if (answer.size() > most_shown) answer = answer.substr(0, most_shown) + "...\n";
  const std::vector<std::string> classes = test["classes"];
  const std::string id = test["id"];
  return fmt::format(
      "<section class=\"card\" id=\"{0}\"><h3><a href=\"#{0}\">{0}</a></h3><p class=\"soft\">{1}</p>{2}"
      "<p class=\"soft\">{3}</p><details><summary>exact answer</summary><pre "
      "tabindex=\"0\">{4}</pre></details></section>\n",
      id, escaped(fmt::format("{}", fmt::join(classes, ", "))), picture(read<Scene>(test["scene"], id)),
      escaped(words_of_source(test["source"])), escaped(answer));
}

std::string section(const Json& file) {
  const std::string query = file["query"];
  std::string cards;
  for (const Json& test : file["tests"]) cards += card(test);
  return fmt::format("<h2 id=\"{0}\">{0}</h2><details><summary>{1}</summary><div class=\"cards\">{2}</div></details>\n",
                     query, page::plural(static_cast<long>(file["tests"].size()), "test vector"), cards);
}

/// A link to a vector opens the query that it is in.
constexpr const char* script = R"js(
function reveal() {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  const around = target && target.closest('details');
  if (around) { around.open = true; target.scrollIntoView(); }
}
addEventListener('hashchange', reveal);
reveal();
)js";

}  // namespace

std::string vectors_page(const std::vector<Json>& files) {
  std::string contents, sections;
  for (const Json& file : files) {
    contents += fmt::format("<a href=\"#{0}\">{0}</a> ", file["query"].get<std::string>());
    sections += section(file);
  }
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width,initial-scale=1\"><link rel=\"icon\" href=\"data:,\"><title>Touchstone test "
      "vectors</title><style>{}\npre{{font-size:.75rem;overflow:auto;max-height:20rem}}</style></head><body><main>"
      "<h1>Test vectors</h1><p class=\"lead\">Scenes and their exact answers. Body A is drawn solid, body B dashed, "
      "the exact closest points as dots. A body with more than {} vertices is not drawn.</p><nav "
      "aria-label=\"Contents\">{}</nav>{}</main><script>{}{}</script></body></html>\n",
      report_style, most_drawn, contents, sections, script, turn_script);
}

}  // namespace touchstone::app
