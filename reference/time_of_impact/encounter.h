// Two convex cores in ballistic motion, proved to be apart step by step until their first contact.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "model/answers.h"
#include "reference/time_of_impact/closest.h"
#include "reference/time_of_impact/common_face.h"
#include "reference/time_of_impact/initial_contact.h"
#include "reference/time_of_impact/moving_core.h"
#include "reference/time_of_impact/moving_plane.h"

namespace touchstone::reference {

/// The result of the search in one arithmetic.
template <class P>
struct Found {
  TimeOfImpact::Status status = TimeOfImpact::Status::undecided;
  P lo = 0;                                                    ///< proved apart before it
  P hi = 0;                                                    ///< hit: proved to share a point by then
  P gap = std::numeric_limits<P>::infinity();                  ///< at lo
  bool exhausted = false;                                      ///< undecided because the steps, not the digits, ran out
  Coordinates<P> nhat_BA = {1, 0, 0}, p_WCa = {}, p_WCb = {};  ///< at lo: of the cores, to rounding
};

/// Two convex parts, one of each body.
struct Parts {
  const Body& A;
  const Body& B;
  int a, b;
};

template <class Tier>
class Encounter {
 public:
  using E = typename Tier::E;
  using P = typename Tier::P;

  /// The cores count as swollen by their radii and by `apart`. Like all members, this opens the tier's scope itself.
  Encounter(const Parts& parts, const std::array<BallisticStart, 2>& starts, double apart,
            const typename Tier::Scope& /*meanwhile*/ = typename Tier::Scope())
      : model_A_(starts[0]),
        model_B_(starts[1]),
        A_(parts.A, parts.a, model_A_),
        B_(parts.B, parts.b, model_B_),
        r_(E(A_.radius()) + E(B_.radius()) + E(apart)),
        c_(model_A_.acceleration() - model_B_.acceleration()) {}
  Encounter(const Encounter&) = delete;
  Encounter& operator=(const Encounter&) = delete;

  /// Searches from a time at which the two are apart. A hit or a miss is proved.
  Found<P> search(const P& from, const P& end) const {
    Found<P> found;
    found.lo = from;
    std::optional<Closest<P>> contact;
    for (int i = 0; !found.exhausted; ++i) {
      found.exhausted = i == Tier::most_steps;
      const Pairing<Tier> now = pairing_at(found.lo);
      if (std::optional<Closest<P>> here = closest(now.A, now.B)) contact = std::move(here);
      const std::optional<P> next = contact ? step(now, *contact, found, end) : std::nullopt;
      if (!next) break;
      const bool resolved = *next - found.lo < P(Tier::resolution) * scale(*next, end);
      found.lo = *next;
      if (resolved && confirm_hit(Tier::probing, *contact, found, end)) break;
      if (found.lo == end) {
        found.status = TimeOfImpact::Status::miss;
        return found;
      }
    }
    if (contact && found.status == TimeOfImpact::Status::undecided)
      confirm_hit(Tier::last_probing, *contact, found, end);
    if (contact) describe(*contact, found);
    return found;
  }

  /// Do the two move by more than 2^-41 of all lengths within a hit's enclosure? This happens if they are very slender,
  /// so that doubles give poor planes, and fast.
  bool is_loose(const Found<P>& hit) const {
    const typename Tier::Scope scope;
    const E time = thin(hit.lo);
    const BallisticState<E> a = model_A_.at(time), b = model_B_.at(time);
    const E reach_A = thin(A_.reach()), reach_B = thin(B_.reach());
    const E speed = length(a.v - b.v) + length(a.w) * reach_A + length(b.w) * reach_B;
    const E lengths = length(a.p - b.p) + reach_A + reach_B;
    return !(upper(E((thin(hit.hi) - time) * speed)) <= upper(E(lengths * E(0x1p-41))));
  }

  /// For contact that separates (reference/time_of_impact/initial_contact.h): a time until which the two are proved to
  /// be apart, by a plane that turns with one of the bodies or with two edges that cross. None if no such plane proves
  /// it.
  std::optional<P> leave(const InitialContact& initial, const P& from, const P& end) const {
    const Pairing<Tier> now = pairing_at(from);
    for (const MovingPlane<E>& plane : leaving_planes(now, initial)) {
      const Clearance<Tier> clearance(now, plane, support(now, initial));
      const std::optional<P> h = clearance.about(end - from);
      const P next = h ? P(from + *h / 2) : from;
      if (next > from && clearance.positive(from, next)) return next;
    }
    return std::nullopt;
  }

 private:
  /// The tier's resolution is a fraction of this.
  static P scale(const P& t, const P& end) { return std::max(t, P((end - t) * P(0x1p-20))); }

  Pairing<Tier> pairing_at(const P& t) const {
    const typename Tier::Scope scope;
    const E time = thin(t);
    const Coordinates<P> from = middle(model_B_.at(time).p);
    const E K = model_A_.turning() * thin(A_.reach()) + model_B_.turning() * thin(B_.reach());
    return {A_.at(time, from), B_.at(time, from), from, c_, r_, K};
  }

  Support<Tier> support(const Pairing<Tier>& now, const InitialContact& initial) const {
    const typename Tier::Scope scope;
    return {enclosed<E>(initial.x) - thin(now.from), enclosed<E>(initial.y) - thin(now.from), initial.on_A,
            initial.on_B};
  }

  std::vector<MovingPlane<E>> leaving_planes(const Pairing<Tier>& now, const InitialContact& initial) const {
    const typename Tier::Scope scope;
    const Coordinates<E> n = enclosed<E>(initial.n);
    std::vector<MovingPlane<E>> planes = {{n, cross(now.A.w, n)}, {n, cross(now.B.w, n)}};
    const auto members = [](const std::vector<bool>& on) {
      std::vector<std::size_t> ends;
      for (std::size_t i = 0; i < on.size(); ++i) {
        if (on[i]) ends.push_back(i);
      }
      return ends;
    };
    const std::vector<std::size_t> a = members(initial.on_A), b = members(initial.on_B);
    if (a.size() == 2 && b.size() == 2) {  // n = λ e × f
      const Coordinates<E> e = now.A.places[a[1]] - now.A.places[a[0]], f = now.B.places[b[1]] - now.B.places[b[0]];
      const Coordinates<E> rise = cross(cross(now.A.w, e), f) + cross(e, cross(now.B.w, f));
      const Coordinates<E> across = cross(e, f);
      planes.push_back({n, E(dot(n, across) / dot(across, across)) * rise});
    }
    return planes;
  }

  /// The next time until which a moving plane proves them apart.
  std::optional<P> step(const Pairing<Tier>& now, const Closest<P>& contact, Found<P>& found, const P& end) const {
    const std::optional<MovingPlane<P>> plane = plane_between(contact, now.A, now.B);
    if (!plane) return std::nullopt;
    found.nhat_BA = plane->n;
    const Clearance<Tier> clearance(now, {thin(plane->n), thin(plane->m)});
    const P span = end - found.lo;
    const std::optional<P> h = clearance.about(span);
    if (!h) return std::nullopt;
    if (*h == span && clearance.positive(found.lo, end)) return end;
    for (const double part : {1 - 0x1p-20, 1 - 0x1p-4, 0.5}) {
      const P next = std::min(end, P(found.lo + P(part) * *h));
      if (!(next > found.lo)) return std::nullopt;
      if (clearance.positive(found.lo, next)) return next;
    }
    return std::nullopt;
  }

  struct Bodies {
    Coordinates<P> from;
    BallisticState<E> A, B;  ///< relative to `from`
  };

  /// Call inside the scope.
  Bodies bodies_at(const P& t) const {
    const E time = thin(t);
    const Coordinates<P> from = middle(model_B_.at(time).p);
    return {from, A_.body_at(time, from), B_.body_at(time, from)};
  }

  struct Witnesses {
    Bodies bodies;
    Coordinates<E> x, y;  ///< certainly points of cores A and B; relative to `bodies.from`
  };

  /// The present positions of the points that were closest. Call inside the scope.
  Witnesses witnesses(const Closest<P>& contact, const P& t) const {
    Witnesses w{bodies_at(t), {}, {}};
    E total = E(0);
    w.x = w.y = {E(0), E(0), E(0)};
    for (std::size_t i = 0; i < contact.pairs.size(); ++i) {
      const E weight = thin(contact.weights[i]);
      w.x = w.x + weight * A_.vertex(w.bodies.A, contact.pairs[i].first);
      w.y = w.y + weight * B_.vertex(w.bodies.B, contact.pairs[i].second);
      total += weight;
    }
    const E share = E(1) / total;
    w.x = share * w.x;
    w.y = share * w.y;
    return w;
  }

  static std::vector<int> members(const Closest<P>& contact, int VertexPair::*side) {
    std::vector<int> vertices;
    for (const VertexPair& pair : contact.pairs) vertices.push_back(pair.*side);
    std::ranges::sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
  }

  /// Is a vertex of one core, or a point of one of its edges, in the other core?
  static bool reaches_into(const MovingCore<Tier>& one, const BallisticState<E>& body_one,
                           const std::vector<int>& feature, const MovingCore<Tier>& other,
                           const BallisticState<E>& body_other) {
    const Coordinates<E> p = one.vertex(body_one, feature[0]);
    if (feature.size() == 1) return other.holds(body_other, p);
    if (feature.size() > 2) return false;
    const Coordinates<E> q = one.vertex(body_one, feature[1]);
    const std::optional<P> part = other.middle_within(body_other, p, q);
    return part && other.holds(body_other, p + thin(*part) * (q - p));
  }

  bool share_a_point(const Closest<P>& contact, const P& t) const {
    const typename Tier::Scope scope;
    const Witnesses w = witnesses(contact, t);
    const Coordinates<E> apart = w.x - w.y;
    if (upper(E(dot(apart, apart) - r_ * r_)) <= 0) return true;
    const Bodies& now = w.bodies;
    return reaches_into(A_, now.A, members(contact, &VertexPair::first), B_, now.B) ||
           reaches_into(B_, now.B, members(contact, &VertexPair::second), A_, now.A);
  }

  /// The middle of what parallel faces of the two cores have in common at lo; empty if there are none. The closest
  /// points of such faces may be anywhere in it, also at its border, where no enclosure tells inside from outside.
  WeightedVertices<P> middle_of_face(const Found<P>& found) const {
    if (A_.is_point() || B_.is_point()) return {};
    const Pairing<Tier> at_lo = pairing_at(found.lo);
    return middle_of_common_face(A_.faces(), at_lo.A.around, B_.faces(), at_lo.B.around, found.nhat_BA);
  }

  bool enters(const WeightedVertices<P>& of_A, const P& t) const {
    if (of_A.empty()) return false;
    const typename Tier::Scope scope;
    const Bodies bodies = bodies_at(t);
    Coordinates<E> sum = {E(0), E(0), E(0)};
    E total = E(0);
    for (const auto& [vertex, weight] : of_A) {
      sum = sum + thin(weight) * A_.vertex(bodies.A, vertex);
      total += thin(weight);
    }
    return B_.holds(bodies.B, E(E(1) / total) * sum);
  }

  bool confirm_hit(const Probing& probing, const Closest<P>& contact, Found<P>& found, const P& end) const {
    const WeightedVertices<P> of_A = probing.tries > 0 ? middle_of_face(found) : WeightedVertices<P>();
    P d = P(probing.first) * scale(found.lo, end);
    for (int i = 0; i < probing.tries; ++i, d *= P(probing.factor)) {
      const P t = std::min(end, P(found.lo + d));
      if (!share_a_point(contact, t) && !enters(of_A, t)) continue;
      found.status = TimeOfImpact::Status::hit;
      found.hi = t;
      return true;
    }
    return false;
  }

  /// Sets gap and witness points at lo.
  void describe(const Closest<P>& contact, Found<P>& found) const {
    const typename Tier::Scope scope;
    const Witnesses w = witnesses(contact, found.lo);
    found.gap = std::max(P(0), upper(E(length(w.x - w.y) - r_)));
    found.p_WCa = middle(w.x) + w.bodies.from;
    found.p_WCb = middle(w.y) + w.bodies.from;
  }

  const RigidBodyModel<Tier> model_A_, model_B_;
  const MovingCore<Tier> A_, B_;
  const E r_;
  const Coordinates<E> c_;
};

}  // namespace touchstone::reference
