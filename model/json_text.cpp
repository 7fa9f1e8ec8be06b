// Converts text to JSON and back.
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <vector>

#include "model/answer_text.h"
#include "model/json.h"
#include "model/source_text.h"

namespace touchstone {
namespace {

/// The document with the most levels, a case about a body of several hulls, has 10: case, scene, bodies, body, shape,
/// parts, part, shape, vertices, vertex. A deeper document is none of ours, and walking over it would use up the stack.
constexpr std::size_t deepest = 16;

/// The largest object of our formats counts a property's errors in a report: "0", "inf" and the powers of two from
/// 2⁻¹⁰⁷⁴ to 2¹⁰²⁴. A lookup goes through all members, which is slow in a larger object.
constexpr std::size_t most_keys = 2 + 1074 + 1 + 1024;

std::string shortened(const std::string& word) {
  constexpr std::size_t longest = 60;
  return word.size() <= longest ? word : word.substr(0, longest) + "...";
}

/// Shortens "[json.exception.parse_error.101] parse error at line 1, column 5: syntax error ..." to the part from
/// "syntax" on, and makes it printable, since it may quote any bytes of any length.
std::string readable(std::string message) {
  for (const std::string words : {"] ", ": "}) {
    const auto at = message.find(words);
    if (at != std::string::npos) message.erase(0, at + words.size());
  }
  std::replace_if(
      message.begin(), message.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80; }, '?');
  constexpr std::size_t longest = 300;
  return message.size() <= longest ? message : message.substr(0, longest) + " ...";
}

/// What is wrong with a text, before its file is known: an error about a JSON path or about an offset.
struct Flaw {
  InputError error;
  std::optional<std::size_t> offset;
};

/// What an integer means that no double equals. A scene means exactly its numbers, so there it is refused.
enum class Integers { exact, nearest_double };

/// A value while it is built: the open objects and arrays, and the place of the next value.
class Draft {
 public:
  explicit Draft(std::size_t most_values) : most_values_(most_values) {}

  Json take() { return std::move(root_); }

  template <class Value>
  void add(Value&& value) {
    if (++values_ > most_values_) {
      throw Flaw{InputError("", "more than " + std::to_string(most_values_) + " values"), {}};
    }
    slot() = std::forward<Value>(value);
  }

  void open(Json&& empty) {
    if (open_.size() == deepest) refuse_next("nested deeper than " + std::to_string(deepest) + " levels");
    add(std::move(empty));
    open_.push_back(last_);
  }

  void close() { open_.pop_back(); }

  /// Begins a member of the innermost open object.
  void add_key(std::string&& key) {
    auto& members = open_.back()->get_ref<Json::object_t&>();
    if (members.find(key) != members.end()) {
      throw Flaw{InputError(place(false), "the key " + shortened(Json(key).dump()) + " stands twice in one object"),
                 {}};
    }
    if (members.size() == most_keys) {
      throw Flaw{InputError(place(false), "more than " + std::to_string(most_keys) + " keys in one object"), {}};
    }
    members.emplace_back(std::move(key), nullptr);
  }

  /// The path of the innermost open value, or of the next value in it.
  std::string place(bool of_next) const {
    std::string path;
    for (std::size_t i = 0; i < open_.size(); ++i) {
      const bool is_innermost = i + 1 == open_.size();
      if (is_innermost && !of_next) break;
      if (open_[i]->is_array()) {
        path += '[' + std::to_string(open_[i]->size() - (is_innermost ? 0 : 1)) + ']';
      } else if (const auto& members = open_[i]->get_ref<const Json::object_t&>(); !members.empty()) {
        path += (path.empty() ? "" : ".") + shortened(members.back().first);
      }
    }
    return path;
  }

  [[noreturn]] void refuse_next(const std::string& what_is_wrong) const {
    throw Flaw{InputError(place(true), what_is_wrong), {}};
  }

 private:
  /// Where the next value goes. Only the innermost open value grows, so pointers to the outer ones stay valid.
  Json& slot() {
    if (open_.empty()) {
      last_ = &root_;
    } else if (auto* items = open_.back()->get_ptr<Json::array_t*>()) {
      last_ = &items->emplace_back();
    } else {
      last_ = &open_.back()->get_ref<Json::object_t&>().back().second;
    }
    return *last_;
  }

  Json root_;
  Json* last_ = nullptr;
  std::vector<Json*> open_;
  std::size_t values_ = 0;
  std::size_t most_values_;
};

std::string exactly(double integer) {
  std::array<char, 400> digits{};
  std::snprintf(digits.data(), digits.size(), "%.0f", integer);
  return digits.data();
}

/// Builds the value from the parser's events. Refuses what JSON's grammar allows and our formats do not.
class Builder final : public nlohmann::json_sax<Json> {
 public:
  Builder(std::string_view text, std::size_t most_values, Integers integers)
      : draft_(most_values), text_(text), integers_(integers) {}

  Json take() { return draft_.take(); }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(Json::number_integer_t value) override { return add_integer(value); }
  bool number_unsigned(Json::number_unsigned_t value) override { return add_integer(value); }
  bool string(std::string& value) override { return add(std::move(value)); }
  bool binary(Json::binary_t&) override { return false; }  // JSON text has no binary values

  bool number_float(double value, const std::string& digits) override {
    if (value == 0 && digits.substr(0, digits.find_first_of("eE")).find_first_of("123456789") != std::string::npos) {
      draft_.refuse_next("too small for a double, found " + shortened(digits) + ": it would be read as 0");
    }
    // An integer that does not fit in 64 bits.
    constexpr double room = 0x1p63;
    if (integers_ == Integers::exact && std::abs(value) >= room && digits.find_first_of(".eE") == std::string::npos &&
        digits != exactly(value)) {
      draft_.refuse_next("the integer " + shortened(digits) +
                         " is not a double; write it with a decimal point to have it rounded");
    }
    return add(value);
  }

  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(std::string& key) override {
    draft_.add_key(std::move(key));
    return true;
  }

  bool parse_error(std::size_t position, const std::string& last, const Json::exception& error) override {
    constexpr int out_of_range = 406;
    if (error.id == out_of_range) draft_.refuse_next("too great for a double, found " + shortened(last));
    if (const std::string word = not_finite_at(position); !word.empty()) {
      draft_.refuse_next("expected a finite number, found " + word);
    }
    throw Flaw{InputError(draft_.place(false), readable(error.what())), position > 0 ? position - 1 : 0};
  }

 private:
  /// Returns the word for NaN or infinity, which JSON lacks, that the parser stopped in: after its first letter, or
  /// after its second one where the first one may also begin "null" or a number. Else "".
  std::string not_finite_at(std::size_t position) const {
    for (const std::size_t read : {2, 1}) {
      const std::string_view rest = text_.substr(std::min(text_.size(), position - std::min(position, read)));
      for (const std::string_view word : {"NaN", "nan", "-nan", "-NaN", "Infinity", "-Infinity", "inf", "-inf"}) {
        const bool ends =
            rest.size() <= word.size() || std::isalnum(static_cast<unsigned char>(rest[word.size()])) == 0;
        if (rest.starts_with(word) && ends) return std::string(word);
      }
    }
    return "";
  }

  /// Only up to 2^53 is every integer a double.
  template <class Integer>
  bool add_integer(Integer value) {
    const auto nearest = static_cast<double>(value);
    return integers_ == Integers::nearest_double && std::abs(nearest) >= 0x1p53 ? add(nearest) : add(value);
  }

  template <class Value>
  bool add(Value&& value) {
    draft_.add(std::forward<Value>(value));
    return true;
  }

  bool open(Json&& empty) {
    draft_.open(std::move(empty));
    return true;
  }

  bool close() {
    draft_.close();
    return true;
  }

  Draft draft_;
  std::string_view text_;
  Integers integers_;
};

/// Finds a string or a number that is too long, since the parser makes several copies of each. Returns its offset.
std::optional<std::size_t> long_word(std::string_view text) {
  constexpr std::size_t longest = 1'000'000;
  bool is_in_string = false;
  for (std::size_t i = 0, begin = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') {
      is_in_string = !is_in_string;
      begin = is_in_string ? i : i + 1;
    } else if (is_in_string) {
      if (c == '\\') ++i;
    } else if (std::string_view(" \t\r\n,:[]{}").find(c) != std::string_view::npos) {
      begin = i + 1;
    }
    if (i > begin + longest) return begin;
  }
  return std::nullopt;
}

Json parsed(std::string_view text, const std::string& file, std::size_t most_values, Integers integers) try {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) throw InputError(file, "empty; expected JSON");
  // The parser takes a NUL byte for the end of the text.
  const auto nul = text.find('\0');
  if (nul != std::string_view::npos) throw Flaw{InputError("", "a NUL byte; expected text"), nul};
  Builder builder(text, most_values, integers);
  Json::sax_parse(text, &builder);
  return builder.take();
} catch (const Flaw& flaw) {
  if (!flaw.offset) throw located(flaw.error, text, file);
  throw InputError((file.empty() ? "" : file + ':') + line_and_column(text, *flaw.offset), flaw.error.what());
}

std::string compact(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

void append(std::string& text, const Json& json, std::size_t indent) {
  constexpr std::size_t line = 110;
  const std::string whole = compact(json);
  if (!json.is_structured() || indent + whole.size() <= line) {
    text += whole;
    return;
  }
  text += json.is_object() ? '{' : '[';
  const char* separator = "\n";
  for (auto item = json.begin(); item != json.end(); ++item) {
    text += separator + std::string(indent + 2, ' ');
    if (json.is_object()) text += compact(item.key()) + ": ";
    append(text, *item, indent + 2);
    separator = ",\n";
  }
  text += '\n' + std::string(indent, ' ') + (json.is_object() ? '}' : ']');
}

}  // namespace

Json parse(std::string_view text, const std::string& place) {
  return parsed(text, place, std::numeric_limits<std::size_t>::max(), Integers::exact);
}

Json parse_answer(std::string_view line, const std::string& place) {
  return parsed(line, place, std::numeric_limits<std::size_t>::max(), Integers::nearest_double);
}

Json parse_document(std::string_view text, const std::string& file) {
  constexpr std::size_t most_values = 2'000'000;  // 150 MB of memory; 500,000 vertices
  if (const auto at = long_word(text)) {
    throw InputError(file + ':' + line_and_column(text, *at), "a string or a number of more than 1 MB");
  }
  return parsed(text, file, most_values, Integers::exact);
}

std::string text_of(const Json& json) {
  std::string text;
  append(text, json, 0);
  return text + '\n';
}

}  // namespace touchstone
