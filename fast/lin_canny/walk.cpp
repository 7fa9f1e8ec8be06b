#include "fast/lin_canny/walk.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "fast/lin_canny/facing.h"
#include "fast/mark.h"

namespace touchstone::fast::lin_canny {
namespace {

/// Where slopes are the same or 0 as floats can tell.
int steepest_in_doubles(const Hull& hull, int v, const Vec3& d) {
  mark(Mark::walk_in_doubles);
  return steepest_edge(hull, v, d);
}

/// The edge at vertex v that rises most steeply along d (in the hull's frame); -1 if none does.
int steepest(const Hull& hull, int v, const Vec3& d) {
  const FloatDirection direction(d);
  if (direction.lead_down(hull.spokes(v))) return -1;
  float most = direction.error();
  for (const Hull::Spokes& some : hull.spokes(v)) {
    const FloatDirection::Slopes s = direction.slopes(some);
    most = std::max(most, std::max(std::max(s[0], s[1]), std::max(s[2], s[3])));
  }
  if (!(most > direction.error())) return steepest_in_doubles(hull, v, d);
  const float about_as_steep = most - 2 * direction.error();
  int steepest = -1;
  for (const Hull::Spokes& some : hull.spokes(v)) {
    const FloatDirection::Slopes slopes = direction.slopes(some);
    for (std::size_t lane = 0; lane < Hull::Spokes::lanes; ++lane) {
      if (slopes[lane] < about_as_steep) continue;
      const int edge = hull.edge_of(some, lane);
      if (steepest >= 0 && edge != steepest) return steepest_in_doubles(hull, v, d);
      steepest = edge;
    }
  }
  return steepest;
}

/// The face whose plane x is farthest outside of; -1 if x is behind all of them.
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

/// A walk that takes more steps started far away: its memory is of another pose, or it has none. Few walks of a body
/// that turns by 10 degrees a frame do, and of unrelated poses of large hulls most do. A choice.
constexpr int steps_from_afar = 5;

class Walk {
 public:
  Walk(const PosedHull& A, const PosedHull& B, std::vector<Closest>* visited) : A_(A), B_(B), visited_(visited) {}

  Walked from(const FeaturePair& start) {
    mark(Mark::walk);
    now_ = closest(A_, B_, start);
    if (now_.below && !rise(now_)) {
      mark(Mark::walk_inside);
      return {now_, true, false};
    }
    note();
    for (int steps = 1; step(); ++steps) {
      note();
      if (steps == steps_from_afar) start_afresh();
    }
    if (inside_) mark(Mark::walk_inside);
    if (has_restarted_) mark(Mark::walk_restart);
    return {now_, inside_, has_restarted_};
  }

 private:
  void note() {
    if (visited_) visited_->push_back(now_);
  }

  /// Goes on from features that face each other, if they are nearer.
  void start_afresh() {
    if (inside_) return;
    const Closest facing = closest(A_, B_, facing_features(A_, B_));
    if (!(facing.squared < now_.squared)) return;
    now_ = facing;
    mark(Mark::walk_step);
    note();
  }

  bool step() {
    const Vec3 d = now_.b - now_.a;
    return leave_A(d) || leave_B(-d);
  }

  bool leave_A(const Vec3& d) {
    return leave(A_, now_.features.a, d, [&](FeatureId next) { return FeaturePair{next, now_.features.b}; });
  }
  bool leave_B(const Vec3& d) {
    return leave(B_, now_.features.b, d, [&](FeatureId next) { return FeaturePair{now_.features.a, next}; });
  }

  template <class PairWith>
  bool leave(const PosedHull& P, const FeatureId& feature, const Vec3& from_P, PairWith&& pair_with) {
    if (feature.kind == Kind::face) return false;
    const Vec3 d = P.turned_in(from_P);
    if (feature.kind == Kind::vertex) {
      const int edge = steepest(*P.hull, feature.index, d);
      return edge >= 0 && take(pair_with({Kind::edge, edge}));
    }
    const Hull::Edge& edge = P.hull->edge(feature.index);
    const Vec3 along = P.hull->along(edge);
    const auto into = [&](int face, const Vec3& along_face) {
      return along_face.cross(P.hull->face(face).normal).dot(d) < 0 && take(pair_with({Kind::face, face}));
    };
    return into(edge.face[0], along) || into(edge.face[1], -along);
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
    if (!nearer && (!through || has_restarted_)) return false;
    has_restarted_ = has_restarted_ || !nearer;
    now_ = next;
    mark(Mark::walk_step);
    return true;
  }

  /// Goes from below a face to the face whose plane the point is farthest outside of; false if there is none.
  bool rise(Closest& below) const {
    const bool on_A = below.features.a.kind == Kind::face;
    const PosedHull& faces = on_A ? A_ : B_;
    const PosedHull& other = on_A ? B_ : A_;
    const FeatureId point = on_A ? below.features.b : below.features.a;
    const int f = farthest_face(*faces.hull, faces.in(other.vertex(point.index)));
    if (f < 0) return false;
    const FeatureId face{Kind::face, f};
    below = closest(A_, B_, on_A ? FeaturePair{face, point} : FeaturePair{point, face});
    return true;
  }

  const PosedHull& A_;
  const PosedHull& B_;
  std::vector<Closest>* visited_;
  Closest now_;
  bool inside_ = false;
  bool has_restarted_ = false;
};

/// -1 if there is none.
int edge_between(const Hull& hull, int v, int w) {
  for (const Hull::Spokes& some : hull.spokes(v)) {
    for (std::size_t lane = 0; lane < Hull::Spokes::lanes; ++lane) {
      if (some.other[lane] == w) return hull.edge_of(some, lane);
    }
  }
  return -1;
}

}  // namespace

int steepest_edge(const Hull& hull, int v, const Vec3& d) {
  int steepest = -1;
  double most = 0;
  for (const Hull::Spokes& some : hull.spokes(v)) {
    for (std::size_t lane = 0; lane < Hull::Spokes::lanes; ++lane) {
      const Vec3 along = hull.vertex(some.other[lane]) - hull.vertex(v);
      const double slope = Vec3(along / along.norm()).dot(d);
      if (slope > most) most = slope, steepest = hull.edge_of(some, lane);
    }
  }
  return steepest;
}

Walked walk(const PosedHull& A, const PosedHull& B, const FeaturePair& start, std::vector<Closest>* visited) {
  return Walk(A, B, visited).from(start);
}

FeaturePair facing_features(const PosedHull& A, const PosedHull& B) {
  const auto along_line = [&](const Vec3& d) {
    return std::pair(facing(*A.hull, A.turned_in(d)), facing(*B.hull, B.turned_in(-d)));
  };
  const auto difference = [&](const auto& vertices) -> Vec3 {
    return B.vertex(vertices.second) - A.vertex(vertices.first);
  };
  const auto first = along_line(B.t - A.t);
  const Vec3 p = difference(first);
  const auto second = along_line(p);
  const Vec3 along = difference(second) - p;
  const double s = -p.dot(along) / along.squaredNorm();
  const auto between = [&](const Hull& hull, int v, int w) -> FeatureId {
    const int edge = s > 0 && s < 1 && v != w ? edge_between(hull, v, w) : -1;
    return edge >= 0 ? FeatureId{Kind::edge, edge} : FeatureId{Kind::vertex, s < 0.5 ? v : w};
  };
  return {between(*A.hull, first.first, second.first), between(*B.hull, first.second, second.second)};
}

}  // namespace touchstone::fast::lin_canny
