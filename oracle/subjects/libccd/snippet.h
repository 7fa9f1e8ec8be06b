// A program in libccd's own API that asks what the adapter asks.
#pragma once

#include <string>
#include <vector>

#include "model/frame.h"

namespace touchstone::oracle::subjects {

/// libccd accesses a body only through a support function that its user writes. Here a body is its vertices in W, and a
/// radius around them.
struct CcdBody {
  std::vector<Vec3> vertices_W;
  double radius = 0;
};

/// Prints whether A and B intersect and, if so, their depth. `algorithm`: "GJK" or "MPR";
/// `expected` is printed first, unless empty.
std::string libccd_snippet(const CcdBody& A, const CcdBody& B, const std::string& algorithm,
                           const std::string& expected);

}  // namespace touchstone::oracle::subjects
