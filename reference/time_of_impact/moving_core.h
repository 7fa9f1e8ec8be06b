// The vertices of a convex core in ballistic motion.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "reference/exact/exact_pose.h"
#include "reference/motion/ballistic_motion.h"

namespace touchstone::reference {

/// A core at one time, relative to a point in W near both bodies, so that bodies far from W's origin keep narrow
/// intervals.
template <class Tier>
struct Snapshot {
  std::vector<Coordinates<typename Tier::E>> places, rates;  ///< positions and velocities of the vertices
  Coordinates<typename Tier::E> w;                           ///< angular velocity
  std::vector<Coordinates<typename Tier::P>> around;         ///< `places` to rounding
};

/// Twice the area of a polygon, as a vector along its outward normal. `corner(k)`: its k-th corner.
template <class T, class Corner>
Coordinates<T> twice_area(std::size_t corners, const Corner& corner) {
  Coordinates<T> sum = {T(0), T(0), T(0)};
  for (std::size_t k = 2; k < corners; ++k) {
    sum = sum + cross(Coordinates<T>(corner(k - 1) - corner(0)), Coordinates<T>(corner(k) - corner(0)));
  }
  return sum;
}

/// Call every member function inside the tier's scope.
template <class Tier>
class MovingCore {
 public:
  using E = typename Tier::E;
  using P = typename Tier::P;

  MovingCore(const Body& body, int part, const RigidBodyModel<Tier>& model)
      : model_(model), core_(core_of(body, part)) {
    const Motion X_BP = motion(part_pose(body, part));
    const Coordinates<E> offset = enclosed<E>(X_BP.translation) - model.centre();
    const Coordinates<E> x = enclosed<E>(X_BP.rows[0]), y = enclosed<E>(X_BP.rows[1]), z = enclosed<E>(X_BP.rows[2]);
    for (const Vec3& vertex : core_.vertices) {
      const Coordinates<E> v = {E(vertex.x()), E(vertex.y()), E(vertex.z())};
      arms_.push_back(Coordinates<E>{dot(x, v), dot(y, v), dot(z, v)} + offset);
      reach_ = greater(reach_, upper(length(arms_.back())));
    }
  }

  double radius() const { return core_.radius; }
  bool is_point() const { return core_.is_point(); }
  const std::vector<std::vector<int>>& faces() const { return *core_.faces; }
  const P& reach() const { return reach_; }  ///< greatest distance of a vertex from the reference point

  /// The body's state at `time`, relative to `from`.
  BallisticState<E> body_at(const E& time, const Coordinates<P>& from) const {
    BallisticState<E> body = model_.at(time);
    body.p = body.p - thin(from);
    return body;
  }

  Coordinates<E> vertex(const BallisticState<E>& body, int i) const { return body.p + turned(body.R, arm(i)); }

  Snapshot<Tier> at(const E& time, const Coordinates<P>& from) const {
    const BallisticState<E> body = body_at(time, from);
    Snapshot<Tier> now;
    now.w = body.w;
    for (const Coordinates<E>& arm : arms_) {
      const Coordinates<E> r = turned(body.R, arm);
      now.places.push_back(body.p + r);
      now.rates.push_back(body.v + cross(body.w, r));
      now.around.push_back(middle(now.places.back()));
    }
    return now;
  }

  /// For a polytope only: does it certainly contain the point?
  bool holds(const BallisticState<E>& body, const Coordinates<E>& point) const {
    const Coordinates<E> p = turned_back(body.R, point - body.p);
    return !is_point() && std::ranges::all_of(*core_.faces, [&](const std::vector<int>& face) {
      return upper(dot(outward(face), p - arm(face[0]))) <= 0;
    });
  }

  /// For a polytope only: approximately the middle of the part of the segment from p to q inside it, as a fraction of
  /// the segment; none if no part seems to be inside.
  std::optional<P> middle_within(const BallisticState<E>& body, const Coordinates<E>& p,
                                 const Coordinates<E>& q) const {
    const Coordinates<E> from = turned_back(body.R, p - body.p);
    const Coordinates<E> along = turned_back(body.R, q - p);
    P begin = 0, end = 1;
    for (const std::vector<int>& face : *core_.faces) {
      const Coordinates<E> n = outward(face);
      const P rise = middle(dot(n, along));
      const P room = middle(dot(n, arm(face[0]) - from));
      if (rise > 0) end = std::min(end, P(room / rise));
      if (rise < 0) begin = std::max(begin, P(room / rise));
    }
    if (is_point() || !(begin < end)) return std::nullopt;
    return P((begin + end) / 2);
  }

 private:
  const Coordinates<E>& arm(int vertex) const { return arms_[static_cast<std::size_t>(vertex)]; }

  /// Normal to the face; its length is twice the area.
  Coordinates<E> outward(const std::vector<int>& face) const {
    return twice_area<E>(face.size(), [&](std::size_t k) -> const Coordinates<E>& { return arm(face[k]); });
  }

  const RigidBodyModel<Tier>& model_;
  Core core_;
  std::vector<Coordinates<E>> arms_;  ///< of the vertices, from the reference point, in B
  P reach_ = 0;
};

}  // namespace touchstone::reference
