#include "model/json_node.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace touchstone {
namespace {

std::string in_quotes(std::string_view word) { return '"' + std::string(word) + '"'; }

std::string listed(std::initializer_list<std::string_view> words) {
  std::string list;
  for (const std::string_view word : words) list += (list.empty() ? "" : ", ") + in_quotes(word);
  return list;
}

std::string kind(const Json& json) {
  if (json.is_null()) return "null";
  if (json.is_object()) return "an object";
  if (json.is_array()) return "an array";
  if (json.is_string()) return "a string";
  if (json.is_boolean()) return json.get<bool>() ? "true" : "false";
  return json.dump();
}

bool is_not_finite(const std::string& word) {
  return word == "NaN" || word == "nan" || word == "Infinity" || word == "-Infinity" || word == "inf" || word == "-inf";
}

/// Keys of older files, and what they are called now.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> renamed_keys = {{{"flight", "motion"},
                                                                                        {"times", "sample_times"},
                                                                                        {"since", "start_times"},
                                                                                        {"pushes", "forces"},
                                                                                        {"meeting", "status"}}};

/// 2^64 and beyond do not fit in the integer type, so they are compared as doubles first.
template <class Integer>
bool is_exact(Integer integer, double nearest) {
  const double end = std::ldexp(1.0, std::numeric_limits<Integer>::digits);
  return nearest < end && static_cast<Integer>(nearest) == integer;
}

}  // namespace

void Node::expect_object(std::initializer_list<std::string_view> known) const {
  if (!json_.is_object()) refuse("expected an object, found " + kind(json_));
  for (const auto& [key, value] : json_.items()) {
    if (std::ranges::find(known, key) == known.end()) {
      const auto renamed = std::ranges::find(renamed_keys, key, &std::pair<std::string_view, std::string_view>::first);
      if (renamed != renamed_keys.end() && std::ranges::find(known, renamed->second) != known.end()) {
        refuse("the key " + in_quotes(key) + " is " + in_quotes(renamed->second) + " now");
      }
      refuse("unknown key " + in_quotes(key) + "; known are " + listed(known));
    }
  }
}

Node Node::at(std::string_view key) const {
  const std::optional<Node> found = find(key);
  if (!found) refuse("the key " + in_quotes(key) + " is missing");
  return *found;
}

std::optional<Node> Node::find(std::string_view key) const {
  if (!json_.is_object()) refuse("expected an object, found " + kind(json_));
  for (auto item = json_.begin(); item != json_.end(); ++item) {
    if (item.key() == key) return Node(item.value(), this, key, -1);
  }
  return std::nullopt;
}

std::vector<std::string> Node::keys() const {
  if (!json_.is_object()) refuse("expected an object, found " + kind(json_));
  std::vector<std::string> names;
  for (const auto& [key, value] : json_.items()) names.push_back(key);
  return names;
}

int Node::size() const {
  if (!json_.is_array()) refuse("expected an array, found " + kind(json_));
  if (json_.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) refuse("too many items");
  return static_cast<int>(json_.size());
}

void Node::expect_size(int expected) const {
  const int found = size();
  if (found != expected) refuse("expected " + std::to_string(expected) + " items, found " + std::to_string(found));
}

double Node::number() const {
  if (json_.is_string() && is_not_finite(json_.get<std::string>()))
    refuse("expected a finite number, found " + json_.dump());
  if (!json_.is_number()) refuse("expected a number, found " + kind(json_));
  const double nearest = json_.get<double>();
  if (!std::isfinite(nearest)) refuse("expected a finite number");
  const bool exact = json_.is_number_float()      ? true
                     : json_.is_number_unsigned() ? is_exact(json_.get<std::uint64_t>(), nearest)
                                                  : is_exact(json_.get<std::int64_t>(), nearest);
  if (!exact)
    refuse("the integer " + json_.dump() + " is not a double; write it with a decimal point to have it rounded");
  return nearest;
}

int Node::index() const {
  if (!json_.is_number_integer()) refuse("expected an integer, found " + kind(json_));
  constexpr std::int64_t greatest = std::numeric_limits<int>::max();
  const bool fits = json_.is_number_unsigned()
                        ? json_.get<std::uint64_t>() <= static_cast<std::uint64_t>(greatest)
                        : json_.get<std::int64_t>() >= 0 && json_.get<std::int64_t>() <= greatest;
  if (!fits) refuse("expected an integer from 0 to " + std::to_string(greatest) + ", found " + json_.dump());
  return json_.get<int>();
}

std::string Node::text() const {
  if (!json_.is_string()) refuse("expected a string, found " + kind(json_));
  return json_.get<std::string>();
}

bool Node::truth() const {
  if (!json_.is_boolean()) refuse("expected true or false, found " + kind(json_));
  return json_.get<bool>();
}

void Node::refuse(const std::string& what_is_wrong) const { throw InputError(place(), what_is_wrong); }

std::string Node::place() const {
  std::string way = parent_ ? parent_->place() : "";
  if (index_ >= 0) return way + '[' + std::to_string(index_) + ']';
  if (!way.empty()) way += '.';
  return way.append(key_);
}

}  // namespace touchstone
