// Checks whether faces that came through the pipe are those of a convex solid.
#pragma once

#include "model/shape.h"

namespace touchstone::oracle {

/// Throws InputError ("faces[3]: ...") unless the faces form one closed surface (each edge occurs once in each
/// direction, and vertices + faces = edges + 2), each face is a plane convex polygon, counter-clockwise seen from
/// outside, and no neighbour rises above its plane. Exact. Requires a polytope that is valid by model/limits.h and has
/// faces.
///
/// It compares only neighbours, in O(edges · log edges). The judge's check (reference/validity.h) compares each face
/// with each vertex, O(faces · vertices), and also refuses vertices inside the hull.
void require_convex_faces(const Polytope& polytope);

}  // namespace touchstone::oracle
