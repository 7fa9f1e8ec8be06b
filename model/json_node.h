// A JSON value together with its path, so that every message names the place. Other readers (the pipe, cases) use it
// too.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/json.h"

namespace touchstone {

/// Nodes live on the stack of the reading functions: a child points to its parent, and the text of a place is built
/// only for an error.
class Node {
 public:
  Node(const Json& json, const std::string& root) : json_(json), key_(root) {}

  /// Refuses a value that is not an object, and an object with any other key.
  void expect_object(std::initializer_list<std::string_view> known) const;

  Node at(std::string_view key) const;  ///< the member with this key; refuses an object without it
  std::optional<Node> find(std::string_view key) const;

  std::vector<std::string> keys() const;  ///< refuses a value that is not an object

  int size() const;  ///< refuses a value that is not an array
  void expect_size(int size) const;
  Node operator[](int index) const { return Node(json_[static_cast<std::size_t>(index)], this, {}, index); }

  bool is_null() const { return json_.is_null(); }
  bool is_text() const { return json_.is_string(); }
  double number() const;  ///< accepts an integer only if a double represents it exactly
  int index() const;      ///< an integer from 0 to the greatest int
  std::string text() const;
  bool truth() const;

  [[noreturn]] void refuse(const std::string& what_is_wrong) const;

 private:
  Node(const Json& json, const Node* parent, std::string_view key, int index)
      : json_(json), parent_(parent), key_(key), index_(index) {}

  std::string place() const;

  const Json& json_;
  const Node* parent_ = nullptr;
  std::string_view key_;
  int index_ = -1;
};

/// Read the value of a node; a wrong type or size, an unknown or a missing key throws InputError with its place. The
/// values are not validated beyond that (model/limits.h).
Vec3 read_vec3(const Node& node);
Mat3 read_mat3(const Node& node);
MassProperties read_mass_properties(const Node& node);
Velocity read_velocity(const Node& node);
Pose read_pose(const Node& node);

}  // namespace touchstone
