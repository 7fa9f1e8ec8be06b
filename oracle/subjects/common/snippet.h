// Numbers and texts in the C++ programs that adapters write to reproduce a query in an engine's own API.
#pragma once

#include <fmt/format.h>

#include <string>

#include "model/frame.h"
#include "model/json.h"
#include "oracle/rotation.h"

namespace touchstone::oracle::subjects {

/// A double that C++ reads as x, bit for bit: "1.0", "0.1", "1e-05".
inline std::string cpp_number(double x) { return fmt::format("{:#}", x); }

/// "1.0, 2.0, 3.0"
inline std::string cpp_list(const Vec3& v) {
  return fmt::format("{}, {}, {}", cpp_number(v.x()), cpp_number(v.y()), cpp_number(v.z()));
}

/// The components x, y, z, w of the rotation that the adapter gives to the engine.
inline std::string cpp_rotation_xyzw(const Quaternion& q) {
  const Eigen::Quaterniond R = rotation(q);
  return fmt::format("{}, {}", cpp_list(R.vec()), cpp_number(R.w()));
}

/// A statement, indented, that prints what the answer should be; empty if that is.
inline std::string cpp_printed(const std::string& expected) {
  if (expected.empty()) return "";
  const std::string quoted = Json("expected: " + expected).dump(-1, ' ', false, Json::error_handler_t::replace);
  return fmt::format("  std::puts({});\n", quoted);
}

}  // namespace touchstone::oracle::subjects
