// Linear systems in the twists of all bodies that contacts connect, sparse as the contact graph.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "fast/contact/row.h"

namespace touchstone::fast::contact {

/// Solves H x = b for H = s M + Σ GᵢᵀWᵢGᵢ over all contacts, where M is the mass matrix of the bodies that move, Gᵢ
/// takes their twists to the relative velocity uᵢ at contact i, and Wᵢ is a matrix of the contact (N s per m/s).
///
/// A vector has six numbers for each body that moves: a twist (v, w), or a wrench (impulse, angular impulse about the
/// centre of mass). H does not become singular where a face has more contacts than it needs, as the matrix that couples
/// contacts does. Its 6 × 6 blocks are eliminated in the order of least degree in the graph of bodies
/// (Tinney & Walker 1967), so stacks have no fill. Rows are exchanged within blocks only.
class TwistSystem {
 public:
  using Vector = Eigen::VectorXd;

  /// Refers to both, which must outlive it. A body whose inverse mass is 0 does not move.
  TwistSystem(const std::vector<ContactRow>& rows, const std::vector<Mobility>& bodies);

  /// Computes the factors of H. `stiffness`: W, one matrix a contact.
  void factor(double mass_share, const std::vector<Mat3>& stiffness);
  /// Requires that `factor` has been called.
  Vector solve(Vector b) const;

  Vector zero() const { return Vector::Zero(6 * static_cast<Eigen::Index>(body_of_.size())); }
  /// M x and M⁻¹ x.
  Vector momentum(const Vector& twists) const;
  Vector response(const Vector& wrenches) const;
  /// Gᵢ x: u at a contact, with bodies that do not move at rest.
  Vec3 relative_velocity(std::size_t contact, const Vector& twists) const;
  /// Adds GᵢᵀP.
  void add_impulse(std::size_t contact, const Vec3& P, Vector& wrenches) const;
  /// The greatest speed of a point at the end of a contact's arm, as a bound: |v| + |w| times the body's longest arm.
  double greatest_speed(const Vector& twists) const;

  /// The twists of the bodies that move, and their return.
  Vector moving(const std::vector<Twist>& twists) const;
  void store(const Vector& moving, std::vector<Twist>& twists) const;

 private:
  using Block = Eigen::Matrix<double, 6, 6>;
  using Segment = Eigen::Matrix<double, 6, 1>;
  static constexpr int fixed = -1;

  /// A block on the diagonal and its factors with the exchanges of rows. Rows of impulses are compared with rows of
  /// angular impulses over `reach` (m), so that the unit of length changes no bit.
  struct Pivot {
    Block block = Block::Zero();
    int exchanged[6] = {};
    void factor(double reach);
    void solve(double* column) const;
  };

  int slot(int body) const { return slot_[index(body)]; }
  void order(std::vector<std::vector<int>> neighbours);
  std::size_t entry(int earlier, int later) const;

  const std::vector<ContactRow>& rows_;
  const std::vector<Mobility>& bodies_;
  std::vector<int> slot_;     ///< of each body: its place in the order of elimination, or `fixed`
  std::vector<int> body_of_;  ///< of each place
  std::vector<double> reach_;
  std::vector<Mat3> inertia_;
  std::vector<std::size_t> first_;  ///< of each place: where its entries begin
  std::vector<int> later_;          ///< of each entry: the later place that is connected with it
  std::vector<Pivot> pivots_;
  std::vector<Block> below_, above_;  ///< of each entry: the blocks (later, earlier) and (earlier, later)
};

}  // namespace touchstone::fast::contact
