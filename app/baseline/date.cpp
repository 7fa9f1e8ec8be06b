#include "app/baseline/date.h"

#include <fmt/format.h>

#include <cctype>

namespace touchstone::app {

std::optional<Date> date_of(const std::string& text) {
  constexpr std::string_view form = "dddd-dd-dd";
  if (text.size() != form.size()) return std::nullopt;
  for (std::size_t i = 0; i < form.size(); ++i) {
    const bool digit = std::isdigit(static_cast<unsigned char>(text[i])) != 0;
    if (form[i] == 'd' ? !digit : text[i] != '-') return std::nullopt;
  }
  const Date date(std::chrono::year(std::stoi(text.substr(0, 4))),
                  std::chrono::month(static_cast<unsigned>(std::stoi(text.substr(5, 2)))),
                  std::chrono::day(static_cast<unsigned>(std::stoi(text.substr(8, 2)))));
  return date.ok() ? std::optional(date) : std::nullopt;
}

std::string text_of(const Date& date) {
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                     static_cast<unsigned>(date.day()));
}

Date today() { return std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now()); }

}  // namespace touchstone::app
