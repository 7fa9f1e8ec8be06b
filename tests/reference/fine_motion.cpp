#include "tests/reference/fine_motion.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace touchstone::tests {
namespace {

FineVec fine(const Vec3& v) { return v.cast<Fine>(); }

std::vector<FineVec> edges(const std::vector<FineVec>& vertices, const std::vector<std::vector<int>>& faces) {
  std::set<std::pair<int, int>> pairs;
  for (const auto& face : faces) {
    for (std::size_t k = 0; k < face.size(); ++k) pairs.insert(std::minmax(face[k], face[(k + 1) % face.size()]));
  }
  std::vector<FineVec> result;
  for (const auto& [i, j] : pairs) {
    result.push_back(vertices[static_cast<std::size_t>(j)] - vertices[static_cast<std::size_t>(i)]);
  }
  return result;
}

}  // namespace

FineMotion::FineMotion(const Scene& scene, std::size_t index)
    : body_(scene.bodies[index]), gravity_(fine(scene.gravity)) {}

/// By the scene's quaternion, v + 2 (w a × v + a × (a × v))/|q|²; then by Rodrigues, v + sin θ u × v + (1 − cos θ) u ×
/// (u × v).
FineVec FineMotion::turned(const FineVec& v, double time) const {
  const Quaternion& q = body_.X_WB.q_WB;
  const FineVec a = fine(Vec3(q.x, q.y, q.z));
  const Fine w = q.w;
  const Fine scale = 2 / (w * w + a.dot(a));
  const FineVec once = a.cross(v);
  const FineVec start = v + scale * (w * once + a.cross(once));
  const FineVec omega = fine(body_.velocity.w_WB);
  const Fine rate = sqrt(omega.dot(omega));
  if (rate == 0) return start;
  const FineVec u = omega / rate;
  const Fine angle = rate * Fine(time);
  const Fine sine = sin(angle), rest = 1 - cos(angle);
  const FineVec across = u.cross(start);
  return start + sine * across + rest * u.cross(across);
}

FineVec FineMotion::place(double time) const {
  const Fine t = time, half_square = t * t / 2;
  return fine(body_.X_WB.p_WB) + t * fine(body_.velocity.v_WBcm) + half_square * gravity_;
}

std::vector<FineVec> FineMotion::vertices(double time) const {
  const FineVec p = place(time);
  std::vector<FineVec> result;
  for (const Vec3& v : std::get<Polytope>(body_.shape).vertices) result.push_back(p + turned(fine(v), time));
  return result;
}

Pose FineMotion::pose(double time) const {
  Mat3 R;
  for (int k = 0; k < 3; ++k) R.col(k) = turned(fine(Vec3::Unit(k)), time).cast<double>();
  const Eigen::Quaterniond q(R);
  return {place(time).cast<double>(), {q.w(), q.x(), q.y(), q.z()}};
}

const std::vector<std::vector<int>>& FineMotion::faces() const { return std::get<Polytope>(body_.shape).faces; }

Fine greatest_gap(const FineMotion& A, const FineMotion& B, double time) {
  const std::vector<FineVec> a = A.vertices(time), b = B.vertices(time);
  Fine greatest = -std::numeric_limits<Fine>::infinity();
  const auto try_axis = [&](const FineVec& n) {
    const Fine length = sqrt(n.dot(n));
    if (length == 0) return;
    const auto range = [&](const std::vector<FineVec>& points) {
      Fine low = n.dot(points[0]), high = low;
      for (const FineVec& p : points) {
        const Fine height = n.dot(p);
        low = std::min(low, height);
        high = std::max(high, height);
      }
      return std::pair{low, high};
    };
    const auto [a_low, a_high] = range(a);
    const auto [b_low, b_high] = range(b);
    greatest = std::max({greatest, Fine((a_low - b_high) / length), Fine((b_low - a_high) / length)});
  };
  const auto try_faces = [&](const std::vector<FineVec>& points, const std::vector<std::vector<int>>& faces) {
    for (const auto& face : faces) {
      const FineVec& corner = points[static_cast<std::size_t>(face[0])];
      try_axis((points[static_cast<std::size_t>(face[1])] - corner)
                   .cross(points[static_cast<std::size_t>(face[2])] - corner));
    }
  };
  try_faces(a, A.faces());
  try_faces(b, B.faces());
  for (const FineVec& e : edges(a, A.faces())) {
    for (const FineVec& f : edges(b, B.faces())) try_axis(e.cross(f));
  }
  return greatest;
}

}  // namespace touchstone::tests
