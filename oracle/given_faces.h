// Faces that came through the pipe: are they those of a convex solid?
#pragma once

#include "model/shape.h"

namespace touchstone::oracle {

/// Throws InputError ("faces[3]: ...") unless the faces are one closed surface (each edge met once in each direction, as
/// many vertices and faces as edges and two), each is a plane convex polygon, counter-clockwise seen from outside, and no
/// neighbour rises above its plane. Exact. Requires a polytope that is valid by model/limits.h and has faces.
///
/// It looks at neighbours alone, in O(edges · log): the judge's check (reference/validity.h) holds each face against each
/// vertex, O(faces · vertices), and refuses vertices inside the hull too.
void require_convex_faces(const Polytope& polytope);

}  // namespace touchstone::oracle
