#include "reference/pixel.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <variant>

#include "model/box_vertices.h"
#include "model/input_error.h"
#include "reference/distance/balls.h"
#include "reference/distance/common_points.h"
#include "reference/exact/rational.h"
#include "reference/pixel/projection.h"

namespace touchstone::reference {
namespace {

/// One convex part in half pixels: a ball, or a hull and its projection.
struct PosedPart {
  std::optional<Ball> ball;
  Hull hull;
  std::optional<Projection> projection;
};

/// Maps W to half pixels.
struct Grid {
  explicit Grid(const Raster& raster)
      : corner{mpq_class(raster.x), mpq_class(raster.y), 0}, per_metre(2 / mpq_class(raster.pixel)) {}

  Triple operator()(const Triple& p_W) const {
    const Triple p = minus(p_W, corner);
    return {mpq_class(per_metre * p[0]), mpq_class(per_metre * p[1]), mpq_class(per_metre * p[2])};
  }

  Triple corner;
  mpq_class per_metre;
};

Triple cross(const Triple& a, const Triple& b) {
  return {mpq_class(a[1] * b[2] - a[2] * b[1]), mpq_class(a[2] * b[0] - a[0] * b[2]),
          mpq_class(a[0] * b[1] - a[1] * b[0])};
}

PosedPart posed_part(const Sphere& sphere, const Motion& X_WP, const Grid& grid) {
  const mpq_class radius = grid.per_metre * mpq_class(sphere.radius);
  PosedPart made;
  made.ball = Ball{grid(X_WP.translation), radius * radius};
  return made;
}

PosedPart posed_part(const Polytope& polytope, const Motion& X_WP, const Grid& grid) {
  std::vector<Triple> vertices;
  for (const Vec3& v : polytope.vertices) vertices.push_back(grid(X_WP(triple(v))));
  const auto at = [&](int i) -> const Triple& { return vertices[static_cast<std::size_t>(i)]; };
  PosedPart made;
  for (const std::vector<int>& face : polytope.faces) {
    Triple normal{0, 0, 0};  // Newell's formula: the first three vertices may be collinear
    for (std::size_t i = 0; i < face.size(); ++i) {
      const int tail = face[i];
      const int head = face[(i + 1) % face.size()];
      normal = plus(normal, 1, cross(minus(at(tail), at(face[0])), minus(at(head), at(face[0]))));
      if (tail < head) made.hull.edges.push_back({at(tail), at(head)});  // the adjacent face has it from head to tail
    }
    made.hull.sides.push_back({normal, dot(normal, at(face[0]))});
  }
  made.projection.emplace(vertices);
  return made;
}

PosedPart posed_part(const Box& box, const Motion& X_WP, const Grid& grid) {
  return posed_part(as_polytope(box), X_WP, grid);
}

std::vector<PosedPart> parts_of(const Body& body, const Grid& grid) {
  const Motion X_WB = motion(body.X_WB);
  if (const auto* compound = std::get_if<Compound>(&body.shape)) {
    std::vector<PosedPart> parts;
    for (const Part& part : compound->parts) {
      const Motion X_WP = composed(X_WB, motion(part.X_BP));
      parts.push_back(std::visit([&](const auto& solid) { return posed_part(solid, X_WP, grid); }, part.shape));
    }
    return parts;
  }
  if (const auto* sphere = std::get_if<Sphere>(&body.shape)) return {posed_part(*sphere, X_WB, grid)};
  if (const auto* box = std::get_if<Box>(&body.shape)) return {posed_part(*box, X_WB, grid)};
  return {posed_part(std::get<Polytope>(body.shape), X_WB, grid)};
}

mpq_class squared_distance(const mpq_class& x, long lo, long hi) {
  const mpq_class off = x < lo ? mpq_class(lo - x) : x > hi ? mpq_class(x - hi) : mpq_class(0);
  return off * off;
}

/// From the centre of a ball, in the plane.
mpq_class squared_distance(const Ball& ball, const Rectangle& square) {
  return squared_distance(ball.centre[0], square.x_lo, square.x_hi) +
         squared_distance(ball.centre[1], square.y_lo, square.y_hi);
}

bool intersects(const PosedPart& part, const Rectangle& square) {
  return part.ball ? squared_distance(*part.ball, square) <= part.ball->squared_radius
                   : part.projection->intersects(square);
}

std::vector<HalfSpace> prism_over(const Rectangle& square) {
  return {{{1, 0, 0}, square.x_hi}, {{-1, 0, 0}, -square.x_lo}, {{0, 1, 0}, square.y_hi}, {{0, -1, 0}, -square.y_lo}};
}

/// The projection of the intersection of a part of A and a part of B.
class Common {
 public:
  Common(const PosedPart& A, const PosedPart& B) : A_(A), B_(B) {
    if (!A.ball && !B.ball) projection_.emplace(common_points(A.hull, B.hull));
  }

  bool intersects(const Rectangle& square) const {
    if (projection_) return projection_->intersects(square);
    if (!reference::intersects(A_, square) || !reference::intersects(B_, square)) return false;
    std::vector<Ball> balls;
    std::vector<HalfSpace> sides = prism_over(square);
    for (const PosedPart* part : {&A_, &B_}) {
      if (part->ball) balls.push_back(*part->ball);
      sides.insert(sides.end(), part->hull.sides.begin(), part->hull.sides.end());
    }
    return have_common_point(balls, sides);
  }

 private:
  const PosedPart& A_;
  const PosedPart& B_;
  std::optional<Projection> projection_;
};

Rectangle square_of(int i, int j) { return {2L * i, 2L * i + 2, 2L * j, 2L * j + 2}; }
Rectangle squares_around(int i, int j, int n) {
  return {2L * i - 2L * n, 2L * i + 2 + 2L * n, 2L * j - 2L * n, 2L * j + 2 + 2L * n};
}
Rectangle centre_of(int i, int j) { return {2L * i + 1, 2L * i + 1, 2L * j + 1, 2L * j + 1}; }

template <class Parts>
Mask mask(const Raster& raster, const Parts& parts, Rectangle (*place)(int, int)) {
  Mask rows;
  for (int j = 0; j < raster.rows; ++j) {
    std::string& row = rows.emplace_back();
    for (int i = 0; i < raster.columns; ++i) {
      const bool in = std::ranges::any_of(parts, [&](const auto& part) { return intersects(part, place(i, j)); });
      row += in ? '1' : '0';
    }
  }
  return rows;
}

bool intersects(const Common& common, const Rectangle& square) { return common.intersects(square); }

MaskOverlap overlap_of(const Mask& A, const Mask& B, const Raster& raster) {
  MaskOverlap overlap;
  for (int j = 0; j < raster.rows; ++j) {
    for (int i = 0; i < raster.columns; ++i) {
      const std::int64_t column = std::int64_t{i} - raster.shift_x;
      const std::int64_t row = std::int64_t{j} - raster.shift_y;
      if (column < 0 || column >= raster.columns || row < 0 || row >= raster.rows) continue;
      const bool in_A = A[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] == '1';
      const bool in_B = B[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] == '1';
      if (!in_A || !in_B) continue;
      if (overlap.count++ == 0) overlap.first = {i, j};
    }
  }
  return overlap;
}

/// The interval from lo − √spread to hi + √spread.
struct Depths {
  mpq_class lo, hi, spread;
};

/// The depths of a part over a square that intersects its projection.
Depths depths_over(const PosedPart& part, const Rectangle& square) {
  if (part.ball) {
    const mpq_class& z = part.ball->centre[2];
    return {z, z, part.ball->squared_radius - squared_distance(*part.ball, square)};
  }
  mpq_class lowest = part.hull.edges.front().from[2];
  mpq_class highest = lowest;
  for (const Segment& edge : part.hull.edges) {
    for (const Triple& end : {edge.from, edge.to}) {
      if (end[2] < lowest) lowest = end[2];
      if (end[2] > highest) highest = end[2];
    }
  }
  Hull prism{{}, prism_over(square)};
  for (const long x : {square.x_lo, square.x_hi}) {
    for (const long y : {square.y_lo, square.y_hi}) prism.edges.push_back({{x, y, lowest}, {x, y, highest}});
  }
  const std::vector<Triple> points = common_points(part.hull, prism);
  const auto by_z = [](const Triple& p, const Triple& q) { return p[2] < q[2]; };
  const auto [low, high] = std::minmax_element(points.begin(), points.end(), by_z);
  return {(*low)[2], (*high)[2], 0};
}

/// Tests x.lo − √x.spread ≤ y.hi + √y.spread + apart.
bool starts_before_end(const Depths& x, const Depths& y, const mpq_class& apart) {
  const mpq_class gap = x.lo - y.hi - apart;
  if (gap <= 0) return true;
  const mpq_class beyond = gap * gap - x.spread - y.spread;  // gap² ≤ (√ + √)²
  return beyond <= 0 || beyond * beyond <= 4 * x.spread * y.spread;
}

}  // namespace

Pixels pixel(const Scene& scene) {
  if (!scene.raster) throw InputError("raster", "missing; expected one to ask about pixels");
  const Raster& raster = *scene.raster;
  const Grid grid(raster);
  Pixels exact;
  std::vector<std::vector<PosedPart>> bodies;
  for (const Body& body : scene.bodies) {
    bodies.push_back(parts_of(body, grid));
    exact.sampled.push_back(mask(raster, bodies.back(), centre_of));
    exact.conservative.push_back(mask(raster, bodies.back(), square_of));
  }
  std::vector<Common> common;
  if (bodies.size() >= 2) {
    exact.overlap = overlap_of(exact.sampled[0], exact.sampled[1], raster);
    for (const PosedPart& a : bodies[0]) {
      for (const PosedPart& b : bodies[1]) common.emplace_back(a, b);
    }
  }
  exact.meet_sampled = mask(raster, common, centre_of);
  exact.meet_conservative = mask(raster, common, square_of);
  return exact;
}

bool projection_comes_near(const Scene& scene, std::size_t body, int column, int row, int around) {
  const Rectangle square = squares_around(column, row, around);
  return std::ranges::any_of(parts_of(scene.bodies.at(body), Grid(scene.raster.value())),
                             [&](const PosedPart& part) { return intersects(part, square); });
}

bool depths_come_near(const Scene& scene, int column, int row, int around, const Rational& apart) {
  const Grid grid(scene.raster.value());
  const mpq_class allowed = grid.per_metre * value_of(apart);
  const Rectangle square = squares_around(column, row, around);
  for (const PosedPart& a : parts_of(scene.bodies.at(0), grid)) {
    if (!intersects(a, square)) continue;
    const Depths of_A = depths_over(a, square);
    for (const PosedPart& b : parts_of(scene.bodies.at(1), grid)) {
      if (!intersects(b, square)) continue;
      const Depths of_B = depths_over(b, square);
      if (starts_before_end(of_A, of_B, allowed) && starts_before_end(of_B, of_A, allowed)) return true;
    }
  }
  return false;
}

}  // namespace touchstone::reference
