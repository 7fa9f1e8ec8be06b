#include "fast/time_of_impact/separation_query.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "fast/lin_canny/bracket.h"
#include "fast/lin_canny/parting_normals.h"
#include "fast/lin_canny/surround.h"
#include "fast/mark.h"
#include "fast/time_of_impact/capsule.h"
#include "fast/time_of_impact/common_point.h"
#include "fast/time_of_impact/exact_plane.h"
#include "model/infinity.h"

namespace touchstone::fast::time_of_impact {

using lin_canny::FeatureId;
using lin_canny::FeaturePair;
using lin_canny::Hull;
using lin_canny::Kind;
using lin_canny::PosedHull;

namespace {

/// The cores' gap along n, as computed, if it is above `least`. It is given up as soon as the vertices seen so far
/// leave no such gap: more vertices make it narrower, as computed too. Of the thousands of planes along two edges most
/// end so after a few vertices.
std::optional<double> gap_above(double least, const PosedHull& A, const PosedHull& B, const Vec3& n) {
  const auto a = A.hull->vertices(), b = B.hull->vertices();
  const Vec3 up_A = A.turned_in(n), up_B = B.turned_in(-n);
  const double apart = n.dot(B.t - A.t);
  double top_A = up_A.dot(a.front()), top_B = up_B.dot(b.front());
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    if (i < a.size()) top_A = std::max(top_A, up_A.dot(a[i]));
    if (i < b.size()) top_B = std::max(top_B, up_B.dot(b[i]));
    if (!(apart - top_A - top_B > least)) return std::nullopt;
  }
  return apart - top_A - top_B;
}

/// Finds the direction of greatest gap among several.
class Widest {
 public:
  Widest(const PosedHull& A, const PosedHull& B) : A_(A), B_(B) {}

  void ask(const Vec3& n) {
    if (n.isZero(0)) return;
    const std::optional<double> wider = gap_above(gap_, A_, B_, n);
    if (!wider) return;
    n_ = n;
    gap_ = *wider;
  }
  void ask_faces() {
    for (int f = 0; f < A_.hull->face_count(); ++f) ask(A_.turned_out(A_.hull->face(f).normal));
    for (int f = 0; f < B_.hull->face_count(); ++f) ask(-B_.turned_out(B_.hull->face(f).normal));
  }
  void ask_all() {
    mark(Mark::toi_all_normals);
    const auto ask_it = [&](const Vec3& from_B, const FeaturePair&) {
      ask(-from_B);
      return false;
    };
    lin_canny::any_parting_normal(A_, B_, ask_it);
  }
  bool has_one() const { return gap_ > -infinity; }
  double found_gap() const { return gap_; }
  const Vec3& direction() const { return n_; }

 private:
  const PosedHull& A_;
  const PosedHull& B_;
  Vec3 n_ = Vec3::UnitZ();
  double gap_ = -infinity;
};

/// Of x, what is perpendicular to the unit vector y.
Vec3 perpendicular(const Vec3& x, const Vec3& y) { return x - y.dot(x) * y; }

/// The edges of P, as vectors, both of whose ends are within `depth` of the highest vertex along `up`.
std::vector<Vec3> highest_edges(const PosedHull& P, const Vec3& up, double depth) {
  const Vec3 up_P = P.turned_in(up);
  double top = -infinity;
  for (const Vec3& x : P.hull->vertices()) top = std::max(top, up_P.dot(x));
  std::vector<Vec3> found;
  const auto is_high = [&](int vertex) { return up_P.dot(P.hull->vertex(vertex)) >= top - depth; };
  for (int i = 0; i < P.hull->edge_count(); ++i) {
    const Hull::Edge& edge = P.hull->edge(i);
    if (is_high(edge.tail) && is_high(edge.head)) found.push_back(P.edge_vector(i));
  }
  return found;
}

/// A vertex, or the middle of an edge, or of a face's first edge.
Vec3 point_of(const PosedHull& P, const FeatureId& feature) {
  if (feature.kind == Kind::vertex) return P.vertex(feature.index);
  const bool is_edge = feature.kind == Kind::edge;
  const Hull::Edge& edge = P.hull->edge(is_edge ? feature.index : P.hull->corners(P.hull->face(feature.index))[0].side);
  return (P.vertex(edge.tail) + P.vertex(edge.head)) / 2;
}

MovingCore inflated(MovingCore side, const Inflation& inflation, double t) {
  side.radius += inflation.at(t);
  side.slope_error += inflation.rate;
  return side;
}

/// Of the edges at a vertex, or the faces at an edge, the one that rises the most towards `up` (in P's frame), if it
/// can rise by more than `least` within the hull; else the feature itself.
FeatureId beyond(const Hull& P, const FeatureId& feature, const Vec3& up, double least) {
  if (feature.kind == Kind::vertex) {
    const int edge = lin_canny::steepest_edge(P, feature.index, up);
    const bool rises = edge >= 0 && std::abs(up.dot(P.along(P.edge(edge)))) > least;
    return rises ? FeatureId{Kind::edge, edge} : feature;
  }
  FeatureId steepest = feature;
  if (feature.kind == Kind::edge) {
    double most = least / (2 * P.radius());
    const Hull::Edge& edge = P.edge(feature.index);
    const auto ask = [&](int face, const Vec3& along) {
      const Vec3 inward = P.face(face).normal.cross(along);
      const double slope = up.dot(inward) / inward.norm();
      if (slope > most) {
        steepest = FeatureId{Kind::face, face};
        most = slope;
      }
    };
    ask(edge.face[0], P.along(edge));
    ask(edge.face[1], -P.along(edge));
  }
  return steepest;
}

/// Distances are right to rounding, and so directions to its square root: near an end of an edge the walk takes the end
/// for the closest point, and the far end of the edge may reach beyond the plane that is perpendicular to that
/// direction. So it goes on to an edge or a face that rises towards the other side, if that is as near within rounding.
/// A is asked again after B, whose step changes the direction.
void go_on_along_ties(const PosedHull& A, const PosedHull& B, lin_canny::Closest& closest) {
  const double rounding = lin_canny::rounding(A, B);
  for (const bool is_A : {true, false, true}) {
    const Vec3 n = lin_canny::separating_direction(A, B, closest);
    FeaturePair next = closest.features;
    FeatureId& feature = is_A ? next.a : next.b;
    const FeatureId before = feature;
    feature = is_A ? beyond(*A.hull, before, A.turned_in(n), 4 * rounding)
                   : beyond(*B.hull, before, B.turned_in(-n), 4 * rounding);
    if (feature == before) continue;
    lin_canny::Closest tied = lin_canny::closest(A, B, next);
    const double at_most = std::sqrt(closest.squared) + 2 * rounding;
    if (tied.below || tied.squared > at_most * at_most) continue;
    tied.features = next;  // also where its closest point is on its border
    closest = tied;
  }
}

lin_canny::Walked walked(const PosedHull& A, const PosedHull& B, FeaturePair& memory) {
  if (!fit_doubles(A, B)) throw std::range_error("lengths or paths beyond what doubles can multiply");
  lin_canny::Walked walked = lin_canny::walk(A, B, memory);
  if (walked.inside) return walked;
  go_on_along_ties(A, B, walked.closest);
  memory = walked.closest.features;
  return walked;
}

}  // namespace

motion::Origin origin(const motion::BallisticMotion& a, const motion::BallisticMotion& b) {
  const bool alike = a.since() == b.since() && a.acceleration() == b.acceleration();
  return {a.start().p_WB, alike ? a.acceleration() : Vec3::Zero()};
}

Vec3 Pair::in_W(const Vec3& p, double t) const {
  const double tau = t - a.since();
  return O.p_WO + O.a_WO * (tau * tau / 2) + p;
}

SeparationQuery::SeparationQuery(const Pair& pair, double t, FeaturePair& memory, const Vec3& known, Planes planes)
    : pair_(pair),
      t_(t),
      A_(inflated(moving_core(pair.a, pair.part_A, t, pair.O), pair.inflation, t)),
      B_(moving_core(pair.b, pair.part_B, t, pair.O)),
      walked_(walked(A_.core, B_.core, memory)),
      plane_(best_plane(memory, known, planes)) {}

double SeparationQuery::clear_until(const SeparatingPlane& plane, double h_max) const {
  double h = plane.clear_until(h_max);
  const auto however_turned = [&](const motion::BallisticMotion& motion, const Inflation& inflation, auto&& plane_of) {
    if (!(h < h_max && plane.gap() > motion.model().radius)) return;
    const SeparatingPlane far = plane_of(inflated(ball_around(motion, t_, pair_.O), inflation, t_));
    if (far.is_clear()) h = std::max(h, far.clear_until(h_max));  // a centre of mass outside its body may be nearer
  };
  const Vec3 &n = plane.direction(), at_rest = Vec3::Zero();
  const auto for_A = [&](const MovingCore& ball) { return SeparatingPlane(ball, B_, n, at_rest, ball.core.t); };
  const auto for_B = [&](const MovingCore& ball) { return SeparatingPlane(A_, ball, n, at_rest, ball.core.t); };
  however_turned(pair_.a, pair_.inflation, for_A);
  however_turned(pair_.b, Inflation{}, for_B);
  const auto however_spun = [&](const motion::BallisticMotion& motion, std::size_t part, const MovingCore& side,
                                auto&& plane_of) {
    if (!(h < h_max)) return;
    const std::optional<std::array<MovingCore, 2>> ends = capsule_about(motion, part, side);
    if (!ends) return;
    double both = h_max;
    for (const MovingCore& ball : *ends) {
      const SeparatingPlane beside = plane_of(ball);
      both = beside.is_clear() ? std::min(both, beside.clear_until(h_max)) : 0;
    }
    h = std::max(h, both);
  };
  however_spun(pair_.a, pair_.part_A, A_, for_A);
  however_spun(pair_.b, pair_.part_B, B_, for_B);
  return h;
}

/// How fast n = e × f / |e × f| rotates, with e an edge of A and f of B; none if they are parallel.
std::optional<Vec3> SeparationQuery::turn_with_edges(const Vec3& n, const Vec3& along_A, const Vec3& along_B) const {
  const Vec3 e = along_A.normalized(), f = along_B.normalized();
  const double crossing = n.dot(e.cross(f));
  if (std::abs(crossing) < lin_canny::least_crossing) return std::nullopt;
  return Vec3(perpendicular(A_.w.cross(e).cross(f) + e.cross(B_.w.cross(f)), n) / crossing);
}

/// How fast the direction n of the closest features rotates with them. It rotates with a face, or with an edge that
/// faces a vertex; with two edges e, f as their cross product does; with two points separated by their radii as their
/// difference does. Two vertices of polytopes define no direction that persists: none.
std::optional<Vec3> SeparationQuery::turn_of_features(const Vec3& n) const {
  const auto& [a, b] = walked_.closest.features;
  if (a.kind == Kind::face) return Vec3(A_.w.cross(n));
  if (b.kind == Kind::face) return Vec3(B_.w.cross(n));
  if (a.kind == Kind::edge && b.kind == Kind::edge) {
    return turn_with_edges(n, A_.core.edge_vector(a.index), B_.core.edge_vector(b.index));
  }
  if (a.kind == Kind::edge) return Vec3(A_.w.cross(n));
  if (b.kind == Kind::edge) return Vec3(B_.w.cross(n));
  if (!(A_.radius + B_.radius > 0)) return std::nullopt;
  const Vec3 at_a = walked_.closest.a - A_.core.t + A_.arm, at_b = walked_.closest.b - B_.core.t + B_.arm;
  const Vec3 apart = (B_.v + B_.w.cross(at_b)) - (A_.v + A_.w.cross(at_a));
  return Vec3(perpendicular(apart, n) / std::sqrt(walked_.closest.squared));
}

/// Where two edges are nearly parallel, their closest points are known badly, and their cross product may separate them
/// better than the difference of those.
Vec3 SeparationQuery::direction_of_features() const {
  if (walked_.inside) return Vec3::Zero();
  const Vec3 n = lin_canny::separating_direction(A_.core, B_.core, walked_.closest);
  const auto& [a, b] = walked_.closest.features;
  if (n.isZero(0) || a.kind != Kind::edge || b.kind != Kind::edge) return n;
  const Vec3 e = A_.core.edge_vector(a.index).normalized(), f = B_.core.edge_vector(b.index).normalized();
  const Vec3 crossed = e.cross(f);
  const double sine = crossed.norm();
  if (sine * sine > lin_canny::clearly_crossing || sine < lin_canny::least_crossing) return n;
  Widest widest(A_.core, B_.core);
  widest.ask(n);
  const Vec3 m = lin_canny::across_both(crossed / sine, e, f).normalized();
  widest.ask(n.dot(m) < 0 ? Vec3(-m) : m);
  return widest.direction();
}

/// Features that are apart define their direction well, though the radii may touch. If they are no farther apart than
/// rounding, they do not: the difference of two vertices is noise, the normal of two edges may have the wrong sign, and
/// inside there is none.
SeparatingPlane SeparationQuery::best_plane(const FeaturePair& before, const Vec3& known, Planes planes) const {
  const Vec3 n = direction_of_features();
  const Vec3 p_OC = walked_.inside ? A_.core.t : Vec3((walked_.closest.a + walked_.closest.b) / 2);
  if (!n.isZero(0)) {
    const std::optional<Vec3> turn = turn_of_features(n);
    SeparatingPlane plane(A_, B_, n, turn.value_or(Vec3::Zero()), p_OC);
    if (plane.gap() > plane.error()) return turn ? plane : longest_turned(plane, p_OC);
    const double distance = std::sqrt(walked_.closest.squared), beyond_radii = distance - (A_.radius + B_.radius);
    if (distance > 16 * plane.error() && plane.gap() > beyond_radii - 8 * plane.error()) return plane;
  }
  Widest widest(A_.core, B_.core);
  widest.ask(n);
  widest.ask(-n);
  widest.ask(known);
  if (walked_.inside) {
    const lin_canny::Closest last = lin_canny::closest(A_.core, B_.core, before);
    const Vec3 m = lin_canny::separating_direction(A_.core, B_.core, last);
    widest.ask(m);
    widest.ask(-m);
  }
  const double radii = A_.radius + B_.radius;
  const double rounding = 8 * lin_canny::rounding(A_.core, B_.core);
  if (!widest.has_one() || widest.found_gap() < radii - rounding) widest.ask_faces();
  // Nearly parallel faces: the walk may end at features that are not the closest. Then the plane between them is worse
  // than their distance says, and a normal of a face or of two edges separates the two.
  const double unseen = at_most() - std::max(0.0, widest.found_gap() - radii);
  if (planes == Planes::all && !walked_.inside &&
      (widest.found_gap() < -rounding || (widest.found_gap() < radii + rounding && unseen > rounding / 2))) {
    widest.ask_faces();
    widest.ask_all();
  }
  if (planes == Planes::likely) return {A_, B_, widest.direction(), Vec3::Zero(), p_OC};
  return best_turned(widest.direction(), p_OC);
}

/// Calls `accepts` with planes perpendicular to n that rotate: not at all, with A, with B, and with an edge of each in
/// the plane. One of them has the greatest least speed of all rotations (SeparatingPlane::least_speed), since the
/// speeds of a body's vertices in the plane are linear in their places. Stops at the first that is accepted.
template <class Accepts>
bool SeparationQuery::any_turned(const Vec3& n, const Vec3& p_OC, Accepts&& accepts) const {
  const auto turned = [&](const Vec3& turn) { return accepts(SeparatingPlane(A_, B_, n, turn, p_OC)); };
  if (turned(Vec3::Zero())) return true;
  if (A_.w.isZero(0) && B_.w.isZero(0)) return false;
  if (turned(A_.w.cross(n)) || turned(B_.w.cross(n))) return true;
  const double depth = 8 * lin_canny::rounding(A_.core, B_.core);
  const std::vector<Vec3> of_A = highest_edges(A_.core, n, depth), of_B = highest_edges(B_.core, -n, depth);
  return std::ranges::any_of(of_A, [&](const Vec3& e) {
    return std::ranges::any_of(of_B,
                               [&](const Vec3& f) { return turned(turn_with_edges(n, e, f).value_or(Vec3::Zero())); });
  });
}

/// Of the plane that does not rotate, that which rotates with A and that with B, the one that is clear for the longest
/// time.
SeparatingPlane SeparationQuery::longest_turned(const SeparatingPlane& plane, const Vec3& p_OC) const {
  SeparatingPlane best = plane;
  double longest = plane.clear_until(infinity);
  for (const MovingCore* side : {&A_, &B_}) {
    if (side->w.isZero(0)) continue;
    const SeparatingPlane other(A_, B_, plane.direction(), side->w.cross(plane.direction()), p_OC);
    const double until = other.clear_until(infinity);
    if (until > longest) best = other, longest = until;
  }
  return best;
}

SeparatingPlane SeparationQuery::best_turned(const Vec3& n, const Vec3& p_OC) const {
  std::optional<SeparatingPlane> best;
  double greatest = -infinity;
  any_turned(n, p_OC, [&](const SeparatingPlane& plane) {
    const double speed = plane.least_speed(8 * plane.error());
    if (!best || speed > greatest) best = plane, greatest = speed;
    return false;
  });
  return *best;
}

/// Any separating plane of two touching parts can be rotated, separating them all the while, to one along a face of
/// either or along an edge of each. So these are tried.
std::optional<SeparatingPlane> SeparationQuery::parting(bool at_start_poses) const {
  const PosedHull &A = A_.core, &B = B_.core;
  const double radii = A_.radius + B_.radius, rounding = lin_canny::rounding(A, B);
  std::optional<SeparatingPlane> found;
  const auto is_parting = [&](const Vec3& from_B, const FeaturePair& along) {
    const Vec3 n = -from_B;
    if (!gap_above(radii - 8 * rounding, A, B, n)) return false;
    const bool parts = any_turned(n, A.t, [&](const SeparatingPlane& plane) {
      if (!plane.parts()) return false;
      found = plane;
      return true;
    });
    return parts && (!at_start_poses ||
                     separates_exactly(pair_.A(), pair_.a.start(), pair_.B(), pair_.b.start(), along, from_B));
  };
  if (!lin_canny::any_parting_normal(A, B, is_parting)) return std::nullopt;
  return found;
}

double SeparationQuery::greatest_speed() const {
  const auto turning = [](const MovingCore& side) {
    return side.w.norm() * (side.arm.norm() + side.core.hull->radius());
  };
  return (B_.v - A_.v).norm() + turning(A_) + turning(B_);
}

double SeparationQuery::at_most() const {
  if (walked_.inside) return 2 * lin_canny::rounding(A_.core, B_.core);
  const double radii = A_.radius + B_.radius;
  return std::max(0.0, (lin_canny::bracket(A_.core, B_.core, walked_.closest).hi - radii) * (1 + 4 * u));
}

/// The proof is one of: two points of the cores are closer than the radii reach; an earlier closest point is inside the
/// other part; a tetrahedron of four differences contains 0; or a point is found that is inside both (for solids that
/// touch face to face). `error`: a point of a feature is on its body up to 10u of its radius (bracket.h), and it is
/// rotated there and back, which doubles the rounding.
bool SeparationQuery::overlap(const SeparationQuery& before) const {
  const PosedHull &A = A_.core, &B = B_.core;
  if (!walked_.inside) {
    const double cores = lin_canny::bracket(A, B, walked_.closest).hi;
    if (cores < (A_.radius + B_.radius) * (1 - 4 * u)) return true;
  }
  const double error = 2 * lin_canny::rounding(A, B);
  if (!before.walked_.inside) {
    const lin_canny::Closest& then = before.walked_.closest;
    if (is_inside(B, A.out(before.A_.core.in(then.a)), error)) return true;
    if (is_inside(A, B.out(before.B_.core.in(then.b)), error)) return true;
  }
  if (lin_canny::common_point(A, B)) return true;
  return share_a_point(A, B, error);
}

/// The plane's direction may be that of an earlier query.
Vec3 SeparationQuery::across() const {
  if (walked_.inside || !(A_.radius + B_.radius > 0)) return plane_.direction();
  const Vec3 n = lin_canny::separating_direction(A_.core, B_.core, walked_.closest);
  return n.isZero(0) ? plane_.direction() : n;
}

/// The closest points of the features, each moved outward by its radius along n. Inside, where no distance was
/// measured, a point of the lower-dimensional feature.
Vec3 SeparationQuery::middle() const {
  const Vec3 n = across();
  if (!walked_.inside) {
    const lin_canny::Bracket found = lin_canny::bracket(A_.core, B_.core, walked_.closest);
    return ((found.a + A_.radius * n) + (found.b - B_.radius * n)) / 2;
  }
  const auto& [a, b] = walked_.closest.features;
  return a.kind <= b.kind ? point_of(A_.core, a) : point_of(B_.core, b);
}

}  // namespace touchstone::fast::time_of_impact
