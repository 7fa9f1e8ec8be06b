// Tables of several parts that are one box.
#pragma once

#include "model/scene.h"

namespace touchstone::properties {

/// The same scene, but each fixed compound of boxes that fill a box is that box: parts whose axes are those of the
/// body, that do not overlap, and whose volumes add up to that of the box around them (up to 2⁻⁴⁸ of it), with its
/// middle at the body's origin. Bodies on it move as on one box, so the laws about tables hold, whatever its seams.
Scene with_whole_tables(const Scene& scene);

}  // namespace touchstone::properties
