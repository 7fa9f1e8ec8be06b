// Drawings contain what is in the scene, in finite numbers, and are left out where they would show nothing.
#include "app/report/page/picture.h"

#include <regex>

#include "tests/catch.h"

namespace touchstone::app {
namespace {

Scene two(const Shape& a, const Shape& b, const Vec3& p_WB) {
  Scene scene;
  scene.bodies.assign(2, Body{});
  scene.bodies[0].shape = a;
  scene.bodies[1].shape = b;
  scene.bodies[1].X_WB.p_WB = p_WB;
  return scene;
}

int count(const std::string& text, const std::string& word) {
  const std::regex pattern(word);
  return static_cast<int>(std::distance(std::sregex_iterator(text.begin(), text.end(), pattern), {}));
}

TEST_CASE("Two boxes: twelve edges each in each of two views, and the line between them") {
  const std::string svg = picture(two(Box{Vec3(1, 1, 1)}, Box{Vec3(1, 1, 1)}, Vec3(4, 0, 0)));
  CHECK(count(svg, "<line class=\"body-0\"") == 24);
  CHECK(count(svg, "<line class=\"body-1\"") == 24);
  CHECK(count(svg, "<line class=\"witness\"") == 2);
}

TEST_CASE("Overlapping bodies have no closest points to draw") {
  CHECK(count(picture(two(Sphere{1}, Sphere{1}, Vec3(1, 0, 0))), "witness") == 0);
}

TEST_CASE("Numbers stay finite for scenes of any size") {
  for (const double size : {5e-324, 1e-300, 1.0, 1e300}) {
    const std::string svg = picture(two(Sphere{size}, Sphere{size}, Vec3(size * 3, 0, 0)));
    CHECK(count(svg, "nan|inf") == 0);
  }
}

TEST_CASE("A body of very many vertices is not drawn") {
  Polytope spiral;
  for (int i = 0; i <= most_drawn; ++i) spiral.vertices.emplace_back(i, i * i, i * i * i);
  CHECK(picture(two(spiral, Sphere{1}, Vec3(-9, 0, 0))).empty());
}

}  // namespace
}  // namespace touchstone::app
