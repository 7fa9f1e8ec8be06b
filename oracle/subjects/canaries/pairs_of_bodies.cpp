// Canaries that lie about distance and penetration.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "model/infinity.h"
#include "oracle/rotation.h"
#include "oracle/subjects/canaries/lie.h"

namespace touchstone::oracle::subjects {
namespace {

Lies penetrations(Lie<Penetration> lie) {
  Lies lies;
  lies.penetration = std::move(lie);
  return lies;
}

void signed_distance(Subject& truthful, const Scene& scene, Distance& said) {
  if (said.verdict != Verdict::overlapping) return;
  with(truthful.penetration(scene), [&](const Penetration& deep) { said.distance = -deep.depth.value_or(0); });
}

Lies near_means_touching() {
  const auto lie = [](Subject& truthful, const Scene& scene, auto& said) {
    if (said.verdict == Verdict::separated && distance_by(truthful, scene) < 1e-9) said.verdict = Verdict::overlapping;
  };
  Lies lies;
  lies.two_valued = true;
  lies.distance = lie;
  lies.penetration = lie;
  return lies;
}

void relative_1e6(Subject&, const Scene&, Distance& said) {
  if (said.distance) *said.distance *= 1 + 1e-6;
}

void rounded_to_zero(Subject&, const Scene&, Distance& said) {
  if (said.distance < 1e-4) said.distance = 0;
}

void witnesses_swapped(Subject&, const Scene&, Distance& said) { std::swap(said.p_WCa, said.p_WCb); }

void witness_in_body_frame(Subject&, const Scene& scene, Distance& said) {
  if (said.p_WCa) *said.p_WCa -= scene.bodies[0].X_WB.p_WB;
  if (said.p_WCb) *said.p_WCb -= scene.bodies[1].X_WB.p_WB;
}

void witness_at_centre(Subject&, const Scene& scene, Distance& said) {
  if (said.p_WCa) said.p_WCa = scene.bodies[0].X_WB.p_WB;
}

void feature_off_by_one(Subject&, const Scene& scene, Distance& said) {
  if (!said.feature_A) return;
  const int n = static_cast<int>(corners(scene.bodies[0]).size());
  for (int& i : said.feature_A->vertices) i = (i + 1) % n;
}

void feature_of_everything(Subject&, const Scene& scene, Distance& said) {
  if (!said.feature_A) return;
  said.feature_A->vertices.resize(corners(scene.bodies[0]).size());
  std::iota(said.feature_A->vertices.begin(), said.feature_A->vertices.end(), 0);
}

void narrow_enclosure(Subject&, const Scene&, Distance& said) {
  if (!said.distance) return;
  const double above = std::nextafter(*said.distance, infinity);
  const double wide = above + 4 * (above - *said.distance);
  said.enclosure = Interval{wide, wide};
}

void wide_enclosure(Subject&, const Scene&, Distance& said) {
  if (said.distance) said.enclosure = Interval{0, 2 * *said.distance};
}

// Four times what may be wrong, and a witness point of A as far off as is seen there and in the distance of both.
void slightly_far(Subject&, const Scene& scene, Distance& said) {
  const double unit = rounding_of_length(scene);
  if (!said.distance || said.verdict == Verdict::overlapping) return;
  const double said_distance = *said.distance;
  *said.distance += 1000 * unit;
  said.enclosure = Interval{std::max(0.0, said_distance - 1000 * unit), said_distance + 1000 * unit};
  if (!said.p_WCa || !said.p_WCb) return;
  const Vec3 to_B = *said.p_WCb - *said.p_WCa;
  if (to_B.norm() > 0) *said.p_WCa += 600 * unit * to_B.normalized();
}

struct Solid {
  std::vector<Vec3> vertices;
  std::vector<Vec3> normals;
};

// Boxes and polytopes in the world frame, with their face normals; other shapes have no normals.
Solid solid(const Body& body) {
  const Eigen::Quaterniond R_WB = rotation(body.X_WB.q_WB);
  Solid solid;
  for (const Vec3& v : corners(body)) solid.vertices.emplace_back(R_WB * v + body.X_WB.p_WB);
  if (std::holds_alternative<Box>(body.shape)) {
    for (const Vec3& n : {Vec3::UnitX().eval(), Vec3::UnitY().eval(), Vec3::UnitZ().eval()})
      solid.normals.emplace_back(R_WB * n);
  }
  if (const Polytope* polytope = std::get_if<Polytope>(&body.shape)) {
    for (const std::vector<int>& face : polytope->faces) {
      const auto at = [&](std::size_t k) { return solid.vertices[static_cast<std::size_t>(face[k])]; };
      solid.normals.emplace_back((at(1) - at(0)).cross(at(2) - at(0)).normalized());
    }
  }
  return solid;
}

// The distance by which A must move along n to be clear of B.
double depth_along(const Vec3& n, const Solid& A, const Solid& B) {
  double far_B = -infinity, near_A = -far_B;
  for (const Vec3& b : B.vertices) far_B = std::max(far_B, n.dot(b));
  for (const Vec3& a : A.vertices) near_A = std::min(near_A, n.dot(a));
  return far_B - near_A;
}

void face_normals_only(Subject&, const Scene& scene, Penetration& said) {
  if (said.verdict != Verdict::overlapping) return;
  const Solid A = solid(scene.bodies[0]), B = solid(scene.bodies[1]);
  double least = infinity;
  for (const Solid& owner : {A, B}) {
    for (const Vec3& normal : owner.normals) {
      for (const Vec3& n : {normal, Vec3(-normal)}) {
        if (depth_along(n, A, B) >= least) continue;
        least = depth_along(n, A, B);
        said.depth = least;
        said.nhat_BA_W = n;
      }
    }
  }
}

void shallow(Subject&, const Scene&, Penetration& said) {
  if (said.depth) *said.depth *= 1 - 1e-6;
}

// Moving A by this depth leaves 2.3 times the depth that may remain.
void slightly_shallow(Subject&, const Scene& scene, Penetration& said) {
  if (said.verdict == Verdict::overlapping && said.depth) *said.depth -= 1400 * rounding_of_length(scene);
  if (said.nhat_BA_W) *said.nhat_BA_W *= 1 + 416 * rounding;
}

void depth_when_apart(Subject& truthful, const Scene& scene, Penetration& said) {
  if (said.verdict == Verdict::separated) said.depth = -distance_by(truthful, scene);
}

void normal_flipped(Subject&, const Scene&, Penetration& said) {
  if (said.nhat_BA_W) *said.nhat_BA_W = -*said.nhat_BA_W;
}

void normal_not_unit(Subject&, const Scene&, Penetration& said) {
  if (said.nhat_BA_W) *said.nhat_BA_W *= 1 + 1e-12;
}

}  // namespace

std::vector<Canary> canaries_about_pairs_of_bodies() {
  return {
      lying("canary.signed_distance", "answers minus the depth for the distance of overlapping bodies",
            [] { return distances(signed_distance); }),
      lying("canary.near_means_touching", "says overlapping where less than 1e-9 m is between the bodies",
            near_means_touching),
      lying("canary.relative_1e6", "makes every distance too great by one part in a million",
            [] { return distances(relative_1e6); }),
      lying("canary.rounded_to_zero", "answers 0 for a distance below 1e-4 m, and still says separated",
            [] { return distances(rounded_to_zero); }),
      lying("canary.witnesses_swapped", "exchanges the witness points", [] { return distances(witnesses_swapped); }),
      lying("canary.witness_in_body_frame", "forgets that bodies are not at the origin",
            [] { return distances(witness_in_body_frame); }),
      lying("canary.witness_at_centre", "takes the body's origin for its witness point",
            [] { return distances(witness_at_centre); }),
      lying("canary.feature_off_by_one", "counts A's vertices from 1", [] { return distances(feature_off_by_one); }),
      lying("canary.feature_of_everything", "names all vertices of A as the closest feature",
            [] { return distances(feature_of_everything); }),
      lying("canary.narrow_enclosure", "claims an enclosure just above the distance",
            [] { return distances(narrow_enclosure); }),
      lying("canary.wide_enclosure", "claims an enclosure from 0 to twice the distance",
            [] { return distances(wide_enclosure); }),
      lying("canary.slightly_far", "makes distances too great by four times what rounding explains",
            [] { return distances(slightly_far); }),
      lying("canary.face_normals_only", "takes the least depth over face normals, forgetting pairs of edges",
            [] { return penetrations(face_normals_only); }),
      lying("canary.shallow", "makes every depth too small by one part in a million",
            [] { return penetrations(shallow); }),
      lying("canary.slightly_shallow",
            "makes depths too small, and directions too long, by a few times what rounding "
            "explains",
            [] { return penetrations(slightly_shallow); }),
      lying("canary.depth_when_apart", "answers minus the distance for the depth of separated bodies",
            [] { return penetrations(depth_when_apart); }),
      lying("canary.normal_flipped", "points from A to B", [] { return penetrations(normal_flipped); }),
      lying("canary.normal_not_unit", "makes the direction longer than 1 by 1e-12",
            [] { return penetrations(normal_not_unit); }),
  };
}

}  // namespace touchstone::oracle::subjects
