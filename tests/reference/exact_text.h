// Exact vectors as text, to compare them with fractions.
#pragma once

#include <string>

#include "reference/impulse.h"

namespace touchstone::tests {

inline std::string text(const reference::ExactVec3& v) { return v[0].text() + ", " + v[1].text() + ", " + v[2].text(); }

}  // namespace touchstone::tests
