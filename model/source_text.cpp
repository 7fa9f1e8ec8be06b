// Finds the place of a JSON path in a text. Runs only after an error, so that reading itself need not record positions.
#include "model/source_text.h"

#include <algorithm>
#include <charconv>
#include <optional>

namespace touchstone {
namespace {

/// One step of a JSON path: a key, or an index.
struct Step {
  std::string_view key;
  std::optional<std::size_t> index;
};

/// Splits a path: "bodies[3].shape" has the steps bodies, 3, shape.
std::vector<Step> steps_of(std::string_view path) {
  std::vector<Step> steps;
  while (!path.empty()) {
    if (path.front() == '.') path.remove_prefix(1);
    if (path.starts_with('[')) {
      std::size_t index = 0;
      std::from_chars(path.data() + 1, path.data() + path.size(), index);
      steps.push_back({{}, index});
      path.remove_prefix(std::min(path.find(']'), path.size() - 1) + 1);
    } else {
      const std::string_view key = path.substr(0, path.find_first_of(".["));
      if (key.empty()) break;
      steps.push_back({key, std::nullopt});
      path.remove_prefix(key.size());
    }
  }
  return steps;
}

/// What a message is about.
struct About {
  std::vector<Step> path;   ///< empty: the whole text
  std::optional<Step> key;  ///< a key that is present or missing there
};

std::optional<Step> key_named_by(std::string_view reason) {
  for (const std::string_view words : {"unknown key \"", "the key \""}) {
    if (!reason.starts_with(words)) continue;
    reason.remove_prefix(words.size());
    return Step{reason.substr(0, reason.find('"')), std::nullopt};
  }
  return std::nullopt;
}

About about(std::string_view message) {
  const std::optional<Step> key = key_named_by(message);
  const auto colon = message.find(": ");
  if (key || colon == std::string_view::npos) return {{}, key};
  const std::string_view path = message.substr(0, message.find_first_of(" :"));  // also of "bodies[2] (wheel): ..."
  return {steps_of(path), key_named_by(message.substr(colon + 2))};
}

/// Scans text that is JSON at least as far as its reader came; never goes beyond its end.
class Cursor {
 public:
  explicit Cursor(std::string_view text) : text_(text) {
    skip_space();
    start_ = at_;
  }

  std::size_t offset() const { return at_; }
  bool is_at_start() const { return at_ == start_; }

  /// Moves from the start of a value to the start of an item or member of it; returns false, without moving, if there
  /// is none. Of several equal keys it takes the last.
  bool enter(const Step& step) {
    Cursor item = *this;
    if (item.next() != (step.index ? '[' : '{')) return false;
    std::optional<std::size_t> found;
    for (std::size_t i = 0;; ++i) {
      item.advance(1);
      item.skip_space();
      if (!step.index && item.next() != '"') break;
      const std::string_view key = step.index ? std::string_view{} : item.skip_string();
      if (!step.index && !item.skip_colon()) break;
      if (item.next() == '\0' || item.next() == ']') break;
      if (step.index ? i == *step.index : key == step.key) found = item.at_;
      if (found && step.index) break;
      item.skip_value();
      if (item.next() != ',') break;
    }
    if (found) at_ = *found;
    return found.has_value();
  }

 private:
  char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void advance(std::size_t by) { at_ = std::min(at_ + by, text_.size()); }
  void skip_to(std::size_t place) { at_ = std::min(place, text_.size()); }
  void skip_space() { skip_to(text_.find_first_not_of(" \t\r\n", at_)); }

  bool skip_colon() {
    skip_space();
    if (next() != ':') return false;
    advance(1);
    skip_space();
    return true;
  }

  /// Skips from an opening quote to behind the closing one; returns the text between them.
  std::string_view skip_string() {
    const std::size_t begin = at_ + 1;
    for (advance(1); at_ < text_.size() && next() != '"';) advance(next() == '\\' ? 2 : 1);
    const std::string_view inside = text_.substr(begin, at_ - begin);
    advance(1);
    return inside;
  }

  /// Skips a value and the space behind it.
  void skip_value() {
    int open = 0;
    do {
      const char c = next();
      if (c == '[' || c == '{') ++open;
      if (c == ']' || c == '}') --open;
      if (c == '"') {
        skip_string();
      } else if (std::string_view("[]{},:").find(c) != std::string_view::npos) {
        advance(1);
      } else {
        skip_to(text_.find_first_of(" \t\r\n[]{},:\"", at_));
      }
      skip_space();
    } while (open > 0 && at_ < text_.size());
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t start_ = 0;
};

/// Cuts the end off a message that may quote any text of any length.
std::string cut_to_length(const std::string& message) {
  constexpr std::size_t longest = 600;
  if (message.size() <= longest) return message;
  std::size_t end = longest;  // moved back to a boundary between UTF-8 characters
  while (end > 0 && (static_cast<unsigned char>(message[end]) & 0xC0) == 0x80) --end;
  return message.substr(0, end) + " ...";
}

}  // namespace

std::string line_and_column(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const auto line_start = before.rfind('\n') + 1;  // npos + 1 = 0
  const auto is_character = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
  const auto line = std::count(before.begin(), before.end(), '\n');
  const auto column =
      std::count_if(before.begin() + static_cast<std::ptrdiff_t>(line_start), before.end(), is_character);
  return std::to_string(line + 1) + ':' + std::to_string(column + 1);
}

InputError located(const InputError& error, std::string_view json, const std::string& file) {
  const std::string what = error.what();
  const About it = about(what);
  Cursor cursor(json);
  bool is_there = true;
  for (std::size_t i = 0; i < it.path.size() && is_there; ++i) is_there = cursor.enter(it.path[i]);
  if (is_there && it.key) cursor.enter(*it.key);
  if (!is_there && cursor.is_at_start()) return InputError(file, cut_to_length(what));  // the path does not exist
  return InputError((file.empty() ? "" : file + ':') + line_and_column(json, cursor.offset()), cut_to_length(what));
}

std::string without_byte_order_mark(std::string text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    throw InputError("", "text in UTF-16; expected UTF-8: save it as that");
  }
  return text;
}

SourceText read_source(const std::string& path) {
  const std::string name = path == "-" ? "<stdin>" : path;
  std::string text = read_text(path);
  try {
    return {name, without_byte_order_mark(std::move(text))};
  } catch (const InputError& error) {
    throw InputError(name, error.what());
  }
}

}  // namespace touchstone
