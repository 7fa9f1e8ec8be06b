#include "app/commands/option_values.h"

#include <algorithm>

#include "model/near_names.h"

namespace touchstone::app {

Check seconds_up_to(double most) {
  return [most](const std::string& word) -> std::string {
    double seconds = 0;
    const char* const end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, seconds);
    if (error == std::errc{} && stop == end && seconds > 0 && seconds <= most) return "";  // NaN is not > 0
    return fmt::format("expected seconds, above 0 and at most {}, found \"{}\"", most, word);
  };
}

Check one_of(const std::vector<std::string>& names) {
  return [names](const std::string& word) -> std::string {
    return std::ranges::count(names, word) > 0 ? "" : fmt::format("\"{}\" is {}", word, unknown_among(word, names));
  };
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    if (option->nonpositional()) names.push_back(option->get_name());
  }
  return names;
}

}  // namespace touchstone::app
