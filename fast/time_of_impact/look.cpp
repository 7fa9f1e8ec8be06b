#include "fast/time_of_impact/look.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "fast/lin_canny/bracket.h"
#include "fast/lin_canny/parting_normals.h"
#include "fast/lin_canny/surround.h"
#include "fast/time_of_impact/common_middle.h"

namespace touchstone::fast::meeting {

using lin_canny::FeaturePair;
using lin_canny::Hull;
using lin_canny::Placed;

namespace {

double highest(const Hull& hull, const Vec3& up) {
  double most = up.dot(hull.vertex(0));
  for (const Vec3& v : hull.vertices()) most = std::max(most, up.dot(v));
  return most;
}

/// The cores' gap along n, as computed.
double gap(const Placed& A, const Placed& B, const Vec3& n) {
  return n.dot(B.t - A.t) - highest(*A.hull, A.turned_in(n)) - highest(*B.hull, B.turned_in(-n));
}

/// Of several directions the one along which the gap is widest.
class Widest {
 public:
  Widest(const Placed& A, const Placed& B) : A_(A), B_(B) {}

  void ask(const Vec3& n) {
    if (n.isZero(0)) return;
    const double wide = gap(A_, B_, n);
    if (has_one_ && !(wide > gap_)) return;
    n_ = n;
    gap_ = wide;
    has_one_ = true;
  }
  void ask_faces() {
    for (int f = 0; f < A_.hull->face_count(); ++f) ask(A_.turned_out(A_.hull->face(f).normal));
    for (int f = 0; f < B_.hull->face_count(); ++f) ask(-B_.turned_out(B_.hull->face(f).normal));
  }
  void ask_all() {
    lin_canny::any_parting_normal(A_, B_, [&](const Vec3& from_B) {
      ask(-from_B);
      return false;
    });
  }
  bool has_one() const { return has_one_; }
  double found_gap() const { return gap_; }
  const Vec3& direction() const { return n_; }

 private:
  const Placed& A_;
  const Placed& B_;
  Vec3 n_ = Vec3::UnitZ();
  double gap_ = 0;
  bool has_one_ = false;
};

/// A vertex, or the middle of an edge, or of a face's first edge.
Vec3 point_of(const Placed& P, const lin_canny::FeatureId& feature) {
  if (feature.kind == lin_canny::Kind::vertex) return P.vertex(feature.index);
  const bool is_edge = feature.kind == lin_canny::Kind::edge;
  const Hull::Edge& edge =
      P.hull->edge(is_edge ? feature.index : P.hull->side(P.hull->face(feature.index).first_corner));
  return (P.vertex(edge.tail) + P.vertex(edge.head)) / 2;
}

bool fit_doubles(const Placed& A, const Placed& B) {
  return A.hull->fits_doubles() && B.hull->fits_doubles() && (B.t - A.t).lpNorm<Eigen::Infinity>() < 0x1p250;
}

Side swollen(Side side, const Swelling& swelling, double t) {
  side.radius += swelling.at(t);
  side.slope_error += swelling.rate;
  return side;
}

lin_canny::Walked walked(const Placed& A, const Placed& B, FeaturePair& memory) {
  if (!fit_doubles(A, B)) throw std::range_error("lengths or paths beyond what doubles can multiply");
  const lin_canny::Walked walked = lin_canny::walk(A, B, memory);
  if (!walked.inside) memory = walked.closest.features;
  return walked;
}

}  // namespace

motion::Origin origin(const motion::Flight& a, const motion::Flight& b) {
  const bool alike = a.since() == b.since() && a.acceleration() == b.acceleration();
  return {a.start().p_WB, alike ? a.acceleration() : Vec3::Zero()};
}

Vec3 Pair::in_W(const Vec3& p, double t) const {
  const double tau = t - a.since();
  return O.p_WO + O.a_WO * (tau * tau / 2) + p;
}

Look::Look(const Pair& pair, double t, FeaturePair& memory, const Vec3& known)
    : pair_(pair),
      t_(t),
      A_(swollen(side(pair.a, pair.part_A, t, pair.O), pair.swelling, t)),
      B_(side(pair.b, pair.part_B, t, pair.O)),
      walked_(walked(A_.core, B_.core, memory)),
      slab_(best_slab(memory, known)) {}

double Look::clear_until(const Slab& slab, double h_max) const {
  double h = slab.clear_until(h_max);
  const auto however_turned = [&](const motion::Flight& flight, const Swelling& swelling, auto&& slab_of) {
    if (h < h_max && slab.gap() > flight.flyer().radius) {
      h = std::max(h, slab_of(swollen(ball_around(flight, t_, pair_.O), swelling, t_)).clear_until(h_max));
    }
  };
  const Vec3 &n = slab.direction(), at_rest = Vec3::Zero();
  however_turned(pair_.a, pair_.swelling, [&](const Side& ball) { return Slab(ball, B_, n, at_rest, ball.core.t); });
  however_turned(pair_.b, Swelling{}, [&](const Side& ball) { return Slab(A_, ball, n, at_rest, ball.core.t); });
  return h;
}

/// How fast the direction n, which the closest features name, turns with them: with a face, or an edge that a vertex
/// faces; with two edges e, f as their product does; with two points that stay apart by their radii as their difference
/// does. Two vertices of polytopes have no direction that would stay so: none.
Vec3 Look::turn_of_features(const Vec3& n) const {
  using lin_canny::Kind;
  const auto& [a, b] = walked_.closest.features;
  if (a.kind == Kind::face) return A_.w.cross(n);
  if (b.kind == Kind::face) return B_.w.cross(n);
  const auto across_n = [&](const Vec3& x) { return Vec3(x - n.dot(x) * n); };
  if (a.kind == Kind::edge && b.kind == Kind::edge) {
    const Vec3 e = A_.core.turned_out(A_.core.hull->edge(a.index).along).normalized();
    const Vec3 f = B_.core.turned_out(B_.core.hull->edge(b.index).along).normalized();
    const double crossing = n.dot(e.cross(f));
    if (std::abs(crossing) < 0x1p-5) return Vec3::Zero();
    return across_n(A_.w.cross(e).cross(f) + e.cross(B_.w.cross(f))) / crossing;
  }
  if (a.kind == Kind::edge) return A_.w.cross(n);
  if (b.kind == Kind::edge) return B_.w.cross(n);
  if (!(A_.radius + B_.radius > 0)) return Vec3::Zero();
  const Vec3 at_a = walked_.closest.a - A_.core.t + A_.arm, at_b = walked_.closest.b - B_.core.t + B_.arm;
  return across_n((B_.v + B_.w.cross(at_b)) - (A_.v + A_.w.cross(at_a))) / std::sqrt(walked_.closest.squared);
}

/// Features that are apart name their direction well. Where they are no further apart than rounding tells, they do not:
/// two vertices' difference is noise, two edges' normal may have the wrong sign, and inside there is none.
Slab Look::best_slab(const FeaturePair& before, const Vec3& known) const {
  const Vec3 n =
      walked_.inside ? Vec3(Vec3::Zero()) : lin_canny::separating_direction(A_.core, B_.core, walked_.closest);
  const Vec3 p_OC = walked_.inside ? A_.core.t : Vec3((walked_.closest.a + walked_.closest.b) / 2);
  if (!n.isZero(0)) {
    Slab slab(A_, B_, n, turn_of_features(n), p_OC);
    if (slab.gap() > slab.error()) return slab;
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
  // Faces that are all but parallel: the walk may end at features that are not the closest, and edges part the two.
  if (!walked_.inside && widest.found_gap() < -rounding) widest.ask_all();
  return {A_, B_, widest.direction(), Vec3::Zero(), p_OC};
}

/// The planes between two that touch are turned from one to the next between those along a face of either, or along two
/// edges.
std::optional<Slab> Look::parting() const {
  const Placed &A = A_.core, &B = B_.core;
  const double radii = A_.radius + B_.radius, rounding = lin_canny::rounding(A, B);
  std::optional<Slab> found;
  lin_canny::any_parting_normal(A, B, [&](const Vec3& from_B) {
    const Vec3 n = -from_B;
    if (!(gap(A, B, n) > radii - 8 * rounding)) return false;
    const Slab slab(A_, B_, n, Vec3::Zero(), A.t);
    if (slab.parts()) found = slab;
    return found.has_value();
  });
  return found;
}

double Look::greatest_speed() const {
  const auto turning = [](const Side& side) { return side.w.norm() * (side.arm.norm() + side.core.hull->radius()); };
  return (B_.v - A_.v).norm() + turning(A_) + turning(B_);
}

double Look::at_most() const {
  if (walked_.inside) return 2 * lin_canny::rounding(A_.core, B_.core);
  const double radii = A_.radius + B_.radius;
  return std::max(0.0, (lin_canny::bracket(A_.core, B_.core, walked_.closest).hi - radii) * (1 + 4 * u));
}

/// Two points of the cores are nearer than the radii reach; or what was closest before is inside the other; or four
/// differences have 0 inside; or a point is found that is inside both: for solids that meet flat. `error`: a point of a
/// feature is on its body up to 10u of its radius (bracket.h), and is turned there and back: the rounding again.
bool Look::overlap(const Look& before) const {
  const Placed &A = A_.core, &B = B_.core;
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
  return share_a_middle(A, B, error);
}

/// The slab's direction may be one that was good a moment ago.
Vec3 Look::across() const {
  if (walked_.inside || !(A_.radius + B_.radius > 0)) return slab_.direction();
  const Vec3 n = lin_canny::separating_direction(A_.core, B_.core, walked_.closest);
  return n.isZero(0) ? slab_.direction() : n;
}

/// Of the features' closest points, each moved out by its radius along n. Inside, where nothing was measured, the point
/// of the lesser feature.
Vec3 Look::middle() const {
  const Vec3 n = across();
  if (!walked_.inside) {
    const lin_canny::Bracket found = lin_canny::bracket(A_.core, B_.core, walked_.closest);
    return ((found.a + A_.radius * n) + (found.b - B_.radius * n)) / 2;
  }
  const auto& [a, b] = walked_.closest.features;
  return a.kind <= b.kind ? point_of(A_.core, a) : point_of(B_.core, b);
}

}  // namespace touchstone::fast::meeting
