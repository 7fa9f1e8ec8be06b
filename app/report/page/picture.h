// An SVG drawing of a small scene.
#pragma once

#include <string>

#include "model/scene.h"
#include "oracle/case.h"

namespace touchstone::app {

/// Wire frames of the bodies in two views, along −z and along −y, with the closest points of bodies 0 and 1 and the
/// line between them. Colours and line styles come from CSS classes (body-0, body-1, exact, claim); the labels are part
/// of the drawing. `turn_script` turns the second view. If a body has more than `most_drawn` vertices, returns an empty
/// string.
std::string picture(const Scene& scene);

/// In addition what the finding's subject claims (marks.h), with a caption.
std::string picture(const oracle::Case& a_case);

inline constexpr int most_drawn = 64;

}  // namespace touchstone::app
