// The definition, written out: A ∩ B if it is not empty, else the least distance over every pair of vertices, edges and
// faces. O(n²) and worse. Intervals only skip candidates that certainly do not count; every value that counts is an
// exact integer.
#include <algorithm>
#include <optional>

#include "model/infinity.h"
#include "reference/distance/routes.h"
#include "reference/hull/faces.h"

namespace touchstone::reference {
namespace {

/// A core with all its exact normals.
struct Solid {
  explicit Solid(const PosedCore& posed) : core(posed), edges(edges_of(posed.faces())) {
    for (std::size_t f = 0; f < posed.faces().size(); ++f) {
      normals.push_back(exact_normal(posed, static_cast<int>(f)));
      around.push_back(enclosure(normals.back()));
    }
  }

  const PosedCore& core;
  std::vector<Edge> edges;
  std::vector<IntegerVec> normals;
  std::vector<EnclosureVec> around;

  const std::vector<int>& corners(std::size_t face) const { return core.faces()[face]; }
  std::size_t faces() const { return normals.size(); }
};

int sign_of(const Enclosure& x, const auto& exactly) {
  if (x.inf() > 0) return 1;
  if (x.sup() < 0) return -1;
  return sgn(Integer(exactly()));
}

/// The side of the face's plane on which a vertex of another core lies; > 0 outside.
int outside(const Solid& solid, std::size_t face, const PosedCore& other, int vertex) {
  const int base = solid.corners(face)[0];
  return sign_of(dot(solid.around[face], other.enclosed(vertex) - solid.core.enclosed(base)),
                 [&] { return dot(solid.normals[face], other.exact(vertex) - solid.core.exact(base)); });
}

bool holds(const Solid& solid, const PosedCore& other, int vertex) {
  if (solid.core.is_point()) return solid.core.exact(0) == other.exact(vertex);
  for (std::size_t f = 0; f < solid.faces(); ++f) {
    if (outside(solid, f, other, vertex) > 0) return false;
  }
  return true;
}

// --- A ∩ B. Its vertices are the vertices of one body inside the other, and the points where an edge of one crosses a
// face of the other.

/// The point where the edge crosses the face from one side to the other, if it does.
std::optional<HomogeneousPoint> crossing(const PosedCore& other, const Edge& edge, const Solid& solid,
                                         std::size_t face) {
  if (outside(solid, face, other, edge.tail) * outside(solid, face, other, edge.head) >= 0) return std::nullopt;
  const IntegerVec& p = other.exact(edge.tail);
  const IntegerVec along = other.exact(edge.head) - p;
  bool left = false;
  bool right = false;
  int u = solid.corners(face).back();
  for (const int v : solid.corners(face)) {
    const IntegerVec from = solid.core.exact(u) - p;
    const int turn = sgn(dot(along, cross(from, solid.core.exact(v) - p)));
    left = left || turn > 0;
    right = right || turn < 0;
    u = v;
  }
  if (left && right) return std::nullopt;
  const Integer rise = dot(solid.normals[face], along);
  const Integer run = dot(solid.normals[face], solid.core.exact(solid.corners(face)[0]) - p);
  const IntegerVec num = rise * p + run * along;
  return rise > 0 ? HomogeneousPoint{num, rise} : HomogeneousPoint{-num, -rise};
}

/// Points that span A ∩ B: all of them, or the first ones with volume (more are not needed).
class Intersection {
 public:
  Intersection(const Solid& A, const Solid& B) {
    add_vertices(A.core, B);
    add_vertices(B.core, A);
    add_crossings(A, B);
    add_crossings(B, A);
  }

  const std::vector<HomogeneousPoint>& points() const { return points_; }
  bool has_volume() const { return dimension_ == 3; }

 private:
  void add_vertices(const PosedCore& core, const Solid& other) {
    for (int v = 0; v < core.size() && !has_volume(); ++v) {
      if (holds(other, core, v)) add({core.exact(v), 1});
    }
  }

  void add_crossings(const Solid& solid, const Solid& other) {
    for (const Edge& e : solid.edges) {
      for (std::size_t f = 0; f < other.faces() && !has_volume(); ++f) {
        if (auto x = crossing(solid.core, e, other, f)) add(*std::move(x));
      }
    }
  }

  void add(HomogeneousPoint x) {
    points_.push_back(std::move(x));
    const HomogeneousPoint& origin = points_[0];
    const IntegerVec arm = origin.den * points_.back().num - points_.back().den * origin.num;
    if (dimension_ == 0 && !is_zero(arm)) {
      line_ = arm;
      dimension_ = 1;
    } else if (dimension_ == 1 && !is_zero(cross(line_, arm))) {
      normal_ = cross(line_, arm);
      dimension_ = 2;
    } else if (dimension_ == 2 && dot(normal_, arm) != 0) {
      dimension_ = 3;
    }
  }

  std::vector<HomogeneousPoint> points_;
  int dimension_ = 0;
  IntegerVec line_;
  IntegerVec normal_;
};

/// The vertices of the least face that contains all the points.
std::vector<int> least_face(const Solid& solid, const std::vector<HomogeneousPoint>& points) {
  std::vector<bool> on(static_cast<std::size_t>(solid.core.size()), true);
  for (std::size_t f = 0; f < solid.faces(); ++f) {
    const IntegerVec& base = solid.core.exact(solid.corners(f)[0]);
    const auto on_plane = [&](const HomogeneousPoint& x) { return dot(solid.normals[f], x.num - x.den * base) == 0; };
    if (!std::all_of(points.begin(), points.end(), on_plane)) continue;
    for (int v = 0; v < solid.core.size(); ++v) {
      if (outside(solid, f, solid.core, v) != 0) on[static_cast<std::size_t>(v)] = false;
    }
  }
  std::vector<int> face;
  for (int v = 0; v < solid.core.size(); ++v) {
    if (on[static_cast<std::size_t>(v)]) face.push_back(v);
  }
  return face;
}

bool is_all(const Solid& solid, const std::vector<int>& face) {
  return static_cast<int>(face.size()) == solid.core.size();
}

/// A common point without common volume means touching, unless one core is a point strictly inside the other.
CoreNearest contact(const Solid& A, const Solid& B, const Intersection& common) {
  CoreNearest result;
  result.point = common.points()[0];
  result.cores = Verdict::overlapping;
  if (common.has_volume()) return result;
  std::vector<int> face_A = least_face(A, common.points());
  std::vector<int> face_B = least_face(B, common.points());
  const bool point_within = (A.core.is_point() && is_all(B, face_B)) != (B.core.is_point() && is_all(A, face_A));
  if (point_within) return result;
  result.cores = Verdict::touching;
  result.face_A = std::move(face_A);
  result.face_B = std::move(face_B);
  return result;
}

// --- The least distance over the pairs of features whose nearest points are inside both features.

/// d = num/den from a point of B to a point of A, and the point of A.
struct Candidate {
  IntegerVec num;
  Integer den;
  HomogeneousPoint on_A;
};

class Least {
 public:
  /// An upper bound on the squared distance, in enclosed units.
  void bound(const Enclosure& squared) { ceiling_ = std::min(ceiling_, squared.sup()); }
  bool surely_farther(const Enclosure& squared) const { return squared.inf() > ceiling_; }

  void offer(Candidate c) {
    const Integer square = dot(c.num, c.num);
    if (best_ && square * best_->den * best_->den >= square_ * c.den * c.den) return;
    best_ = std::move(c);
    square_ = square;
  }

  const Candidate& best() const { return *best_; }

 private:
  double ceiling_ = infinity;
  std::optional<Candidate> best_;
  Integer square_;
};

Enclosure square(const Enclosure& x) { return CGAL::square(x); }
bool surely_negative(const Enclosure& x) { return x.sup() < 0; }

void vertex_vertex(const PosedCore& A, int a, const PosedCore& B, int b, Least& least) {
  const Enclosure squared = squared_length(A.enclosed(a) - B.enclosed(b));
  least.bound(squared);
  if (least.surely_farther(squared)) return;
  least.offer({A.exact(a) - B.exact(b), 1, {A.exact(a), 1}});
}

/// The vertex `v` of one core and an edge of the other; `sign` = 1 if the vertex is A's.
void vertex_edge(const PosedCore& one, int v, const PosedCore& other, const Edge& e, int sign, Least& least) {
  const EnclosureVec around_arm = one.enclosed(v) - other.enclosed(e.tail);
  const EnclosureVec around_edge = other.enclosed(e.head) - other.enclosed(e.tail);
  const Enclosure along = dot(around_arm, around_edge);
  const Enclosure whole = squared_length(around_edge);
  if (surely_negative(along) || surely_negative(whole - along)) return;
  if (whole.inf() > 0 && least.surely_farther(squared_length(cross(around_arm, around_edge)) / whole)) return;

  const IntegerVec arm = one.exact(v) - other.exact(e.tail);
  const IntegerVec edge = other.exact(e.head) - other.exact(e.tail);
  const Integer t = dot(arm, edge);
  const Integer den = dot(edge, edge);
  if (t <= 0 || t >= den) return;
  const IntegerVec on_edge = den * other.exact(e.tail) + t * edge;
  const IntegerVec apart = den * one.exact(v) - on_edge;
  if (sign > 0)
    least.offer({apart, den, {one.exact(v), 1}});
  else
    least.offer({-apart, den, {on_edge, den}});
}

void vertex_face(const PosedCore& one, int v, const Solid& other, std::size_t f, int sign, Least& least) {
  const int base = other.corners(f)[0];
  const EnclosureVec& around = other.around[f];
  const Enclosure height = dot(around, one.enclosed(v) - other.core.enclosed(base));
  if (surely_negative(height)) return;
  if (least.surely_farther(square(height) / squared_length(around))) return;
  int u = other.corners(f).back();
  for (const int w : other.corners(f)) {
    const EnclosureVec edge = other.core.enclosed(w) - other.core.enclosed(u);
    if (surely_negative(dot(cross(around, edge), one.enclosed(v) - other.core.enclosed(u)))) return;
    u = w;
  }

  const IntegerVec& n = other.normals[f];
  for (const int w : other.corners(f)) {
    const IntegerVec edge = other.core.exact(w) - other.core.exact(u);
    if (dot(cross(n, edge), one.exact(v) - other.core.exact(u)) < 0) return;
    u = w;
  }
  const Integer h = dot(n, one.exact(v) - other.core.exact(base));
  const Integer den = dot(n, n);
  const IntegerVec apart = h * n;
  if (sign > 0)
    least.offer({apart, den, {one.exact(v), 1}});
  else
    least.offer({-apart, den, {den * one.exact(v) - apart, den}});
}

void edge_edge(const PosedCore& A, const Edge& e, const PosedCore& B, const Edge& f, Least& least) {
  const EnclosureVec along_e = A.enclosed(e.head) - A.enclosed(e.tail);
  const EnclosureVec along_f = B.enclosed(f.head) - B.enclosed(f.tail);
  const EnclosureVec around_arm = B.enclosed(f.tail) - A.enclosed(e.tail);
  const EnclosureVec around = cross(along_e, along_f);
  const Enclosure whole = squared_length(around);
  if (whole.inf() > 0 && least.surely_farther(square(dot(around, around_arm)) / whole)) return;
  const Enclosure around_s = dot(cross(around_arm, along_f), around);
  const Enclosure around_t = dot(cross(around_arm, along_e), around);
  if (surely_negative(around_s) || surely_negative(whole - around_s)) return;
  if (surely_negative(around_t) || surely_negative(whole - around_t)) return;

  const IntegerVec d = A.exact(e.head) - A.exact(e.tail);
  const IntegerVec g = B.exact(f.head) - B.exact(f.tail);
  const IntegerVec arm = B.exact(f.tail) - A.exact(e.tail);
  const IntegerVec n = cross(d, g);
  if (is_zero(n)) return;  // parallel edges: a vertex of one gives the same distance
  const Integer den = dot(n, n);
  const Integer s = dot(cross(arm, g), n);
  const Integer t = dot(cross(arm, d), n);
  if (s < 0 || s > den || t < 0 || t > den) return;
  least.offer({Integer(-dot(n, arm)) * n, den, {den * A.exact(e.tail) + s * d, den}});
}

CoreNearest gap(const Solid& A, const Solid& B) {
  Least least;
  for (int a = 0; a < A.core.size(); ++a) {
    for (int b = 0; b < B.core.size(); ++b) {
      least.bound(squared_length(A.core.enclosed(a) - B.core.enclosed(b)));
    }
  }
  for (int a = 0; a < A.core.size(); ++a) {
    for (int b = 0; b < B.core.size(); ++b) vertex_vertex(A.core, a, B.core, b, least);
    for (const Edge& f : B.edges) vertex_edge(A.core, a, B.core, f, 1, least);
    for (std::size_t f = 0; f < B.faces(); ++f) vertex_face(A.core, a, B, f, 1, least);
  }
  for (int b = 0; b < B.core.size(); ++b) {
    for (const Edge& e : A.edges) vertex_edge(B.core, b, A.core, e, -1, least);
    for (std::size_t f = 0; f < A.faces(); ++f) vertex_face(B.core, b, A, f, -1, least);
  }
  for (const Edge& e : A.edges) {
    for (const Edge& f : B.edges) edge_edge(A.core, e, B.core, f, least);
  }
  CoreNearest result;
  result.normal = least.best().num;
  result.denominator = least.best().den;
  result.point = least.best().on_A;
  return result;
}

std::vector<int> extreme(const PosedCore& core, const IntegerVec& n) {
  std::vector<int> lowest;
  Integer least;
  for (int v = 0; v < core.size(); ++v) {
    const Integer height = dot(n, core.exact(v));
    if (lowest.empty() || height < least) lowest.clear();
    if (lowest.empty()) least = height;
    if (height == least) lowest.push_back(v);
  }
  return lowest;
}

}  // namespace

CoreNearest nearest_by_brute_force(PosedPair& pair) {
  const RoundUpward rounding;
  pair.A.enclose();
  pair.B.enclose();
  const Solid A(pair.A);
  const Solid B(pair.B);
  const Intersection common(A, B);
  if (!common.points().empty()) return contact(A, B, common);
  CoreNearest result = gap(A, B);
  result.face_A = extreme(pair.A, result.normal);
  result.face_B = extreme(pair.B, -result.normal);
  return result;
}

}  // namespace touchstone::reference
