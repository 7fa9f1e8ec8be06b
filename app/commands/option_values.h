// Checks the values of options. CLI11's own conversions read 010 as 8 and 1e3 as a number of pairs, and its ranges go
// through a double.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <concepts>
#include <functional>
#include <string>
#include <vector>

namespace touchstone::app {

/// Reads a word of decimal digits. Throws an exception that says what was expected.
template <std::integral Number>
Number whole_number(const std::string& option, const std::string& word, Number least, Number most) {
  Number number{};
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, number);
  if (error != std::errc{} || stop != end || number < least || number > most) {
    throw CLI::ValidationError(option,
                               fmt::format("expected a whole number from {} to {}, found \"{}\"", least, most, word));
  }
  return number;
}

/// If the option is not given, `value` keeps its value.
template <std::integral Number>
CLI::Option* add_whole_number(CLI::App& command, const std::string& option, Number& value, Number least, Number most,
                              const std::string& description) {
  const auto read = [=, &value](const std::string& word) { value = whole_number(option, word, least, most); };
  return command.add_option_function<std::string>(option, read, description)->type_name("NUMBER");
}

/// A check for CLI11: returns an empty text, or what is wrong with the word.
using Check = std::function<std::string(const std::string& word)>;

/// Accepts a number above 0 and at most `most`.
Check seconds_up_to(double most);

Check one_of(const std::vector<std::string>& names);

/// "--seed", "--help", ...
std::vector<std::string> option_names(const CLI::App& command);

}  // namespace touchstone::app
