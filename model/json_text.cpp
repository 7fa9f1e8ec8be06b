// Text to JSON and back.
#include <algorithm>
#include <functional>
#include <set>
#include <vector>

#include "model/json.h"

namespace touchstone {
namespace {

/// Refuses a key that stands twice in one object: readers differ in which of the two they would take.
class UniqueKeys {
 public:
  bool operator()(int, Json::parse_event_t event, const Json& parsed) {
    if (event == Json::parse_event_t::object_start) open_.emplace_back();
    if (event == Json::parse_event_t::object_end) open_.pop_back();
    if (event == Json::parse_event_t::key && !open_.back().insert(parsed.get<std::string>()).second) {
      throw InputError("", "the key " + parsed.dump() + " stands twice in one object");
    }
    return true;
  }

 private:
  std::vector<std::set<std::string>> open_;
};

/// "[json.exception.parse_error.101] parse error at line 1, column 5: syntax error …" from "line" on; printable, as it
/// quotes what may be any bytes of any length.
std::string readable(std::string message) {
  for (const std::string words : {"] ", "parse error at "}) {
    const auto at = message.find(words);
    if (at != std::string::npos) message.erase(0, at + words.size());
  }
  std::replace_if(
      message.begin(), message.end(), [](char c) { return static_cast<unsigned char>(c) >= 0x80; }, '?');
  constexpr std::size_t longest = 300;
  return message.size() <= longest ? message : message.substr(0, longest) + " ...";
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

Json parse(std::string_view text, const std::string& place) try {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) throw InputError("", "empty; expected JSON");
  // By reference: the library copies the callback about.
  UniqueKeys unique_keys;
  return Json::parse(text, std::ref(unique_keys));
} catch (const Json::exception& error) {
  throw InputError(place, readable(error.what()));
} catch (const InputError& error) {
  throw InputError(place, error.what());
}

std::string text_of(const Json& json) {
  std::string text;
  append(text, json, 0);
  return text + '\n';
}

}  // namespace touchstone
