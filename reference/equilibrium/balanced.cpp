#include <algorithm>
#include <cmath>
#include <utility>

#include "reference/equilibrium/loads.h"
#include "reference/exact/dense.h"

namespace touchstone::reference {
namespace {

/// A power of two below the distance of P from its cone's surface, with friction reduced by `inwards`; 0 outside.
mpq_class room(const Vec3& P, const LoadedBodies::Point& point, double inwards) {
  const Vec3 n = point.nhat_BA_W.normalized();
  const double along = P.dot(n), inside = point.friction * along - (1 - inwards) * (P - along * n).norm();
  return along > 0 && inside > 0 ? mpq_class(std::ldexp(1.0, std::ilogb(std::min(along, inside)))) : mpq_class(0);
}

/// P with less friction.
Triple moved_in(const Vec3& P, const LoadedBodies::Point& point, double inwards) {
  const Triple exact = triple(P), N = triple(point.nhat_BA_W);
  const Triple across = minus(exact, scaled(mpq_class(dot(exact, N) / dot(N, N)), N));
  return minus(exact, scaled(mpq_class(inwards), across));
}

/// The arm of a body at one of its points.
Triple arm(const LoadedBodies::Point& point, int body) {
  return triple(body == point.a ? point.arm_A_W : point.arm_B_W);
}

/// A tree of bodies in which each is held by the points of one pair.
class Tree {
 public:
  Tree(const LoadedBodies& bodies, const std::vector<Vec3>& P, double inwards) : bodies_(bodies) {
    for (std::size_t k = 0; k < P.size(); ++k) {
      room_.push_back(room(P[k], bodies.points[k], inwards));
      forces_.push_back(moved_in(P[k], bodies.points[k], inwards));
    }
  }

  std::optional<std::vector<Triple>> forces() {
    if (!grow()) return std::nullopt;
    std::vector<ExactLoad> left = left_of(bodies_, forces_);
    for (auto branch = branches_.rbegin(); branch != branches_.rend(); ++branch) hand_down(*branch, left);
    return std::move(forces_);
  }

 private:
  struct Branch {
    int child, parent;
    std::vector<std::size_t> points;
  };

  /// Σ w Gᵀ G: the wrench on the body, about its centre of mass, by δP = w (z_v + z_ω × arm), as a matrix of z.
  RationalMatrix stiffness(const Branch& branch) const {
    RationalMatrix sum(6, RationalVector(6));
    for (std::size_t column = 0; column < 6; ++column) {
      Triple z_v, z_w;
      (column < 3 ? z_v[column] : z_w[column - 3]) = 1;
      for (const std::size_t k : branch.points) {
        ExactLoad load;
        const Triple at = arm(bodies_.points[k], branch.child);
        load.add(scaled(room_[k], plus(z_v, cross(z_w, at))), at);
        for (std::size_t i = 0; i < 3; ++i) {
          sum[i][column] += load.force[i];
          sum[i + 3][column] += load.torque[i];
        }
      }
    }
    return sum;
  }

  Branch branch(int child, int parent) const {
    Branch between{child, parent, {}};
    for (std::size_t k = 0; k < bodies_.points.size(); ++k) {
      const auto& [a, b] = std::pair(bodies_.points[k].a, bodies_.points[k].b);
      if (sgn(room_[k]) > 0 && ((a == child && b == parent) || (a == parent && b == child)))
        between.points.push_back(k);
    }
    return between;
  }

  /// From the fixed bodies outwards.
  bool grow() {
    std::vector<bool> held;
    std::vector<int> reached;
    for (std::size_t i = 0; i < bodies_.loads.size(); ++i) {
      held.push_back(!bodies_.loads[i]);
      if (held[i]) reached.push_back(static_cast<int>(i));
    }
    for (std::size_t next = 0; next < reached.size(); ++next) {
      for (std::size_t k = 0; k < bodies_.points.size(); ++k) {
        const LoadedBodies::Point& point = bodies_.points[k];
        const int parent = reached[next];
        if (point.a != parent && point.b != parent) continue;
        const int child = point.a == parent ? point.b : point.a;
        if (held[index(child)]) continue;
        Branch found = branch(child, parent);
        if (!solution(stiffness(found), RationalVector(6))) continue;
        held[index(child)] = true;
        reached.push_back(child);
        branches_.push_back(std::move(found));
      }
    }
    return reached.size() == bodies_.loads.size();
  }

  void hand_down(const Branch& branch, std::vector<ExactLoad>& left) {
    const ExactLoad& load = left[index(branch.child)];
    RationalVector wanted;
    for (const Triple& part : {load.force, load.torque}) {
      for (const mpq_class& each : part) wanted.emplace_back(-each);
    }
    const RationalVector z = solution(stiffness(branch), wanted).value();
    for (const std::size_t k : branch.points) {
      const LoadedBodies::Point& point = bodies_.points[k];
      const Triple at = arm(point, branch.child);
      const Triple on_child = scaled(room_[k], plus(Triple{z[0], z[1], z[2]}, cross(Triple{z[3], z[4], z[5]}, at)));
      const Triple on_A = point.a == branch.child ? on_child : scaled(mpq_class(-1), on_child);
      forces_[k] = plus(forces_[k], on_A);
      left[index(branch.child)].add(on_child, at);
      left[index(branch.parent)].add(scaled(mpq_class(-1), on_child), arm(point, branch.parent));
    }
  }

  const LoadedBodies& bodies_;
  std::vector<mpq_class> room_;
  std::vector<Triple> forces_;
  std::vector<Branch> branches_;
};

}  // namespace

std::optional<std::vector<ExactVec3>> balanced(const LoadedBodies& bodies, const std::vector<Vec3>& P_A_W,
                                               double inwards) {
  const auto forces = Tree(bodies, P_A_W, inwards).forces();
  if (!forces) return std::nullopt;
  std::vector<ExactVec3> exact;
  for (const Triple& P : *forces) exact.push_back(exact_vec(P));
  return exact;
}

}  // namespace touchstone::reference
