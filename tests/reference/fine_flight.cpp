#include "tests/reference/fine_flight.h"

#include <algorithm>
#include <set>
#include <utility>

namespace touchstone::tests {
namespace {

using reference::cross;
using reference::inner;
using reference::minus;
using reference::plus;
using reference::scaled;

FineVec fine(const Vec3& v) { return {Float(v.x()), Float(v.y()), Float(v.z())}; }

std::vector<FineVec> edges(const std::vector<FineVec>& vertices, const std::vector<std::vector<int>>& faces) {
  std::set<std::pair<int, int>> pairs;
  for (const auto& face : faces) {
    for (std::size_t k = 0; k < face.size(); ++k) pairs.insert(std::minmax(face[k], face[(k + 1) % face.size()]));
  }
  std::vector<FineVec> result;
  for (const auto& [i, j] : pairs) {
    result.push_back(minus(vertices[static_cast<std::size_t>(j)], vertices[static_cast<std::size_t>(i)]));
  }
  return result;
}

}  // namespace

FineFlight::FineFlight(const Scene& scene, std::size_t index)
    : body_(scene.bodies[index]), gravity_(fine(scene.gravity)) {}

FineVec FineFlight::turned(const FineVec& v, double time) const {
  const Quaternion& q = body_.X_WB.q_WB;
  const FineVec axis = {Float(q.x), Float(q.y), Float(q.z)};
  const Float w(q.w);
  const FineVec once = cross(axis, v);  // v + 2 (w a × v + a × (a × v))/|q|²
  const FineVec start =
      plus(v, scaled(Float(2 / (w * w + inner(axis, axis))), plus(scaled(w, once), cross(axis, once))));
  const FineVec omega = fine(body_.velocity.w_WB);
  const Float rate = sqrt(inner(omega, omega));
  if (rate == 0) return start;
  const FineVec u = scaled(Float(1 / rate), omega);
  const Float angle = rate * Float(time);
  const FineVec across = cross(u, start);
  return plus(start, plus(scaled(Float(sin(angle)), across), scaled(Float(1 - cos(angle)), cross(u, across))));
}

FineVec FineFlight::place(double time) const {
  const Float t(time);
  return plus(fine(body_.X_WB.p_WB), plus(scaled(t, fine(body_.velocity.v_WBcm)), scaled(Float(t * t / 2), gravity_)));
}

std::vector<FineVec> FineFlight::vertices(double time) const {
  std::vector<FineVec> result;
  for (const Vec3& v : std::get<Polytope>(body_.shape).vertices)
    result.push_back(plus(place(time), turned(fine(v), time)));
  return result;
}

Pose FineFlight::pose(double time) const {
  const FineVec x = turned({1, 0, 0}, time), y = turned({0, 1, 0}, time), z = turned({0, 0, 1}, time);
  const FineVec p = place(time);
  const auto plain = [](const Float& f) { return static_cast<double>(f); };
  // Of the four columns of 4 q qᵀ, each a multiple of q, the longest.
  const std::array<std::array<Float, 4>, 4> columns = {{
      {Float(1 + x[0] + y[1] + z[2]), Float(y[2] - z[1]), Float(z[0] - x[2]), Float(x[1] - y[0])},
      {Float(y[2] - z[1]), Float(1 + x[0] - y[1] - z[2]), Float(x[1] + y[0]), Float(z[0] + x[2])},
      {Float(z[0] - x[2]), Float(x[1] + y[0]), Float(1 - x[0] + y[1] - z[2]), Float(y[2] + z[1])},
      {Float(x[1] - y[0]), Float(z[0] + x[2]), Float(y[2] + z[1]), Float(1 - x[0] - y[1] + z[2])},
  }};
  std::size_t longest = 0;
  for (std::size_t k = 1; k < 4; ++k) {
    if (columns[k][k] > columns[longest][longest]) longest = k;
  }
  const auto& q = columns[longest];
  return {Vec3(plain(p[0]), plain(p[1]), plain(p[2])), {plain(q[0]), plain(q[1]), plain(q[2]), plain(q[3])}};
}

const std::vector<std::vector<int>>& FineFlight::faces() const { return std::get<Polytope>(body_.shape).faces; }

Float greatest_gap(const FineFlight& A, const FineFlight& B, double time) {
  const std::vector<FineVec> a = A.vertices(time), b = B.vertices(time);
  Float greatest = -std::numeric_limits<Float>::infinity();
  const auto try_axis = [&](FineVec n) {
    const Float square = inner(n, n);
    if (square == 0) return;
    n = scaled(Float(1 / sqrt(square)), n);
    const auto range = [&n](const std::vector<FineVec>& points) {
      Float low = inner(n, points[0]), high = low;
      for (const FineVec& p : points) {
        const Float height = inner(n, p);
        low = std::min(low, height);
        high = std::max(high, height);
      }
      return std::pair{low, high};
    };
    const auto [a_low, a_high] = range(a);
    const auto [b_low, b_high] = range(b);
    greatest = std::max({greatest, Float(a_low - b_high), Float(b_low - a_high)});
  };
  for (const auto& [points, faces] : {std::pair(&a, &A.faces()), std::pair(&b, &B.faces())}) {
    for (const auto& face : *faces) {
      const auto at = [&, p = points](std::size_t k) { return (*p)[static_cast<std::size_t>(face[k])]; };
      try_axis(cross(minus(at(1), at(0)), minus(at(2), at(0))));
    }
  }
  for (const FineVec& e : edges(a, A.faces())) {
    for (const FineVec& f : edges(b, B.faces())) try_axis(cross(e, f));
  }
  return greatest;
}

}  // namespace touchstone::tests
