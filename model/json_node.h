// A JSON value together with the way to it, so that every complaint names the place. Other readers (the pipe, cases)
// use it too.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "model/json.h"

namespace touchstone {

/// Nodes live on the stack of the reading functions: a child points at its parent, and a place's text is built only
/// when something is wrong.
class Node {
 public:
  Node(const Json& json, const std::string& root) : json_(json), key_(root) {}

  /// Refuses what is not an object, and any key but these.
  void expect_object(std::initializer_list<std::string_view> known) const;

  Node at(std::string_view key) const;  ///< a key that must be there
  std::optional<Node> find(std::string_view key) const;

  int size() const;  ///< refuses what is not an array
  void expect_size(int size) const;
  Node operator[](int index) const { return Node(json_[static_cast<std::size_t>(index)], this, {}, index); }

  bool is_null() const { return json_.is_null(); }
  bool is_text() const { return json_.is_string(); }
  double number() const;  ///< an integer counts when a double holds it exactly
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

Vec3 read_vec3(const Node& node);
Mat3 read_mat3(const Node& node);
MassProperties read_mass_properties(const Node& node);
Velocity read_velocity(const Node& node);
Pose read_pose(const Node& node);

}  // namespace touchstone
