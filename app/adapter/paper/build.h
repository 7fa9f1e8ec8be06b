// Bodies and frames of which the scenes on paper are made.
#pragma once

#include <string>
#include <vector>

#include "app/adapter/paper/paper_scene.h"

namespace touchstone::app {

/// A rotation whose matrix is rational: R is that of q/|q|, written out. No q but the first has length 1, since an
/// adapter must not rely on that.
struct Turn {
  Quaternion q;
  Mat3 R;
};

extern const Turn upright;
extern const Turn quarter_about_x;  ///< y to z, z to −y
extern const Turn cyclic;           ///< x to y, y to z, z to x
extern const Turn three_four_five;  ///< about z, cos = 3/5, sin = 4/5
extern const Turn general;          ///< about (2, 2, 1), entries of 25ths

/// A motion of the whole world: a point p goes to R p + shift.
struct WorldMotion {
  const Turn& turn;
  Vec3 shift;
};

/// A body of density 1 at rest.
Body body(Shape shape, const Vec3& p_WB, const Turn& turn = upright);

/// The hull of points that are given in the axes of W, relative to p_WB. The frame of the body is turned, so its
/// vertices are Rᵀ v.
Body hull(const std::vector<Vec3>& vertices, const Vec3& p_WB, const Turn& turn = upright);

/// The eight corners of a box.
std::vector<Vec3> corners(const Vec3& half_extents);

Body moving(Body body, const Vec3& v_WBcm, const Vec3& w_WB = Vec3::Zero());
Body dense(Body body, double density);
Body given(Body body, double mass, const Vec3& moments, const Vec3& p_BBcm = Vec3::Zero());
Body fixed(Body body);

Scene scene(const std::string& name, std::vector<Body> bodies);

/// What a motion of the world does to a scene and to its answer. Boxes, pairs and pixels are not moved, since their
/// answers change in another way.
PaperScene moved(const PaperScene& paper, const WorldMotion& motion);

/// Each scene under each motion of the world, in the order of the scenes.
std::vector<PaperScene> in_all(const std::vector<PaperScene>& papers, const std::vector<WorldMotion>& motions);

/// At rest in the origin; turned by a quarter; turned so that no axis keeps its place.
const std::vector<WorldMotion>& three_frames();

/// These three, a shift alone, and x to y to z.
const std::vector<WorldMotion>& five_frames();

}  // namespace touchstone::app
