#include "fast/lin_canny/walk.h"

#include <algorithm>

namespace touchstone::fast::lin_canny {
namespace {

/// The edge at vertex v that rises most steeply along d (in the hull's frame); -1 if none does. How steep comes first,
/// which one second: no processor could predict the comparisons of a loop that asks for both.
int steepest(const Hull& hull, int v, const Vec3& d) {
  double most = 0;
  for (const Hull::Spoke* s = hull.spokes_begin(v); s != hull.spokes_end(v); ++s) most = std::max(most, s->away.dot(d));
  if (!(most > 0)) return -1;
  const Hull::Spoke* s = hull.spokes_begin(v);
  while (s->away.dot(d) != most) ++s;
  return s->edge;
}

/// The face that sees x from farthest outside; -1 if x is behind all of them.
int farthest_face(const Hull& hull, const Vec3& x) {
  int best = -1;
  double highest = 0;
  for (int f = 0; f < hull.face_count(); ++f) {
    const double height = hull.face(f).normal.dot(x) - hull.face(f).height;
    if (!(height > highest)) continue;
    best = f;
    highest = height;
  }
  return best;
}

class Walk {
 public:
  Walk(const Placed& A, const Placed& B, std::vector<Closest>* visited) : A_(A), B_(B), visited_(visited) {}

  Walked from(const FeaturePair& start) {
    now_ = closest(A_, B_, start);
    if (now_.below && !rise(now_)) return {now_, true, false};
    note();
    while (step()) note();
    return {now_, inside_, has_started_anew_};
  }

 private:
  void note() {
    if (visited_) visited_->push_back(now_);
  }

  bool step() {
    const Vec3 d = now_.b - now_.a;
    return leave_A(A_.turned_in(d)) || leave_B(B_.turned_in(-d));
  }

  bool leave_A(const Vec3& d) {
    return leave(A_, now_.features.a, d, [&](FeatureId next) { return FeaturePair{next, now_.features.b}; });
  }
  bool leave_B(const Vec3& d) {
    return leave(B_, now_.features.b, d, [&](FeatureId next) { return FeaturePair{now_.features.a, next}; });
  }

  template <class PairWith>
  bool leave(const Placed& P, const FeatureId& feature, const Vec3& d, PairWith&& pair_with) {
    if (feature.kind == Kind::vertex) {
      const int edge = steepest(*P.hull, feature.index, d);
      return edge >= 0 && take(pair_with({Kind::edge, edge}));
    }
    if (feature.kind == Kind::face) return false;
    const Hull::Edge& edge = P.hull->edge(feature.index);
    for (int i = 0; i < 2; ++i) {
      if (edge.out[i].dot(d) < 0 && take(pair_with({Kind::face, edge.face[i]}))) return true;
    }
    return false;
  }

  bool take(const FeaturePair& features) {
    if (inside_) return false;
    Closest next = closest(A_, B_, features);
    const bool through = next.below;
    if (through && !rise(next)) {
      inside_ = true;
      return false;
    }
    const bool nearer = next.squared < now_.squared;
    if (!nearer && (!through || has_started_anew_)) return false;
    has_started_anew_ = has_started_anew_ || !nearer;
    now_ = next;
    return true;
  }

  /// From below a face to the face that sees the point best; false if none does.
  bool rise(Closest& below) const {
    const bool on_A = below.features.a.kind == Kind::face;
    const Placed& faces = on_A ? A_ : B_;
    const Placed& other = on_A ? B_ : A_;
    const FeatureId point = on_A ? below.features.b : below.features.a;
    const int f = farthest_face(*faces.hull, faces.in(other.vertex(point.index)));
    if (f < 0) return false;
    const FeatureId face{Kind::face, f};
    below = closest(A_, B_, on_A ? FeaturePair{face, point} : FeaturePair{point, face});
    return true;
  }

  const Placed& A_;
  const Placed& B_;
  std::vector<Closest>* visited_;
  Closest now_;
  bool inside_ = false;
  bool has_started_anew_ = false;
};

}  // namespace

Walked walk(const Placed& A, const Placed& B, const FeaturePair& start, std::vector<Closest>* visited) {
  return Walk(A, B, visited).from(start);
}

}  // namespace touchstone::fast::lin_canny
