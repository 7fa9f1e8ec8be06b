#include "oracle/subjects/libccd/libccd.h"

#include <ccd/ccd.h>

#include <cmath>
#include <stdexcept>

#include "model/box_vertices.h"
#include "oracle/subject.h"
#include "oracle/subjects/common/customary_domain.h"
#include "oracle/subjects/common/engine.h"
#include "oracle/subjects/libccd/snippet.h"

namespace touchstone::oracle::subjects {
namespace {

std::vector<Vec3> vertices(const Shape& shape) {
  if (const Box* box = std::get_if<Box>(&shape)) return vertices_of(*box);
  if (const Polytope* polytope = std::get_if<Polytope>(&shape)) return polytope->vertices;
  return {Vec3::Zero()};
}

CcdBody ccd_body(const Body& body) {
  CcdBody ready;
  const Mat3 R_WB = rotation(body.X_WB.q_WB).toRotationMatrix();
  for (const Vec3& p_BV : vertices(body.shape)) ready.vertices_W.emplace_back(R_WB * p_BV + body.X_WB.p_WB);
  if (const Sphere* sphere = std::get_if<Sphere>(&body.shape)) ready.radius = sphere->radius;
  return ready;
}

void put(const Vec3& from, ccd_vec3_t* to) { ccdVec3Set(to, from.x(), from.y(), from.z()); }

void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* farthest) {
  const CcdBody& body = *static_cast<const CcdBody*>(object);
  const Vec3 along(direction->v[0], direction->v[1], direction->v[2]);
  const Vec3* best = &body.vertices_W.front();
  for (const Vec3& vertex : body.vertices_W) {
    if (vertex.dot(along) > best->dot(along)) best = &vertex;
  }
  // In the zero direction every point is a support point.
  const double length = along.norm();
  put(length > 0 ? Vec3(*best + body.radius / length * along) : *best, farthest);
}

void center(const void* object, ccd_vec3_t* inner) {
  const CcdBody& body = *static_cast<const CcdBody*>(object);
  Vec3 sum = Vec3::Zero();
  for (const Vec3& vertex : body.vertices_W) sum += vertex;
  put(sum / static_cast<double>(body.vertices_W.size()), inner);
}

using Query = decltype(&ccdGJKPenetration);

ccd_t settings() {
  ccd_t made{};
  CCD_INIT(&made);
  return made;
}

class Libccd : public Subject {
 public:
  Libccd(Card card, std::string algorithm, decltype(&ccdGJKIntersect) intersect, Query penetrate)
      : card_(std::move(card)), algorithm_(std::move(algorithm)), intersect_(intersect), penetrate_(penetrate) {
    ccd_.support1 = ccd_.support2 = support;
    ccd_.center1 = ccd_.center2 = center;
  }

  const Card& card() const override { return card_; }

  /// libccd reports whether the bodies intersect, but no distance.
  Answer<Distance> distance(const Scene& scene) override {
    if (has_compound(scene)) return no_compounds;
    const CcdBody A = ccd_body(scene.bodies.at(0));
    const CcdBody B = ccd_body(scene.bodies.at(1));
    Distance said;
    said.verdict = intersect_(&A, &B, &ccd_) ? Verdict::overlapping : Verdict::separated;
    return said;
  }

  Answer<Penetration> penetration(const Scene& scene) override {
    if (has_compound(scene)) return no_compounds;
    const CcdBody A = ccd_body(scene.bodies.at(0));
    const CcdBody B = ccd_body(scene.bodies.at(1));
    ccd_real_t depth = 0;
    ccd_vec3_t direction{};  // along which B separates from A; A separates along its opposite
    ccd_vec3_t position{};
    const int code = penetrate_(&A, &B, &ccd_, &depth, &direction, &position);
    if (code == -1) return no_penetration();
    if (code != 0) throw std::runtime_error("libccd returned " + std::to_string(code));
    return deep(depth, -Vec3(direction.v[0], direction.v[1], direction.v[2]));
  }

  Answer<std::string> reproduce(const std::string&, const Scene& scene, const std::string& expected) override {
    if (has_compound(scene)) return no_compounds;
    return libccd_snippet(ccd_body(scene.bodies.at(0)), ccd_body(scene.bodies.at(1)), algorithm_, expected);
  }

 private:
  Card card_;
  std::string algorithm_;
  ccd_t ccd_ = settings();
  decltype(&ccdGJKIntersect) intersect_;
  Query penetrate_;
};

/// Its steps end when they gain less than `tolerance`, in metres.
Card card(const std::string& name, const std::string& about, std::vector<Deviation> deviations, ccd_real_t tolerance) {
  return {.name = name,
          .version = "2.1",
          .precision = sizeof(ccd_real_t) == sizeof(double) ? Precision::binary64 : Precision::binary32,
          .answers = {"distance", "penetration"},
          .about = about,
          .homepage = "https://github.com/danfis/libccd",
          .deviations = std::move(deviations),
          .domain = customary_domain(),
          .distance_tolerance = {.absolute = tolerance},
          .reproduces = {"distance", "penetration"}};
}

}  // namespace

std::unique_ptr<Subject> make_libccd_gjk() {
  return std::make_unique<Libccd>(
      card("libccd.gjk", "ccdGJKIntersect; ccdGJKPenetration (EPA); CCD_INIT's settings; the verdict only, no distance",
           {{"", "EPA reports depth 0 and direction NaN for two cubes in each other",
             "https://github.com/danfis/libccd/issues/25"},
            {"", "ccdGJKPenetration can loop for ever", "https://github.com/danfis/libccd/issues/7"}},
           settings().epa_tolerance),
      "GJK", ccdGJKIntersect, ccdGJKPenetration);
}

std::unique_ptr<Subject> make_libccd_mpr() {
  return std::make_unique<Libccd>(
      card("libccd.mpr", "ccdMPRIntersect; ccdMPRPenetration; CCD_INIT's settings; the verdict only, no distance",
           {{"", "ccdMPRPenetration's direction, and so its depth, is not that of the least",
             "https://github.com/danfis/libccd/issues/71"}},
           settings().mpr_tolerance),
      "MPR", ccdMPRIntersect, ccdMPRPenetration);
}

}  // namespace touchstone::oracle::subjects
