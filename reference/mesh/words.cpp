#include "reference/mesh/words.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <system_error>

namespace touchstone::reference {
namespace {

std::string in_quotes(std::string_view word) {
  return word.empty() ? "the end of the line" : '"' + std::string(word.substr(0, 40)) + '"';
}

/// The whole word.
template <class Number>
std::errc convert(std::string_view word, Number& number) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return end == word.data() + word.size() ? error : std::errc::invalid_argument;
}

bool is_zero(std::string_view word) {
  return word.substr(0, word.find_first_of("eE")).find_first_of("123456789") == std::string_view::npos;
}

}  // namespace

void MeshWords::expect_text() const {
  const auto nul = text_.find('\0');
  if (nul != std::string_view::npos) throw MeshError("a NUL byte; expected text", nul);
}

void MeshWords::skip_space(const char* space) { at_ = std::min(text_.find_first_not_of(space, at_), text_.size()); }

std::string_view MeshWords::take_word() {
  last_word_ = at_;
  const char ends[] = {' ', '\t', '\r', '\v', '\f', '\n', comment_};
  const auto end = std::min(text_.find_first_of(std::string_view(ends, sizeof ends), at_), text_.size());
  at_ = end;
  return text_.substr(last_word_, end - last_word_);
}

std::string_view MeshWords::word_of_line() {
  skip_space(" \t\r\v\f");
  return take_word();
}

std::string_view MeshWords::word() {
  skip_space(" \t\r\v\f\n");
  return take_word();
}

void MeshWords::skip_line() {
  const auto end = text_.find('\n', at_);
  at_ = end == std::string_view::npos ? text_.size() : end + 1;
}

bool MeshWords::skip_to_word() {
  for (; !is_at_end(); skip_line()) {
    const std::size_t before = at_;
    const bool has_word = !word_of_line().empty();
    if (has_word) {
      at_ = before;
      return true;
    }
  }
  last_word_ = at_;
  return false;
}

bool MeshWords::copy_bytes(char* to, std::size_t count) {
  if (text_.size() - at_ < count) return false;
  std::memcpy(to, text_.data() + at_, count);
  at_ += count;
  return true;
}

double MeshWords::number(std::string_view word) const {
  double number = 0;
  const std::errc error = convert(word, number);
  if (error == std::errc::invalid_argument) refuse("expected a number, found " + in_quotes(word));
  if (error == std::errc::result_out_of_range) number = std::strtod(std::string(word).c_str(), nullptr);
  if (!std::isfinite(number)) refuse("expected a number that a double can hold, found " + in_quotes(word));
  if (number == 0 && !is_zero(word)) {
    refuse("too small for a double, found " + in_quotes(word) + ": it would be read as 0");
  }
  return number;
}

std::size_t MeshWords::count(std::string_view word) const {
  std::size_t number = 0;
  if (convert(word, number) != std::errc{}) refuse("expected a number of items, found " + in_quotes(word));
  return number;
}

Vec3 MeshWords::point_of_line() {
  const double x = number(word_of_line());
  const double y = number(word_of_line());
  const double z = number(word_of_line());
  return {x, y, z};
}

void MeshWords::refuse(const std::string& why) const { throw MeshError(why, last_word_); }

}  // namespace touchstone::reference
