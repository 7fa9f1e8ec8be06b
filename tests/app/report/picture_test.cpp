// Drawings contain what is in the scene, in finite numbers, and are left out where they would show nothing.
#include "app/report/page/picture.h"

#include <regex>

#include "properties/property.h"
#include "reference/validity.h"
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
  CHECK(count(svg, "M-?[0-9.]+ -?[0-9.]+L") == 2 * (12 + 12 + 1));
  CHECK(count(svg, "<path class=\"body-0\"") == 2);
  CHECK(count(svg, "<path class=\"exact\"") == 2);
}

TEST_CASE("Overlapping bodies have no closest points to draw") {
  CHECK(count(picture(two(Sphere{1}, Sphere{1}, Vec3(1, 0, 0))), "exact") == 0);
}

/// Says of two bodies whatever it was made with.
class Claims : public oracle::Subject {
 public:
  const oracle::Card& card() const override { return card_; }
  Answer<Distance> distance(const Scene&) override { return distance_; }
  Answer<Penetration> penetration(const Scene&) override { return penetration_; }
  Answer<Impulse> impulse(const Scene&) override { return impulse_; }

  Distance distance_;
  Penetration penetration_;
  Impulse impulse_;

 private:
  oracle::Card card_ = [] {
    oracle::Card card;
    card.answers = {"distance", "penetration", "impulse"};
    return card;
  }();
};

/// The picture of what the property finds.
std::string pictured(const std::string& property, const Scene& given, Claims& subject) {
  oracle::Case a_case;
  a_case.scene = reference::completed(given);
  a_case.property = property;
  a_case.finding = properties::find(property).check(a_case.scene, subject);
  REQUIRE(a_case.finding.outcome == oracle::Outcome::fails);
  return picture(a_case);
}

TEST_CASE("What a finding claims is drawn beside the truth") {
  const Scene apart = two(Box{Vec3(1, 1, 1)}, Box{Vec3(1, 1, 1)}, Vec3(4, 0, 0));
  Claims subject;
  SECTION("A distance, along the exact line") {
    subject.distance_.distance = 1.5;
    const std::string svg = pictured("distance.value", apart, subject);
    CHECK(count(svg, "<path class=\"claim\"") == 2);
    CHECK(count(svg, "exact 2 m") == 1);
    CHECK(count(svg, "claimed 1.5 m") == 1);
    // 6 m are 140 units: from x = 1 m, 2 m left of the middle, over 1.5 m.
    CHECK(count(svg, "<path class=\"claim\" d=\"M-23.33 [^L]*L11.67") == 2);
  }
  SECTION("Closest points, also off the bodies") {
    subject.distance_.p_WCa = Vec3(1, 0, 0);
    subject.distance_.p_WCb = Vec3(3, 0, 3);
    CHECK(count(pictured("distance.witnesses_on_bodies", apart, subject), "<path class=\"claim\"") == 2);
  }
  SECTION("A depth, as a translation of A") {
    const Scene deep = two(Box{Vec3(1, 1, 1)}, Box{Vec3(1, 1, 1)}, Vec3(1.5, 0, 0));
    subject.penetration_ = {Verdict::overlapping, 0.25, Vec3(-1, 0, 0)};
    CHECK(count(pictured("penetration.depth", deep, subject), "exact 0.5 m.*claimed 0.25 m") == 1);
    CHECK(count(pictured("penetration.separates", deep, subject), "exact 0.5 m.*claimed 0.25 m") == 1);
  }
  SECTION("Velocities, before and after an impact") {
    Scene impact = two(Sphere{1}, Sphere{1}, Vec3(2, 0, 0));
    impact.bodies[0].velocity.v_WBcm = Vec3(1, 0, 0);
    impact.contact = Contact{Vec3(1, 0, 0), Vec3(-1, 0, 0)};
    subject.impulse_.after[0].v_WBcm = Vec3(1, 0, 0);
    const std::string svg = pictured("impulse.agrees", impact, subject);
    CHECK(count(svg, "<path class=\"before arrow\"") == 2);  // of A; B rests
    CHECK(count(svg, "<path class=\"exact arrow\"") == 4);   // plastic: both move
    CHECK(count(svg, "<path class=\"claim arrow\"") == 2);
  }
}

TEST_CASE("A claim far off the scene is not drawn, and leaves the bodies as large as they are") {
  Claims subject;
  subject.distance_.distance = 1e200;
  const std::string svg =
      pictured("distance.value", two(Box{Vec3(1, 1, 1)}, Box{Vec3(1, 1, 1)}, Vec3(4, 0, 0)), subject);
  CHECK(count(svg, "<path class=\"claim\"") == 0);
  CHECK(count(svg, "M-70.00") > 0);
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
