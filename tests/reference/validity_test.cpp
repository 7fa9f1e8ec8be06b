#include "reference/validity.h"

#include "model/input_error.h"
#include "reference/convex_hull.h"
#include "tests/catch.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::reference {
namespace {

using tests::Dice;

Polytope cube() {
  Polytope p;
  for (int i = 0; i < 8; ++i) p.vertices.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
  p.faces = {{0, 1, 5, 4}, {0, 2, 3, 1}, {0, 4, 6, 2}, {1, 3, 7, 5}, {2, 6, 7, 3}, {4, 5, 7, 6}};
  return p;
}

Scene scene_of(const Shape& shape) {
  Scene scene;
  scene.bodies = {tests::body(shape)};
  return scene;
}

Polytope completed(const Polytope& p) { return std::get<Polytope>(reference::completed(scene_of(p)).bodies[0].shape); }

std::string complaint(const Shape& shape) {
  try {
    reference::completed(scene_of(shape));
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

std::string about(Polytope p, const std::vector<std::vector<int>>& faces) {
  p.faces = faces;
  return complaint(p);
}

TEST_CASE("validity: a valid polytope is left as it is, and missing faces are those of the hull") {
  CHECK(completed(cube()) == cube());
  Polytope bare = cube();
  bare.faces.clear();
  CHECK(completed(bare) == cube());
  Dice dice(21);
  for (int i = 0; i < 300; ++i) {
    const Shape hull = tests::lattice_hull(dice, 12, 3);
    if (!std::holds_alternative<Polytope>(hull)) continue;
    Polytope p = std::get<Polytope>(hull);
    REQUIRE(completed(p) == p);
    const auto faces = p.faces;
    p.faces.clear();
    REQUIRE(completed(p).faces == faces);
  }
}

TEST_CASE("validity: coplanar neighbours, unnamed boundary vertices and any start of a face are allowed") {
  Polytope p = cube();
  p.faces = {{5, 4, 0, 1}, {0, 2, 3, 1}, {0, 4, 6, 2}, {1, 3, 7, 5}, {2, 6, 7, 3}, {4, 5, 7}, {4, 7, 6}};
  CHECK(completed(p) == p);
  p.vertices.emplace_back(0.5, 0, 0);    // on an edge
  p.vertices.emplace_back(0.5, 0.5, 1);  // in a face
  CHECK(completed(p) == p);
  p.faces.clear();
  CHECK(completed(p).faces.size() == 6);
  CHECK(completed(p).vertices == p.vertices);
}

TEST_CASE("validity: each broken law names its place") {
  const auto faces = cube().faces;
  auto f = faces;
  f[3] = {1, 5, 7, 3};
  CHECK(about(cube(), f) == "bodies[0].shape.faces[3]: wound clockwise seen from outside");
  f = faces;
  f[1] = {0, 2, 7, 1};
  CHECK(about(cube(), f) == "bodies[0].shape.faces[1]: not plane: vertex 1 is off the plane of the others");
  f = faces;
  f[1] = {0, 3, 5};
  CHECK(about(cube(), f).find("bodies[0].shape.faces[1]: not a face of the convex hull: vertex ") == 0);
  f = faces;
  f[5] = {4, 5, 6, 7};
  CHECK(about(cube(), f).find("bodies[0].shape.faces[5]: not a convex polygon at vertex ") == 0);
  f = faces;
  f.pop_back();
  CHECK(about(cube(), f).find("no face on the other side of the edge ") != std::string::npos);
  f = faces;
  f.push_back(faces[2]);
  CHECK(about(cube(), f) == "bodies[0].shape.faces[6]: goes along the edge 0-4 as faces[2] does");

  Polytope line = cube();
  line.vertices.emplace_back(0.5, 0, 0);
  f = faces;
  f[0] = {0, 8, 1};
  CHECK(about(line, f) == "bodies[0].shape.faces[0]: all its vertices are on one line");

  Polytope inside = cube();
  inside.vertices.emplace_back(0.5, 0.5, 0.5);
  CHECK(complaint(inside) == "bodies[0].shape.vertices[8]: lies inside the hull");
  inside.faces.clear();
  CHECK(complaint(inside) == "bodies[0].shape.vertices[8]: lies inside the hull");
  inside.vertices.insert(inside.vertices.begin(), Vec3(0.25, 0.5, 0.5));
  CHECK(complaint(inside) == "bodies[0].shape.vertices[0]: lies inside the hull");

  const Polytope flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {}};
  CHECK(complaint(flat) == "bodies[0].shape.vertices: all in one plane: a solid needs 4 that are not");
  CHECK(about(flat, {{0, 1, 3, 2}, {0, 2, 3, 1}}) ==
        "bodies[0].shape.vertices: all in one plane: a solid needs 4 that are not");

  Compound compound;
  compound.parts = {{Pose{}, Sphere{1}}, {Pose{}, inside}};
  CHECK(complaint(compound) == "bodies[0].shape.parts[1].shape.vertices[0]: lies inside the hull");
}

TEST_CASE("validity: the floating-point laws come first") {
  Polytope twice = cube();
  twice.vertices[5] = twice.vertices[1];
  CHECK(complaint(twice).find("bodies[0].shape.vertices[5]: equal to vertex 1") == 0);
  CHECK(complaint(Sphere{-1}).find("bodies[0].shape.radius: ") == 0);
}

TEST_CASE("validity: a boundary covered twice is refused") {
  Polytope p = cube();
  p.faces.clear();
  // The middles of the edges: a second cover that goes through them shares no directed edge with the first.
  for (const Vec3& v : std::vector<Vec3>{{1, 0, 0},
                                         {2, 1, 0},
                                         {1, 2, 0},
                                         {0, 1, 0},
                                         {1, 0, 2},
                                         {2, 1, 2},
                                         {1, 2, 2},
                                         {0, 1, 2},
                                         {0, 0, 1},
                                         {2, 0, 1},
                                         {2, 2, 1},
                                         {0, 2, 1}}) {
    p.vertices.push_back(v / 2);
  }
  const std::vector<std::vector<int>> once = {{0, 1, 5, 4}, {0, 2, 3, 1}, {0, 4, 6, 2},
                                              {1, 3, 7, 5}, {2, 6, 7, 3}, {4, 5, 7, 6}};
  const std::vector<std::vector<int>> through_the_middles = {
      {0, 8, 1, 17, 5, 12, 4, 16}, {0, 11, 2, 10, 3, 9, 1, 8},   {0, 16, 4, 15, 6, 19, 2, 11},
      {1, 9, 3, 18, 7, 13, 5, 17}, {2, 19, 6, 14, 7, 18, 3, 10}, {4, 12, 5, 13, 7, 14, 6, 15}};
  CHECK(about(p, once) == "none");
  CHECK(about(p, through_the_middles) == "none");
  auto both = once;
  both.insert(both.end(), through_the_middles.begin(), through_the_middles.end());
  CHECK(about(p, both) == "bodies[0].shape.faces: they cover the boundary more than once");
}

TEST_CASE("validity: an outline that winds twice is refused") {
  // A pyramid over a pentagon whose base goes round as a star: every turn is to the left.
  std::vector<Vec3> points = {{0, 0, 5}};
  for (const auto& [x, y] : std::vector<std::pair<int, int>>{{4, 0}, {1, 4}, {-3, 2}, {-3, -2}, {1, -4}})
    points.emplace_back(x, y, 0);
  Polytope p = convex_hull(points);
  REQUIRE(p.faces.size() == 6);
  for (auto& face : p.faces) {
    if (face.size() == 5) face = {face[0], face[2], face[4], face[1], face[3]};
  }
  CHECK(complaint(p).find("no face on the other side of the edge ") != std::string::npos);
}

TEST_CASE("validity: an ulp and 2^±500 are seen exactly") {
  for (const double s : {1.0, 0x1p500, 0x1p-500}) {
    Polytope p = cube();
    for (Vec3& v : p.vertices) v *= s;
    CHECK(complaint(p) == "none");
    p.vertices[7].x() = std::nextafter(s, 0);
    CHECK(complaint(p).find("bodies[0].shape.faces[3]: not plane") == 0);
  }
}

}  // namespace
}  // namespace touchstone::reference
