// Your own answer, judged against the exact truth by the properties of the specification.
#include <touchstone/properties/property.h>
#include <touchstone/reference/validity.h>

#include <cstdio>

using namespace touchstone;

/// The code under test: the distance of two boxes from their half extents and centres. It ignores their rotations, so
/// it is right for boxes that are parallel to the axes, and wrong for others.
double my_distance(const Body& a, const Body& b) {
  const Vec3 reach = std::get<Box>(a.shape).half_extents + std::get<Box>(b.shape).half_extents;
  const Vec3 offset = (a.X_WB.p_WB - b.X_WB.p_WB).cwiseAbs();
  return (offset - reach).cwiseMax(0).norm();
}

/// A subject is what is being tested. It answers the queries that it overrides, and abstains from all others; within an
/// answer it leaves out what it does not compute, here the closest points and features.
class MySubject : public oracle::Subject {
 public:
  MySubject() {
    card_.name = "mine";
    card_.precision = oracle::Precision::binary64;  // decides how much error is allowed
    card_.answers = {"distance"};
  }

  const oracle::Card& card() const override { return card_; }

  Answer<Distance> distance(const Scene& scene) override {
    Distance answer;
    answer.distance = my_distance(scene.bodies[0], scene.bodies[1]);
    answer.verdict = *answer.distance > 0 ? Verdict::separated : Verdict::overlapping;
    return answer;
  }

 private:
  oracle::Card card_;
};

/// Asks the subject under each property of the query `distance`, and prints what came out.
void judge(const Scene& scene, oracle::Subject& subject) {
  for (const properties::Property& property : properties::all()) {
    if (property.query != "distance") continue;
    const oracle::Finding finding = property.check(scene, subject);
    if (finding.outcome == oracle::Outcome::abstains || finding.outcome == oracle::Outcome::outside) continue;
    std::printf("  %-20s %s", property.id.c_str(), name_of(finding.outcome).c_str());
    if (finding.outcome == oracle::Outcome::fails) {
      std::printf(": %s; observed %s, expected %s", name_of(finding.defect).c_str(), finding.observed.c_str(),
                  finding.expected.c_str());
    }
    std::printf("\n");
  }
}

int main() {
  Body a, b;
  a.shape = b.shape = Box{Vec3(1, 1, 1)};
  b.X_WB.p_WB = Vec3(4, 3, 0);
  Scene scene;
  scene.bodies = {a, b};
  MySubject subject;

  std::printf("boxes parallel to the axes:\n");
  judge(reference::completed(scene), subject);

  scene.bodies[1].X_WB.q_WB = {3, 0, 0, 1};  // about z, by twice the angle whose tangent is 1/3
  std::printf("one of them turned:\n");
  judge(reference::completed(scene), subject);
}
