// A − B is the sum of A and −B. The depth is the least value over unit directions n of the sum's support function
//   h(n) = max n·a + max n·(−b).
// The minimum is at a facet normal: of a face of A, of a face of −B, or e × f for edges whose Gauss-map arcs cross
// (those n between the normals of the faces adjacent to e that are also between those adjacent to f). Any direction
// gives an upper bound (the ceiling). Any one vertex w of the sum gives a lower bound along n; on an edge's arc between
// unit normals l and r it is min(l·w, r·w), as n = αl + βr with α + β ≥ |n| = 1. Intervals drop the candidates that are
// certainly above the ceiling; exact integers decide among the rest.
#include <algorithm>

#include "model/infinity.h"
#include "reference/hull/faces.h"
#include "reference/penetration/routes.h"

namespace touchstone::reference {
namespace {

/// A, or −B.
struct Summand {
  Summand(const PosedCore& posed, int times) : core(posed), sign(times), edges(edges_of(posed.faces())) {
    const auto signed_vec = [&](const EnclosureVec& v) { return sign > 0 ? v : -v; };
    for (int i = 0; i < posed.size(); ++i) points.push_back(signed_vec(posed.enclosed(i)));
    for (std::size_t f = 0; f < posed.faces().size(); ++f) {
      const EnclosureVec n = signed_vec(enclosed_normal(posed, static_cast<int>(f)));
      normals.push_back(Enclosure(1 / CGAL::sqrt(squared_length(n))) * n);
    }
  }

  const PosedCore& core;
  int sign;
  std::vector<Edge> edges;
  std::vector<EnclosureVec> points;
  std::vector<EnclosureVec> normals;  ///< outward unit vectors

  const EnclosureVec& point(int i) const { return points[static_cast<std::size_t>(i)]; }
  const EnclosureVec& normal(int f) const { return normals[static_cast<std::size_t>(f)]; }
  int corner(int f) const { return core.faces()[static_cast<std::size_t>(f)][0]; }
  EnclosureVec along(const Edge& e) const { return point(e.head) - point(e.tail); }

  IntegerVec exact(int i) const { return sign > 0 ? core.exact(i) : -core.exact(i); }
  IntegerVec exact_outward(int f) const { return sign > 0 ? exact_normal(core, f) : -exact_normal(core, f); }
  IntegerVec exact_along(const Edge& e) const { return exact(e.head) - exact(e.tail); }
};

struct Support {
  int vertex = 0;
  Enclosure height;
};

Support support(const Summand& summand, const EnclosureVec& n) {
  Support best{0, dot(n, summand.point(0))};
  double high = best.height.sup();
  for (int i = 1; i < static_cast<int>(summand.points.size()); ++i) {
    const Enclosure height = dot(n, summand.point(i));
    high = std::max(high, height.sup());
    if (height.inf() > best.height.inf()) best = {i, height};
  }
  best.height = Enclosure(best.height.inf(), high);
  return best;
}

/// max n·x over the summand's vertices, exactly.
Integer exact_support(const Summand& summand, const IntegerVec& n) {
  const EnclosureVec around = enclosure(n);
  const double low = support(summand, around).height.inf();
  Integer best;
  bool found = false;
  for (int i = 0; i < summand.core.size(); ++i) {
    if (dot(around, summand.point(i)).sup() < low) continue;
    const Integer height = dot(n, summand.exact(i));
    if (!found || height > best) best = height;
    found = true;
  }
  return best;
}

bool is_support(const Summand& summand, const IntegerVec& n, int vertex) {
  const EnclosureVec around = enclosure(n);
  const int sign = summand.sign;
  for (int i = 0; i < summand.core.size(); ++i) {
    if (sign * side(summand.core, n, around, i, vertex) > 0) return false;
  }
  return true;
}

/// Neither factor is certainly 0, and the two do not certainly have the same sign.
bool may_differ_in_sign(const Enclosure& x, const Enclosure& y) {
  const bool zero = (x.inf() == 0 && x.sup() == 0) || (y.inf() == 0 && y.sup() == 0);
  return !zero && !(x.inf() > 0 && y.inf() > 0) && !(x.sup() < 0 && y.sup() < 0);
}

bool surely_differ_in_sign(const Enclosure& x, const Enclosure& y) {
  return (x.inf() > 0 && y.sup() < 0) || (x.sup() < 0 && y.inf() > 0);
}

class GaussMap {
 public:
  explicit GaussMap(const PosedPair& pair) : A_(pair.A, 1), B_(pair.B, -1) {
    scan_faces(A_, B_, faces_A_, opposite_A_);
    scan_faces(B_, A_, faces_B_, opposite_B_);
    scan_edge_pairs(low_edges(A_, B_, opposite_A_), low_edges(B_, A_, opposite_B_));
  }

  CoreDepth least() const {
    Shallowest shallowest;
    offer_faces(A_, B_, faces_A_, shallowest);
    offer_faces(B_, A_, faces_B_, shallowest);
    for (const EdgePair& p : edge_pairs_) {
      if (p.low <= ceiling_) offer_edges(*p.e, *p.f, shallowest);
    }
    return shallowest.take();
  }

 private:
  struct Face {
    int face;
    double low;
  };
  struct EdgePair {
    const Edge* e;
    const Edge* f;
    double low;
  };

  /// Heights of the faces of `one`. `opposite` is, for each face, a vertex of `other` that gives a high lower bound.
  void scan_faces(const Summand& one, const Summand& other, std::vector<Face>& faces, std::vector<int>& opposite) {
    int last = 0;
    for (int f = 0; f < static_cast<int>(one.normals.size()); ++f) {
      const EnclosureVec& n = one.normal(f);
      const Enclosure own = dot(n, one.point(one.corner(f)));
      if ((own + dot(n, other.point(last))).inf() <= ceiling_) {
        const Support far = support(other, n);
        last = far.vertex;
        const Enclosure height = own + far.height;
        ceiling_ = std::min(ceiling_, height.sup());
        faces.push_back({f, height.inf()});
      }
      opposite.push_back(last);
    }
  }

  /// Edges whose arc is not certainly above the ceiling as a whole.
  std::vector<const Edge*> low_edges(const Summand& one, const Summand& other, const std::vector<int>& opposite) const {
    std::vector<const Edge*> low;
    for (const Edge& e : one.edges) {
      const EnclosureVec& l = one.normal(e.left);
      const EnclosureVec& r = one.normal(e.right);
      const auto surely_above = [&](int vertex) {
        const EnclosureVec w = one.point(e.tail) + other.point(vertex);
        return dot(l, w).inf() > ceiling_ && dot(r, w).inf() > ceiling_;
      };
      if (surely_above(opposite[static_cast<std::size_t>(e.left)])) continue;
      if (surely_above(opposite[static_cast<std::size_t>(e.right)])) continue;
      if (surely_above(support(other, l + r).vertex)) continue;
      low.push_back(&e);
    }
    return low;
  }

  void scan_edge_pairs(const std::vector<const Edge*>& edges_A, const std::vector<const Edge*>& edges_B) {
    for (const Edge* e : edges_A) {
      const EnclosureVec along_e = A_.along(*e);
      for (const Edge* f : edges_B) {
        const Enclosure e_left = dot(along_e, B_.normal(f->left));
        const Enclosure e_right = dot(along_e, B_.normal(f->right));
        if (!may_differ_in_sign(e_left, e_right)) continue;
        const EnclosureVec along_f = B_.along(*f);
        const Enclosure f_left = dot(along_f, A_.normal(e->left));
        const Enclosure f_right = dot(along_f, A_.normal(e->right));
        if (!may_differ_in_sign(f_left, f_right)) continue;
        weigh(*e, *f, along_e, along_f,
              surely_differ_in_sign(e_left, e_right) && surely_differ_in_sign(f_left, f_right));
      }
    }
  }

  /// The great circles of the arcs cross where the arcs do, or at the antipodal points.
  void weigh(const Edge& e, const Edge& f, const EnclosureVec& along_e, const EnclosureVec& along_f,
             bool circles_cross) {
    const EnclosureVec n = cross(along_e, along_f);
    const Enclosure outward_A = dot(n, A_.normal(e.left) + A_.normal(e.right));
    const Enclosure outward_B = dot(n, B_.normal(f.left) + B_.normal(f.right));
    if (surely_differ_in_sign(outward_A, outward_B)) return;
    double low = 0;
    const bool outward = outward_A.inf() > 0 || outward_A.sup() < 0;
    const Enclosure length = CGAL::sqrt(squared_length(n));
    if (outward && length.inf() > 0) {
      const Enclosure gap = dot(n, A_.point(e.tail) + B_.point(f.tail)) / length;
      const Enclosure height = outward_A.inf() > 0 ? gap : -gap;
      if (height.inf() > ceiling_) return;
      const bool arcs_cross = circles_cross && (outward_B.inf() > 0 || outward_B.sup() < 0);
      if (arcs_cross) ceiling_ = std::min(ceiling_, height.sup());
      low = height.inf();
    }
    edge_pairs_.push_back({&e, &f, low});
  }

  void offer_faces(const Summand& one, const Summand& other, const std::vector<Face>& faces,
                   Shallowest& shallowest) const {
    for (const Face& f : faces) {
      if (f.low > ceiling_) continue;
      const IntegerVec n = one.exact_outward(f.face);
      shallowest.offer(n, dot(n, one.exact(one.corner(f.face))) + exact_support(other, n));
    }
  }

  void offer_edges(const Edge& e, const Edge& f, Shallowest& shallowest) const {
    const IntegerVec n = cross(A_.exact_along(e), B_.exact_along(f));
    if (is_zero(n)) return;
    for (const IntegerVec& outward : {n, -n}) {
      if (!is_support(A_, outward, e.tail) || !is_support(B_, outward, f.tail)) continue;
      shallowest.offer(outward, dot(outward, A_.exact(e.tail) + B_.exact(f.tail)));
      return;
    }
  }

  Summand A_;
  Summand B_;
  double ceiling_ = infinity;
  std::vector<Face> faces_A_;
  std::vector<Face> faces_B_;
  std::vector<int> opposite_A_;
  std::vector<int> opposite_B_;
  std::vector<EdgePair> edge_pairs_;
};

}  // namespace

CoreDepth depth_by_gauss_map(PosedPair& pair) {
  const RoundUpward rounding;
  pair.A.enclose();
  pair.B.enclose();
  return GaussMap(pair).least();
}

}  // namespace touchstone::reference
