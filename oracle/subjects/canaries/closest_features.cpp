// Canaries with the mistakes that published closest-feature walks have made.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "oracle/rotation.h"
#include "oracle/subjects/canaries/lie.h"

namespace touchstone::oracle::subjects {
namespace {

/// Vertices, edges and faces in the world frame. Edges and faces are empty for a shape without faces.
struct Surface {
  std::vector<Vec3> vertices;
  std::vector<std::pair<Vec3, Vec3>> edges;
  std::vector<std::vector<Vec3>> faces;
};

std::vector<std::vector<int>> faces_of(const Shape& shape) {
  if (const Polytope* polytope = std::get_if<Polytope>(&shape)) return polytope->faces;
  if (!std::holds_alternative<Box>(shape)) return {};
  return {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
}

Surface surface(const Body& body) {
  const Eigen::Quaterniond R_WB = rotation(body.X_WB.q_WB);
  Surface found;
  for (const Vec3& v : corners(body)) found.vertices.emplace_back(R_WB * v + body.X_WB.p_WB);
  for (const std::vector<int>& face : faces_of(body.shape)) {
    std::vector<Vec3> polygon;
    for (const int i : face) polygon.push_back(found.vertices[static_cast<std::size_t>(i)]);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      found.edges.emplace_back(polygon[i], polygon[(i + 1) % polygon.size()]);
    }
    found.faces.push_back(polygon);
  }
  return found;
}

Vec3 normal(const std::vector<Vec3>& face) { return Vec3((face[1] - face[0]).cross(face[2] - face[0])).normalized(); }

bool is_over(const Vec3& p, const std::vector<Vec3>& face) {
  for (std::size_t i = 0; i < face.size(); ++i) {
    const Vec3& from = face[i];
    const Vec3& to = face[(i + 1) % face.size()];
    if (Vec3(to - from).cross(normal(face)).dot(p - from) > 0) return false;
  }
  return true;
}

bool is_inside(const Vec3& p, const Surface& S) {
  return std::ranges::all_of(S.faces, [&](const auto& face) { return normal(face).dot(p - face[0]) < 0; });
}

/// Applies the lie only to pairs of solids with faces, and only if the true verdict is `verdict`.
Lie<Distance> between_solids(Verdict verdict, void (*lie)(const Surface&, const Surface&, Distance&)) {
  return [=](Subject&, const Scene& scene, Distance& said) {
    const Surface A = surface(scene.bodies[0]);
    const Surface B = surface(scene.bodies[1]);
    if (said.verdict == verdict && !A.faces.empty() && !B.faces.empty()) lie(A, B, said);
  };
}

void keep_nearer(const Vec3& a, const Vec3& b, Distance& said) {
  if ((a - b).norm() >= *said.distance) return;
  said.distance = (a - b).norm();
  said.p_WCa = a;
  said.p_WCb = b;
}

void start_over(Distance& said) { said.distance = std::numeric_limits<double>::max(); }

void vertices_alone(const Surface& A, const Surface& B, Distance& said) {
  start_over(said);
  for (const Vec3& a : A.vertices) {
    for (const Vec3& b : B.vertices) keep_nearer(a, b, said);
  }
}

Vec3 nearest_on(const std::pair<Vec3, Vec3>& edge, const Vec3& p) {
  const Vec3 along = edge.second - edge.first;
  return edge.first + std::clamp(along.dot(p - edge.first) / along.squaredNorm(), 0.0, 1.0) * along;
}

void never_to_a_face(const Surface& A, const Surface& B, Distance& said) {
  start_over(said);
  for (const Vec3& a : A.vertices) {
    for (const auto& edge : B.edges) keep_nearer(a, nearest_on(edge, a), said);
  }
  for (const Vec3& b : B.vertices) {
    for (const auto& edge : A.edges) keep_nearer(nearest_on(edge, b), b, said);
  }
}

void edges_not_clipped(const Surface& A, const Surface& B, Distance& said) {
  for (const auto& [a, a_end] : A.edges) {
    for (const auto& [b, b_end] : B.edges) {
      const Vec3 n = Vec3(a_end - a).cross(b_end - b);
      if (n.norm() > 1e-6) said.distance = std::min(*said.distance, std::abs(n.normalized().dot(b - a)));
    }
  }
}

void faces_not_clipped(const Surface& A, const Surface& B, Distance& said) {
  for (const auto& face : B.faces) {
    for (const Vec3& a : A.vertices) {
      const double height = normal(face).dot(a - face[0]);
      if (height > 0) said.distance = std::min(*said.distance, height);
    }
  }
}

void below_means_inside(const Surface& A, const Surface& B, Distance& said) {
  for (const auto& face : B.faces) {
    for (const Vec3& a : A.vertices) {
      if (!is_over(a, face) || normal(face).dot(a - face[0]) >= 0) continue;
      said.verdict = Verdict::overlapping;
      said.distance = 0;
    }
  }
}

void shells(const Surface& A, const Surface& B, Distance& said) {
  double least = std::numeric_limits<double>::max();
  for (const Vec3& a : A.vertices) {
    if (!is_inside(a, B)) return;
    for (const auto& face : B.faces) least = std::min(least, -normal(face).dot(a - face[0]));
  }
  said.verdict = Verdict::separated;
  said.distance = least;
}

void gives_up(const Surface& A, const Surface& B, Distance& said) {
  if (A.vertices.size() + B.vertices.size() <= 12) return;
  said.verdict = Verdict::overlapping;
  said.distance = 0;
}

void one_step_short(Subject&, const Scene& scene, Distance& said) {
  if (said.verdict != Verdict::separated || !said.feature_A || said.feature_A->vertices.size() < 2) return;
  const Surface A = surface(scene.bodies[0]);
  said.feature_A->vertices.resize(1);
  said.p_WCa = A.vertices[static_cast<std::size_t>(said.feature_A->vertices[0])];
  said.distance = (*said.p_WCa - *said.p_WCb).norm();
}

void frames_exchanged(Subject& truthful, const Scene& scene, Distance& said) {
  Scene exchanged = scene;
  std::swap(exchanged.bodies[0].X_WB.q_WB, exchanged.bodies[1].X_WB.q_WB);
  with(truthful.distance(exchanged), [&](const Distance& wrong) { said = wrong; });
}

Lies stale_features() {
  std::optional<Feature> before;
  return distances([before](Subject&, const Scene&, Distance& said) mutable {
    if (!said.feature_A) return;
    const Feature now = *said.feature_A;
    said.feature_A = before.value_or(now);
    before = now;
  });
}

void cores_only(Subject&, const Scene& scene, Distance& said) {
  if (said.verdict != Verdict::separated) return;
  for (const Body& body : scene.bodies) {
    if (const Sphere* sphere = std::get_if<Sphere>(&body.shape)) *said.distance += sphere->radius;
  }
}

void first_part_only(Subject& truthful, const Scene& scene, Distance& said) {
  Scene some = scene;
  for (Body& body : some.bodies) {
    if (Compound* compound = std::get_if<Compound>(&body.shape)) compound->parts.resize(1);
  }
  with(truthful.distance(some), [&](const Distance& wrong) { said = wrong; });
}

void enclosure_of_what_was_computed(Subject&, const Scene&, Distance& said) {
  if (said.distance) said.enclosure = Interval{*said.distance, *said.distance};
}

}  // namespace

std::vector<Canary> canaries_about_closest_features() {
  const auto of_solids = [](const std::string& id, const std::string& says, Verdict verdict,
                            void (*lie)(const Surface&, const Surface&, Distance&)) {
    return lying(id, says, [=] { return distances(between_solids(verdict, lie)); });
  };
  return {
      of_solids("canary.vertices_alone", "never leaves a vertex for an edge: a Voronoi plane with the wrong sign",
                Verdict::separated, vertices_alone),
      of_solids("canary.never_to_a_face", "never leaves an edge for a face", Verdict::separated, never_to_a_face),
      of_solids("canary.edges_not_clipped", "takes lines for edges", Verdict::separated, edges_not_clipped),
      of_solids("canary.faces_not_clipped", "takes planes for faces", Verdict::separated, faces_not_clipped),
      of_solids("canary.below_means_inside",
                "takes a vertex that is below a face, within its sides, for one inside: no escape to a far face",
                Verdict::separated, below_means_inside),
      of_solids("canary.shells", "answers for surfaces: a body in a body is separated", Verdict::overlapping, shells),
      of_solids("canary.gives_up", "answers contact when there are more than twelve vertices to walk over",
                Verdict::separated, gives_up),
      lying("canary.one_step_short", "stops at a neighbour of the closest feature",
            [] { return distances(one_step_short); }),
      lying("canary.frames_exchanged", "turns A as B is turned and B as A", [] { return distances(frames_exchanged); }),
      lying("canary.stale_features", "names the feature that it found the last time", stale_features),
      lying("canary.cores_only", "forgets the radii of spheres", [] { return distances(cores_only); }),
      lying("canary.first_part_only", "sees the first part of a compound alone",
            [] { return distances(first_part_only); }),
      lying("canary.unrounded_enclosure", "claims that the distance is exactly the number computed",
            [] { return distances(enclosure_of_what_was_computed); }),
  };
}

}  // namespace touchstone::oracle::subjects
